// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files: what they name, what is meant by a name that is not known,
// and how settings reach nested sections.
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/json_value.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/text_lines.h>
#include <lumbricus/materials/material_law.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/json_parameters.h>
#include <lumbricus/parameters/parameter_entry.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/parameters/pattern_words.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/prm_scanner.h>
#include <lumbricus/parameters/registration.h>
#include <lumbricus/parameters/registry.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "read_plugin.h"

using namespace lumbricus;

namespace
{
  /** A parameter owner with sections two deep, and a choice. */
  class Owner : public ParameterOwner
  {
  public:
    Owner()
      : law("Law", "Neo-Hooke", "The law.")
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Title", title);
      prm.enter_subsection("Outer part");
      prm.add_parameter("Number", number, "", PositiveNumber());
      prm.enter_subsection("Inner");
      prm.add_parameter("Number", inner_number);
      law.declare_parameters(prm);
      prm.leave_subsection();
      prm.leave_subsection();
    }

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      prm.enter_subsection("Outer part");
      prm.enter_subsection("Inner");
      const bool extended = law.extend_parameters(prm, extent);
      prm.leave_subsection();
      prm.leave_subsection();
      return extended;
    }

    void
    check_parameters() const override
    {
      within_section("Outer part", [&]() {
        AssertThrow(number < 100, ExcParameter("Number", "is too large."));
      });
    }

    std::string         title;
    double              number       = 1.;
    unsigned int        inner_number = 2;
    Choice<MaterialLaw> law;
  };

  /** An owner after some settings. */
  std::unique_ptr<Owner>
  after(const std::vector<std::string> &settings)
  {
    ParameterFile file;
    for (const std::string &setting : settings)
      file.set(setting);
    auto owner = std::make_unique<Owner>();
    file.parse(*owner);
    return owner;
  }

  std::string
  error_after(const std::vector<std::string> &settings)
  {
    return input_error([&]() { after(settings); });
  }
} // namespace



namespace
{
  /** An interface, and two classes of the same name for users. */
  struct Sound
  {
    virtual ~Sound() = default;
  };
  struct Bark : public Sound
  {};
  struct Rind : public Sound
  {};
} // namespace



TEST(Registry, TwoOfTheSameNameAreNamedBoth)
{
  // All that this program is linked with.
  const std::size_t n = registrations().size();
  EXPECT_GT(n, 20u);
  EXPECT_EQ(clash_of_names(registrations()), "");

  const Register<Sound, Bark> bark("bark", "of a dog");
  const Register<Sound, Bark> wave("wave", "as an activation is called");
  EXPECT_EQ(clash_of_names(registrations()), "");

  const Register<Sound, Rind> rind("bark", "of a tree");
  ASSERT_EQ(registrations().size(), n + 3);
  const std::string clash = clash_of_names(registrations());
  EXPECT_TRUE(contains(clash, "the name 'bark' is that of two classes of "))
    << clash;
  EXPECT_TRUE(contains(clash, "Sound: ")) << clash;
  EXPECT_TRUE(contains(clash, "Bark in '")) << clash;
  EXPECT_TRUE(contains(clash, " and ")) << clash;
  EXPECT_TRUE(contains(clash, "Rind in '")) << clash;
  // The first keeps it.
  const auto first = Registry<Sound>::create("bark");
  EXPECT_NE(dynamic_cast<Bark *>(first.get()), nullptr);
}



TEST(ParameterFile, ReadsAPartAhead)
{
  class Part : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Number", number, "", PositiveNumber());
    }

    double number = 1.;
  };

  ParameterFile file;
  Part          part;
  file.read_ahead(part);
  EXPECT_EQ(part.number, 1.);
  for (const char *setting : {"Other/Number=7", "Number=2", "Unknown=x"})
    file.set(setting);
  file.read_ahead(part);
  EXPECT_EQ(part.number, 2.);
  file.set("Number=-1");
  EXPECT_TRUE(contains(input_error([&]() { file.read_ahead(part); }),
                       "'Number' is '-1', but has to be a number > 0"));
}



