// SPDX-License-Identifier: LGPL-2.1-or-later
// What users may write: names, text, how much of it, and what a setting leaves
// unused. Each of these crashed, took all memory, or was passed over in
// silence.
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/names.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/materials/material_law.h>
#include <lumbricus/parameters/json_parameters.h>
#include <lumbricus/parameters/named_sections.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/prm_scanner.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "read_plugin.h"

using namespace lumbricus;

namespace
{
  /** A part of an owner, with a number. */
  class Part : public ParameterOwner
  {
  public:
    explicit Part(const std::string & /*name*/)
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Number", number);
    }

    double number = 1.;
  };

  /** An owner with a text, a number, a choice and sections of its user's. */
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
      prm.add_parameter("Number", number, "", PositiveNumber());
      prm.add_parameter("Parts", names, "", NameList());
      law.declare_parameters(prm);
    }

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      const bool more = parts.extend_parameters(prm, extent, names, "<part>");
      return law.extend_parameters(prm, extent) || more;
    }

    std::string              title;
    double                   number = 1.;
    std::vector<std::string> names;
    NamedSections<Part>      parts;
    Choice<MaterialLaw>      law;
  };

  /** A file of this text, for as long as the object lives; every rank has its
   * own. */
  class File
  {
  public:
    explicit File(const std::string &text)
      : name("user_input_" +
             std::to_string(
               dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
             ".prm")
    {
      std::ofstream(name) << text;
    }

    ~File()
    {
      std::remove(name.c_str());
    }

    const std::string name;
  };

  /** The owner after a file of this text and some settings. */
  std::unique_ptr<Owner>
  after(const std::string              &text,
        const std::vector<std::string> &settings,
        std::vector<std::string>       &unused)
  {
    const File    file(text);
    ParameterFile parameters;
    parameters.read(file.name);
    for (const std::string &setting : settings)
      parameters.set(setting);
    auto owner = std::make_unique<Owner>();
    parameters.parse(*owner);
    unused = parameters.unused();
    return owner;
  }

  std::string
  error_after(const std::string &text, const std::vector<std::string> &settings)
  {
    return input_error([&]() {
      std::vector<std::string> unused;
      after(text, settings, unused);
    });
  }
} // namespace



TEST(UserText, KnowsUtf8)
{
  for (const std::string text :
       {"", "flesh", "L\xC3\xA4ngsmuskel", "\xE7\xAD\x8B", "\xF0\x9F\xAA\xB1"})
    EXPECT_TRUE(is_utf8(text)) << text;
  for (const std::string text :
       {"L\xE4ngsmuskel",           // Latin-1
        "\xC3",                     // cut
        "\xE7\xAD",                 // cut
        "\xC0\xAF",                 // overlong
        "\xE0\x80\xAF",             // overlong
        "\xF0\x80\x80\xAF",         // overlong
        "\xED\xA0\x80",             // a surrogate
        "\xEF\xBF\xBF",             // no character
        "\xF4\x90\x80\x80",         // beyond the last
        "\xF8\x88\x80\x80\x80",     // five bytes
        "\x80"})
    EXPECT_FALSE(is_utf8(text));
}



TEST(UserText, NumbersAreDecimals)
{
  const std::vector<std::pair<std::string, double>> numbers = {
    {"5", 5.}, {"+5", 5.}, {"5.", 5.}, {"-.5e1", -5.}, {"1E3", 1000.}};
  for (const auto &[text, expected] : numbers)
    {
      double value = 0.;
      EXPECT_TRUE(read_number(text, value)) << text;
      EXPECT_EQ(value, expected);
    }
  double value = 0.;
  for (const std::string text :
       {"", " 5", "5 ", "5 6", "0x10", "nan", "inf", "1e400", "1d3", "1e",
        "e", "+", "--5", "5.0.0", "{5}", "1,5"})
    EXPECT_FALSE(read_number(text, value)) << text;
}



TEST(UserText, MessagesAreShortAndPrintable)
{
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc... (4 characters)");
  // Not in the middle of a character.
  EXPECT_EQ(shortened("ab\xC3\xA4", 3), "ab... (4 characters)");

  EXPECT_EQ(printable("a\nb", 10), "a\nb");
  EXPECT_EQ(printable("a\033[2J\xE4", 10), "a?[2J?");
  const std::string message = printable(std::string(5000, 'a') + " end", 100);
  EXPECT_LE(message.size(), 100u);
  EXPECT_GT(message.size(), 90u);
  EXPECT_TRUE(contains(message, " ... a")) << message;
  EXPECT_TRUE(contains(message, "a end")) << message;
  std::string umlauts;
  for (unsigned int i = 0; i < 500; ++i)
    umlauts += "\xC3\xA4";
  for (unsigned int most = 50; most < 60; ++most)
    {
      EXPECT_LE(printable(umlauts, most).size(), most);
      EXPECT_FALSE(contains(printable(umlauts, most), "?"));
    }
}



