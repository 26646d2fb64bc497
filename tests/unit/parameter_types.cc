// SPDX-License-Identifier: LGPL-2.1-or-later
// What parameters are made of besides numbers: formulas, sections with names of
// the user's, and a section around any owner.
#include <lumbricus/core/dimension.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/load_time.h>
#include <lumbricus/parameters/named_list.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/parameters/section.h>
#include <lumbricus/parameters/vector_expression.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "read_plugin.h"

using namespace lumbricus;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** A load of a user's name. */
  class Load : public ParameterOwner
  {
  public:
    explicit Load(const std::string &name)
      : name(name)
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      traction.declare_parameter(prm, "Three formulas.");
      prm.add_parameter("Number", number);
    }

    void
    check_parameters() const override
    {
      AssertThrow(number < 100, ExcParameter("Number", "is too large."));
    }

    const std::string name;
    VectorExpression  traction = {"Traction", "0; 0; 0"};
    int               number   = 1;
  };

  /** Loads, and a formula beside their sections. */
  class Loads : public NamedList<Load>
  {
  public:
    Loads()
      : NamedList("Names", "<load>", "All there are.")
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      NamedList::declare_parameters(prm);
      factor.declare_parameter(prm, "A formula.");
    }

    Expression factor = {"Factor", "2*k", {{"k", 3.}}};
  };

  class Root : public Section<Loads>
  {
  public:
    Root()
      : Section("Loads")
    {}
  };

  const Point<dim> A(1., 2., 3.);

  void
  read(Root &root, const std::vector<std::string> &settings)
  {
    ParameterFile file;
    for (const std::string &setting : settings)
      file.set(setting);
    file.parse(root);
  }

  std::string
  message_after(const std::vector<std::string> &settings)
  {
    return input_error([&]() {
      Root root;
      read(root, settings);
    });
  }
} // namespace



TEST(ParameterTypes, IsWhatItsParameterIsSetTo)
{
  Root root;
  EXPECT_EQ(root.factor.value(A, 0.), 6.);
  read(root,
       {"Loads/Names=first, second",
        "Loads/Factor=k*x + t",
        "Loads/first/Traction=y; 2*t; -1"});
  EXPECT_EQ(root.factor.value(A, 0.5), 3.5);
  EXPECT_EQ(root.factor.with({{"k", 5.}}).value(A, 0.5), 5.5);
  EXPECT_EQ(root.factor.parameter(), "Factor");
  EXPECT_EQ(root.factor.formula(), "k*x + t");

  ASSERT_EQ(root.size(), 2u);
  EXPECT_EQ(root[0].name, "first");
  EXPECT_EQ((root[0].traction.value(A, 4.) - Tensor<1, dim>({2., 8., -1.}))
              .norm(),
            0.);
  EXPECT_EQ(root[1].traction.value(A, 4.).norm(), 0.);
  // A quarter of the way from rest to what there is at a time.
  EXPECT_EQ(root[0].traction.value(A, LoadTime::between({}, 4., 0.25))[1], 2.);
}



TEST(ParameterTypes, ErrorsSayWhereTheyAre)
{
  const std::vector<std::array<std::string, 3>> cases = {
    {{"Loads/Factor=2*",
      "--set 'Loads/Factor=2*': Parameter 'Loads/Factor': the expression '2*' "
      "cannot be read: ",
      "It may use t, x, y, z, k, pi"}},
    {{"Loads/Factor=", "Parameter 'Loads/Factor': ", "it is empty"}},
    {{"Loads/first/Traction=1; 2",
      "Parameter 'Loads/first/Traction': '1; 2' has 2 components",
      "three expressions separated by semicolons"}},
    {{"Loads/first/Traction=1; 2; q",
      "Parameter 'Loads/first/Traction': the expression 'q'",
      "It may use t, x, y, z, pi"}},
    {{"Loads/first/Number=101", "Parameter 'Loads/first/Number' is too large", ""}},
    // What a formula might be chooses no section.
    {{"Loads/t/Number=1", "'Loads/t' is unknown or not used", ""}},
    {{"Loads/Names=first, Factor",
      "'Factor' cannot be a name of yours there",
      "a parameter in the same section is called so"}}};
  for (const auto &[setting, what, more] : cases)
    {
      const std::string message = message_after({"Loads/Names=first", setting});
      EXPECT_TRUE(contains(message, what)) << message;
      EXPECT_TRUE(contains(message, more)) << message;
    }
}



TEST(ParameterTypes, IsTextInTheReference)
{
  Root               root;
  std::ostringstream out;
  ParameterFile::print_reference(root, out);
  const std::string text = out.str();
  EXPECT_TRUE(contains(text, "subsection Loads\n")) << text;
  EXPECT_TRUE(contains(text, "set Factor = 2*k")) << text;
  EXPECT_TRUE(contains(text, "subsection <load>")) << text;
  EXPECT_TRUE(contains(text, "set Traction = 0; 0; 0")) << text;
}