TEST(PrmScanner, FindsEntriesAndSectionsWithTheirLines)
{
  const auto                 lines    = scan_prm("# a comment\n"
                                                 "set Title = a = b # and more\n"
                                                 "\n"
                                                 "subsection Outer part\n"
                                                 "  set Number=3\n"
                                                 "  SUBSECTION Inner\n"
                                                 "    SET Number\t = 4\n"
                                                 "  END\n"
                                                 "  set After = 5\n"
                                                 "end\n"
                                                 "set Last =\n");
  const std::vector<PrmLine> expected = {{2, "Title", false},
                                         {4, "Outer part", true},
                                         {5, "Outer part/Number", false},
                                         {6, "Outer part/Inner", true},
                                         {7, "Outer part/Inner/Number", false},
                                         {9, "Outer part/After", false},
                                         {11, "Last", false}};
  ASSERT_EQ(lines.size(), expected.size());
  for (unsigned int i = 0; i < lines.size(); ++i)
    {
      EXPECT_EQ(lines[i].number, expected[i].number);
      EXPECT_EQ(lines[i].path, expected[i].path);
      EXPECT_EQ(lines[i].is_section, expected[i].is_section);
    }
}



TEST(PrmScanner, LinesThatGoOnAreValuesWhateverTheySay)
{
  const auto lines = scan_prm("set List = 1, \\\n"
                              "set this = 2, \\\n"
                              "end\n"
                              "set Next = 1\n");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].path, "List");
  EXPECT_EQ(lines[0].number, 1u);
  EXPECT_EQ(lines[1].path, "Next");
  EXPECT_EQ(lines[1].number, 4u);
}



