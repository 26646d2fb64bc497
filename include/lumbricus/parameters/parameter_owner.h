// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_parameter_owner_h
#define lumbricus_parameters_parameter_owner_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace lumbricus
{
  /** Which sections to declare: those the input asks for, or all there are. */
  enum class Extent
  {
    chosen,
    everything
  };

  /**
   * A class that has parameters, each declared once, beside the code that uses
   * it. The documentation of an entry starts with its unit in brackets.
   *
   * Reading happens in rounds (ParameterFile::parse()): declare, read, then
   * extend_parameters() declares what the values read so far call for (the
   * section of the law that was chosen, one section per tissue), until
   * nothing more is called for. So a parameter that nobody would read is
   * never declared, and setting it is an error.
   */
  class ParameterOwner
  {
  public:
    virtual ~ParameterOwner() = default;

    /** Declare the entries this object always has, in the current section. */
    virtual void
    declare_parameters(dealii::ParameterHandler &prm) = 0;

    /**
     * Declare what the values read so far call for.
     * @return whether anything was declared that was not there before.
     */
    virtual bool
    extend_parameters(dealii::ParameterHandler & /*prm*/,
                      const Extent /*extent*/)
    {
      return false;
    }

    /**
     * Check what one entry's pattern cannot: agreement between entries.
     * Throws ExcInput, or ExcParameter with a path that starts at the section
     * of this object.
     */
    virtual void
    check_parameters() const
    {}
  };
} // namespace lumbricus

#endif