TEST(Names, AreThoseThatFilesCanHold)
{
  for (const std::string name :
       {"M&M", "a<b", "tibialis \"anterior\"", "it's", "50% power",
        "fibre:left", "L\xC3\xA4ngsmuskel", "left arm", "{a}", "a|b", "a;b",
        "value", "end"})
    EXPECT_EQ(unfit_name(name), "") << name;

  const std::vector<std::pair<std::string, std::string>> cases = {
    {"", "is empty"},
    {"a/b", "'/', which separates sections"},
    {"a=b", "'=', which ends"},
    {"a,b", "comma, which separates names"},
    {"a#b", "'#', which starts a comment"},
    {"a\\", "'\\' at its end"},
    {" a", "blank at its end"},
    {"a ", "blank at its end"},
    {"a\nb", "control character"},
    {"a\tb", "control character"},
    {"a\x7F", "control character"},
    {"L\xE4ngsmuskel", "UTF-8"},
    {"alias", "keep for themselves"},
    {std::string(101, 'a'), "longer than 100"}};
  for (const auto &[name, what] : cases)
    EXPECT_TRUE(contains(unfit_name(name), what)) << name << unfit_name(name);
}



TEST(Names, AreRefusedWithTheReason)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"a, b/c", "each a name, without '/': 'b/c' has a '/', which"},
    {"a=b", "'a=b' has a '='"},
    {"a,, b", "'' is empty"},
    {"alias", "'alias' is a word"},
    {"Number", "'Number' cannot be a name of yours"},
    {"Law", "'Law' cannot be a name of yours"}};
  for (const auto &[names, words] : cases)
    {
      const std::string message = error_after("set Parts = " + names, {});
      EXPECT_TRUE(contains(message, words)) << message;
    }

  // deal.II's own words for the nodes of its tree.
  for (const std::string name :
       {"value", "default_value", "documentation", "pattern", "actions"})
    {
      std::vector<std::string> unused;
      const auto               owner = after("set Parts = a, " + name +
                                 "\nsubsection " + name +
                                 "\nset Number = 7\nend",
                               {},
                               unused);
      EXPECT_EQ(owner->parts[1].number, 7.) << name;
    }

  std::string many = "set Parts = a0";
  for (unsigned int i = 1; i <= InputLimits::names; ++i)
    many += ", a" + std::to_string(i);
  const std::string message = error_after(many, {});
  EXPECT_TRUE(contains(message, "at most 1000 entries")) << message;
}



// deal.II's ParameterHandler::parse_input() neither checks values with braces
// nor hands them on: a run with 'End = {2}' went on to the default end.
TEST(ParameterFile, BracesInValuesAreNotPassedOver)
{
  for (const std::string value : {"{2}", "{ 1 | 2 }", "{{1|2}}", "2{", "}"})
    {
      const std::string in_file = error_after("set Number = " + value, {});
      const std::string setting =
        error_after("set Title = x", {"Number=" + value});
      for (const std::string &message : {in_file, setting})
        {
          EXPECT_TRUE(contains(message, "'Number' is '" + value + "'"))
            << message;
          EXPECT_TRUE(contains(message, "a number > 0")) << message;
        }
    }
  EXPECT_TRUE(contains(error_after("set Number = {2}", {}),
                       "Braces have no meaning here"));

  // A text is what it is.
  std::vector<std::string> unused;
  EXPECT_EQ(after("set Title = a {b}", {}, unused)->title, "a {b}");
}



// A value with more than some ten thousand letters ended in std::regex, by its
// recursion; messages quoted all of it.
TEST(ParameterFile, LongValuesAreQuotedByTheirBeginning)
{
  const std::string message =
    error_after("set Number = " + std::string(90000, 'x'), {});
  EXPECT_TRUE(contains(message, "x... (90000 characters)', but has to be"))
    << message.substr(0, 1000);
  EXPECT_LT(message.size(), 400u);
}