TEST(PrmScanner, SurvivesTooManyEnds)
{
  const auto lines = scan_prm("end\nend\nset A = 1\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].path, "A");
}



TEST(PrmScanner, SplitsPaths)
{
  EXPECT_EQ(split_path("Outer part/Inner/Number"),
            (std::vector<std::string>{"Outer part", "Inner", "Number"}));
  EXPECT_EQ(split_path("Title"), (std::vector<std::string>{"Title"}));
  EXPECT_EQ(split_path(" Outer part / Number "),
            (std::vector<std::string>{"Outer part", "Number"}));
}



TEST(PrmScanner, NearestIsWhatWasMeant)
{
  const std::vector<std::string> names = {"Radius",
                                          "Segment length",
                                          "Wall layers",
                                          "End"};
  EXPECT_EQ(nearest("Radios", names), "Radius");
  EXPECT_EQ(nearest("radius", names), "Radius");
  EXPECT_EQ(nearest("Segment lenght", names), "Segment length");
  EXPECT_EQ(nearest("Wall layer", names), "Wall layers");
  EXPECT_EQ(nearest("Ende", names), "End");
  EXPECT_EQ(nearest("Gravity", names), "");
  EXPECT_EQ(nearest("Radius", {}), "");
  // The nearer of two.
  EXPECT_EQ(nearest("Time", {"Tile", "Times", "time"}), "time");
}



TEST(PrmScanner, FindsTheFirstMistake)
{
  EXPECT_EQ(first_mistake("").line, 0u);
  EXPECT_EQ(first_mistake("# a comment\n\n  set A = b = c # d\n"
                          "SUBSECTION B\n\tset\tC = 1, \\\n  2\nEND\n"
                          "set D =\n")
              .line,
            0u);

  const std::vector<std::array<std::string, 3>> cases = {
    {{"set A = 1\nB = 2\n", "2", "'B = 2' is none"}},
    {{"set A\n", "1", "'set A' has no '='"}},
    {{"set\n", "1", "'set' is none"}},
    {{"set = 1\n", "1", "'set = 1' has no name"}},
    {{"set A/B = 1\n", "1", "has a '/' in its name"}},
    {{"set A = 1/B\nset\n", "2", "'set' is none"}},
    {{"subsection A/B\nend\n", "1", "has a '/' in its name"}},
    {{"set A = \\\n 1\nend\n", "3", "'end' without a 'subsection'"}},
    {{"subsection A\nend now\n", "2", "'end now' is none"}},
    {{"subsection A\n  subsection B\n  end\n", "1", "'subsection A' has no"}},
    {{"subsection A\n  subsection B\n", "2", "'subsection B' has no"}}};
  for (const auto &[text, line, what] : cases)
    {
      const PrmMistake mistake = first_mistake(text);
      EXPECT_EQ(std::to_string(mistake.line), line) << text;
      EXPECT_TRUE(contains(mistake.what, what)) << mistake.what;
    }
}



TEST(PrmScanner, SaysWhatNoLineCanHold)
{
  EXPECT_EQ(unfit_for_a_line("a = b, \\c"), "");
  EXPECT_TRUE(contains(unfit_for_a_line("case #1"), "comment"));
  EXPECT_TRUE(contains(unfit_for_a_line("a\nb"), "line break"));
  EXPECT_TRUE(contains(unfit_for_a_line("a\\"), "goes on"));
}



TEST(PatternWords, SayWhatIsAllowed)
{
  namespace Patterns = dealii::Patterns;
  const auto words   = [](const Patterns::PatternBase &pattern) {
    return pattern_in_words(pattern.description());
  };
  EXPECT_EQ(words(PositiveNumber()), "a number > 0");
  EXPECT_EQ(words(Patterns::Double()), "a number");
  EXPECT_EQ(words(Patterns::Double(0, 0.5)), "a number from 0 to 0.5");
  EXPECT_EQ(words(Patterns::Double(-1)), "a number, at least -1");
  EXPECT_EQ(words(Patterns::Integer()), "a whole number");
  EXPECT_EQ(words(Patterns::Integer(1)), "a whole number, at least 1");
  EXPECT_EQ(words(Patterns::Integer(1, 9)), "a whole number from 1 to 9");
  EXPECT_EQ(words(Patterns::Bool()), "true or false");
  EXPECT_EQ(words(Patterns::Selection("a b|c|")), "one of 'a b', 'c'");
  EXPECT_EQ(words(Patterns::MultipleSelection("x|y")),
            "a list out of 'x', 'y'");
  EXPECT_EQ(words(Patterns::List(PositiveNumber(), 3, 3)),
            "a list of 3 entries, each a number > 0");
  EXPECT_EQ(words(Patterns::List(Patterns::Integer(1), 1, 4)),
            "a list of 1 to 4 entries, each a whole number, at least 1");
  EXPECT_EQ(words(Patterns::List(Name())),
            "a list of entries, each a name, without '/'");
  EXPECT_EQ(words(Patterns::List(Name(), 2)),
            "a list of at least 2 entries, each a name, without '/'");
  EXPECT_EQ(words(Patterns::Map(Name(), Name())),
            "a list of entries 'name: value'");
  EXPECT_EQ(words(Patterns::Anything()), "[Anything]");
}



TEST(ParameterFile, SettingsReachNestedSectionsAndTheLastWins)
{
  const auto owner = after({"Title=a = b",
                            "Outer part/Number=2.5",
                            "Outer part/Inner/Number = 7",
                            "Outer part/Number=3",
                            "Outer part/Inner/Neo-Hooke/a=4"});
  EXPECT_EQ(owner->title, "a = b");
  EXPECT_EQ(owner->number, 3.);
  EXPECT_EQ(owner->inner_number, 7u);
  EXPECT_EQ(owner->law->shear_modulus(), 4.);
}



TEST(ParameterFile, ChoicesOpenTheirSections)
{
  const auto owner = after({"Outer part/Inner/Mooney-Rivlin/a=4",
                            "Outer part/Inner/Mooney-Rivlin/b=5",
                            "Outer part/Inner/Law=Mooney-Rivlin"});
  EXPECT_EQ(owner->law->shear_modulus(), 9.);

  const std::string message =
    error_after({"Outer part/Inner/Mooney-Rivlin/a=4"});
  EXPECT_TRUE(contains(message, "'Outer part/Inner/Law' is 'Neo-Hooke'"))
    << message;
  EXPECT_TRUE(contains(message, "Choose 'Mooney-Rivlin' there")) << message;
}



TEST(ParameterFile, ErrorsNameTheWholePath)
{
  const std::vector<std::array<std::string, 3>> cases = {
    {{"Outer part/Inner/Numbr=1",
      "'Outer part/Inner/Numbr' is unknown",
      "Did you mean 'Outer part/Inner/Number'?"}},
    {{"Outer part/Iner/Number=1",
      "'Outer part/Iner' is unknown",
      "Did you mean 'Outer part/Inner'?"}},
    {{"Outer part/Inner/Number=x",
      "'Outer part/Inner/Number' is 'x'",
      "a whole number"}},
    {{"Outer part/Number=-1", "'Outer part/Number' is '-1'", "a number > 0"}},
    {{"Outer part/Number=", "'Outer part/Number' is ''", "a number > 0"}},
    {{"Outer part/Number=101", "'Outer part/Number' is too large", ""}},
    {{"Outer part/Inner/Law=rubber",
      "'Outer part/Inner/Law' is 'rubber'",
      "'Mooney-Rivlin', 'Neo-Hooke'"}},
    {{"Title", "'Title'", "Section/Name=value"}}};
  for (const auto &[setting, what, way_out] : cases)
    {
      const std::string message = error_after({setting});
      EXPECT_TRUE(contains(message, what)) << message;
      EXPECT_TRUE(contains(message, way_out)) << message;
    }
}



TEST(ParameterFile, ResolvedParametersHaveTheValuesOfTheRun)
{
  ParameterFile file;
  file.set("Outer part/Inner/Number=9");
  Owner owner;
  file.parse(owner);
  std::ostringstream out;
  file.print_resolved(out);
  EXPECT_TRUE(contains(out.str(), "set Number = 9")) << out.str();
  EXPECT_FALSE(contains(out.str(), "Mooney-Rivlin/")) << out.str();

  // Other values where they are asked for, which the run does not get.
  std::ostringstream other;
  file.print_resolved(other,
                      {{"Outer part/Inner/Number", "=8"}, {"None", "1"}});
  EXPECT_TRUE(contains(other.str(), "set Number = =8")) << other.str();
  EXPECT_EQ(other.str().size(), out.str().size() + 1);
  EXPECT_EQ(file.entries({{"Title", "x"}}).front().value, "x");
  EXPECT_EQ(file.entries().front().value, "");

  // The reference has all there is.
  Owner              fresh;
  std::ostringstream all;
  ParameterFile::print_reference(fresh, all);
  EXPECT_TRUE(contains(all.str(), "subsection Mooney-Rivlin")) << all.str();
}



TEST(ParameterEntry, HasUnitAndMeaning)
{
  dealii::ParameterHandler prm;
  prm.enter_subsection("M&M, 1.5");
  prm.declare_entry("a b",
                    "2",
                    dealii::Patterns::Double(),
                    "[N/mm^2] Modulus [at rest].");
  prm.declare_entry("c", "", dealii::Patterns::Anything(), "No [unit].");
  prm.set("a b", "3");
  prm.leave_subsection();
  const auto entries = entries_of(prm);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].path, "M&M, 1.5/a b");
  EXPECT_EQ(entries[0].value, "3");
  EXPECT_EQ(entries[0].default_value, "2");
  EXPECT_EQ(entries[0].unit, "N/mm^2");
  EXPECT_EQ(entries[0].meaning, "Modulus [at rest].");
  EXPECT_EQ(entries[1].unit, "");
  EXPECT_EQ(entries[1].meaning, "No [unit].");
}



