// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** A row per load step: where the body is as a whole. */
  class BodyTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {
        "t", "x", "y", "z", "head_x", "tail_x", "length", "stride", "speed"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const BodyMotion &motion = context.step.motion;
      rows << context.state.time;
      for (unsigned int c = 0; c < dim; ++c)
        rows << motion.centre[c];
      rows << motion.head << motion.tail << motion.length << motion.stride
           << motion.speed;
      rows.end_row();
    }
  };

  static const Register<Table, BodyTable>
    body_table("body", "where the body is as a whole.");
} // namespace lumbricus