TEST(InputLimits, AreKept)
{
  const auto repeat = [](const std::string &text, const unsigned int n) {
    std::string all;
    for (unsigned int i = 0; i < n; ++i)
      all += text;
    return all;
  };
  const auto what = [](const std::string &text) {
    return first_mistake(text).what;
  };
  EXPECT_EQ(what(repeat("subsection a\n", 64) + repeat("end\n", 64)), "");
  EXPECT_TRUE(
    contains(what(repeat("subsection a\n", 100000)), "more than 64 sections"));
  EXPECT_TRUE(contains(what("set A = " + std::string(100001, 'a')),
                       "longer than the 100000"));
  EXPECT_TRUE(contains(what("set A = " + repeat("\\\n" + repeat("a", 100), 2000)),
                       "longer than the 100000"));
  EXPECT_TRUE(contains(what("set " + std::string(101, 'a') + " = 1"),
                       "name of more than 100"));
  EXPECT_TRUE(contains(what("set A = \xE4"), "not in UTF-8"));
  EXPECT_EQ(what("# \xE4\nset A = 1 # \xE4"), "");

  // Boost's parser ended by its recursion.
  for (const auto &[open, close] :
       {std::pair<std::string, std::string>{"{\"a\":", "}"},
        std::pair<std::string, std::string>{"[", "]"}})
    {
      std::istringstream in(repeat(open, 10000) + "1" + repeat(close, 10000));
      const std::string  message =
        input_error([&]() { prm_from_json("case.json", in); });
      EXPECT_TRUE(contains(message, "more than 64 objects and lists"))
        << message;
    }
  std::istringstream brackets("{\"Title\": \"" + repeat("[{\\\"", 1000) +
                              "\"}");
  EXPECT_NO_THROW(prm_from_json("case.json", brackets));
}



TEST(JsonParameters, ListsInTextAndControlCharactersAreRefused)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
    {R"({"A": ["a, b", "c"]})", "'a, b' in it, which is a list itself"},
    {R"({"A": ["0; 1"]})", "'0; 1' in it"},
    {R"({"A": "\u0001"})", "has a control character"},
    {R"({"A": "\u0000b"})", "has a control character"}};
  for (const auto &[text, words] : cases)
    {
      std::istringstream in(text);
      const std::string  message =
        input_error([&]() { prm_from_json("case.json", in); });
      EXPECT_TRUE(contains(message, words)) << message;
    }
}



// A choice could not be changed over a resolved file, which has the section of
// the choice it was made with.
TEST(ParameterFile, SettingsLeaveSectionsOfTheFileUnused)
{
  const std::string file = "set Parts = a, b\n"
                           "subsection Neo-Hooke\n"
                           "  set a = 3\n"
                           "end\n"
                           "subsection a\n"
                           "  set Number = 5\n"
                           "end\n"
                           "subsection b\n"
                           "  set Number = 7\n"
                           "end\n";

  std::vector<std::string> unused;
  const auto               as_it_is = after(file, {}, unused);
  EXPECT_TRUE(unused.empty());
  EXPECT_EQ(as_it_is->parts[1].number, 7.);

  const auto other =
    after(file, {"Law=Mooney-Rivlin", "Mooney-Rivlin/a=4"}, unused);
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_TRUE(contains(unused[0], "'Neo-Hooke' in ")) << unused[0];
  EXPECT_TRUE(contains(unused[0], ".prm, line 2")) << unused[0];
  EXPECT_EQ(other->law.chosen_name(), "Mooney-Rivlin");

  // The same for names that are no longer listed.
  const auto fewer = after(file, {"Parts=b"}, unused);
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_TRUE(contains(unused[0], "'a' in ")) << unused[0];
  EXPECT_EQ(fewer->parts.size(), 1u);
  EXPECT_EQ(fewer->parts[0].number, 7.);

  // What the file alone would not use stays a mistake, and so does a setting
  // that is not used.
  const std::vector<std::pair<std::string, std::string>> mistakes = {
    {file + "subsection Hooke\nend\n", "section 'Hooke' is not used"},
    {file + "subsection c\nend\n", "section 'c' is unknown"},
    {file + "subsection Neo-Hooke\nset c = 1\nend\n", "'Neo-Hooke/c'"},
    {file + "subsection Neo-Hooke\nset a = x\nend\n", "'Neo-Hooke/a' is 'x'"}};
  for (const auto &[text, words] : mistakes)
    {
      const std::string message = error_after(text, {"Law=Mooney-Rivlin"});
      EXPECT_TRUE(contains(message, words)) << message;
    }
  const std::string message =
    error_after(file, {"Law=Mooney-Rivlin", "Neo-Hooke/a=1"});
  EXPECT_TRUE(contains(message, "section 'Neo-Hooke' is not used")) << message;
  const std::string typo =
    error_after("subsection Mooney-Rivlin\nend\n", {"Number=2"});
  EXPECT_TRUE(contains(typo, "section 'Mooney-Rivlin' is not used")) << typo;
}