TEST(JsonValue, IsWrittenAsJson)
{
  JsonValue all = JsonValue::object();
  all.add("a/b", "\"\\ ² \n\x01")
    .add("null", JsonValue())
    .add("yes", true)
    .add("whole", -3)
    .add("number", 0.1)
    .add("tiny", 1e-300)
    .add("nan", std::numeric_limits<double>::quiet_NaN())
    .add("texts", std::vector<std::string>{"x", "y/"})
    .add("none", JsonValue::array());
  std::ostringstream flat;
  all.write(flat);
  EXPECT_EQ(flat.str(),
            R"({"a/b": "\"\\ ² \n?", "null": null, "yes": true, )"
            R"("whole": -3, "number": 0.1, "tiny": 1e-300, "nan": null, )"
            R"("texts": ["x", "y/"], "none": []})");

  std::ostringstream nested;
  JsonValue::object()
    .add("one", 1)
    .add("list", JsonValue::array().append(JsonValue::object().add("b", "c")))
    .write(nested);
  EXPECT_EQ(nested.str(),
            "{\n  \"one\": 1,\n  \"list\": [\n    {\"b\": \"c\"}\n"
            "  ]\n}");
}



TEST(JsonParameters, AreThoseOfAParameterFile)
{
  std::istringstream json(R"({"Title": "a = b",
    "Outer part": {"Number": 2.5,
                   "Inner": {"Number": 7, "Law": "Mooney-Rivlin"}},
    "A list": ["x", 1, true]})");
  EXPECT_EQ(prm_from_json("case.json", json),
            "set Title = a = b\n"
            "subsection Outer part\n"
            "set Number = 2.5\n"
            "subsection Inner\n"
            "set Number = 7\n"
            "set Law = Mooney-Rivlin\n"
            "end\n"
            "end\n"
            "set A list = x, 1, true\n");
}



