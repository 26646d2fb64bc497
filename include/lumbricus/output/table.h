// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_table_h
#define lumbricus_output_table_h

#include <lumbricus/output/output_context.h>
#include <lumbricus/output/table_rows.h>
#include <lumbricus/parameters/parameter_owner.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * A table of a run, grown by some rows after every load step. It is in the
   * file of the name that it registers itself by, with ".csv". Where a run goes
   * on from a checkpoint so does its file: what a row depends on is in the
   * OutputContext, and not in a table, which is made anew.
   */
  class Table : public ParameterOwner
  {
  public:
    /** Entries of the section Output; none, unless a table says so. */
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** Whether the parameters ask for it; if not there is no file. */
    virtual bool
    is_wanted() const
    {
      return true;
    }

    /** Whether there is anything to write where these conditions act; if not
     * there is no file either. Asked when all parameters have been
     * initialized. */
    virtual bool
    applies_to(const BoundaryConditions & /*conditions*/) const
    {
      return true;
    }

    /** Whether write() reads StepRecord::work, which is not computed
     * otherwise. */
    virtual bool
    asks_for_work() const
    {
      return false;
    }

    /** After how many steps write() reads StepRecord::errors again, which are not
     * estimated otherwise; 0 for never. */
    virtual unsigned int
    steps_between_errors() const
    {
      return 0;
    }

    /** Whether write() reads StepRecord::errors_of_steps, which are not estimated
     * otherwise. */
    virtual bool
    asks_for_errors_of_steps() const
    {
      return false;
    }

    /** Whether write() reads StepRecord::errors_of_resets after step @p number, which
     * are not estimated otherwise. */
    virtual bool
    asks_for_errors_of_resets(const unsigned int /*number*/) const
    {
      return false;
    }

    /** The names of its columns. */
    virtual std::vector<std::string>
    columns() const = 0;

    /** Look at the parameters on the first mesh of a run. Throws ExcInput.
     * @return what to tell the user, in lines. Collective. */
    virtual std::string
    check(const MixedSpace & /*space*/) const
    {
      return "";
    }

    /** Before the first state, and after every change of the mesh.
     * Collective. */
    virtual void
    reinit(const MixedSpace & /*space*/)
    {}

    /** Add the rows of a step that was accepted; step 0 is the state of rest.
     * The rows are equal on all ranks. Collective. */
    virtual void
    write(TableRows &rows, const OutputContext &context) const = 0;
  };
} // namespace lumbricus

#endif
