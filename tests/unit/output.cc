// SPDX-License-Identifier: LGPL-2.1-or-later
// Plug-ins of the output: rows of tables, and what names they may have.
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/output_parts.h>
#include <lumbricus/output/table_rows.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace lumbricus;

TEST(TableRows, TextIsInQuotesWhereItNeedsThem)
{
  TableRows rows({"a", "b, c"});
  EXPECT_EQ(rows.first_line(), "a,\"b, c\"\n");
  rows << "plain" << std::string("one, \"two\"");
  rows.end_row();
  rows << 1. / 3. << 7u;
  rows.end_row();
  EXPECT_EQ(rows.take(),
            "plain,\"one, \"\"two\"\"\"\n0.333333333333333,7\n");
  EXPECT_EQ(rows.take(), "");
}



TEST(TableRows, RowsAreComplete)
{
  TableRows rows({"a", "b"});
  rows << 1;
  EXPECT_THROW(rows.end_row(), dealii::ExcDimensionMismatch);
}



TEST(OutputParts, ATableHasANameForItsFile)
{
  class Odd : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {"t"};
    }

    void
    write(TableRows & /*rows*/,
          const OutputContext & /*context*/) const override
    {}
  };

  dealii::ParameterHandler prm;
  EXPECT_NO_THROW(OutputParts().declare_parameters(prm));
  const Register<Table, Odd> odd("../odd one", "In no folder of a run.");
  dealii::ParameterHandler   another;
  EXPECT_THROW(OutputParts().declare_parameters(another), ExcInput);
  Registry<Table>::entries().erase("../odd one");
}