TEST(JsonParameters, WhatIsWrongIsSaidWithTheFile)
{
  const std::vector<std::array<std::string, 2>> cases = {
    {{"{\"Title\": 1,\n oops}", "case.json, line 2: this is no JSON"}},
    {{"[1, 2]", "has to be one object"}},
    {{"3", "has to be one object"}},
    {{"{\"Points\": [[0, 0, 0]]}", "the list 'Points'"}},
    {{"{\"A\": 1, \"A\": 2}", "the name 'A' is there twice"}},
    {{"{\"A/B\": 1}", "'A/B' is no name"}},
    {{"{\"A\": \"#1\"}", "'#1' has a '#'"}}};
  for (const auto &[text, words] : cases)
    {
      std::istringstream in(text);
      const std::string  message =
        input_error([&]() { prm_from_json("case.json", in); });
      EXPECT_TRUE(contains(message, words)) << message;
    }
}



TEST(Text, LinesEndInAnyWay)
{
  std::istringstream in("\xEF\xBB\xBF"
                        "a\nb\r\nc\rd\r\r\n\ne");
  EXPECT_EQ(text_of(in), "a\nb\nc\nd\n\n\ne\n");

  std::istringstream       last("a\r\rb");
  std::vector<std::string> lines;
  for (std::string line; read_line(last, line);)
    lines.push_back(line);
  EXPECT_EQ(lines, (std::vector<std::string>{"a", "", "b"}));

  std::istringstream empty("");
  EXPECT_EQ(text_of(empty), "");
}



// std::strtod() took "0x10", "nan" and "inf", streams took "1.5abc" for 1.5.
TEST(Text, NumbersAreDecimalNumbers)
{
  const std::vector<std::pair<std::string, double>> right = {{"0", 0.},
                                                             {"-1.5e3", -1500.},
                                                             {"+.5", 0.5},
                                                             {"2.", 2.},
                                                             {"1E-3", 1e-3},
                                                             {"1e-400", 0.}};
  for (const auto &[word, value] : right)
    {
      double number = -7.;
      EXPECT_TRUE(read_number(word, number)) << word;
      EXPECT_EQ(number, value) << word;
    }
  for (const std::string wrong :
       {"", " 1", "1 ", "nan", "inf", "-inf", "infinity", "0x10", "1e", "1e+",
        "1.5abc", "1,5", "1d3", "1e999", "--1", "."})
    {
      double number;
      EXPECT_FALSE(read_number(wrong, number)) << wrong;
    }

  long long integer = 0;
  EXPECT_TRUE(read_number("-12", integer));
  EXPECT_EQ(integer, -12);
  for (const std::string wrong :
       {"", "1.0", "1e3", "0x1", " 1", "1 ", "99999999999999999999"})
    EXPECT_FALSE(read_number(wrong, integer)) << wrong;
}



TEST(Expression, HasNoChance)
{
  for (const std::string formula :
       {"rand()", "2*rand_seed(3)", "x + (rand ())", "rand"})
    {
      const std::string message =
        input_error([&]() { Expression("A/b", formula); });
      EXPECT_TRUE(contains(message, "it has 'rand")) << message;
      EXPECT_TRUE(contains(message, "'A/b'")) << message;
    }
  // Names that only begin like it.
  EXPECT_EQ(Expression("A/b", "2*grand + rand2", {{"grand", 3.}, {"rand2", 1.}})
              .value({}, 0.),
            7.);
}
