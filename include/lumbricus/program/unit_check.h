// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_unit_check_h
#define lumbricus_program_unit_check_h

#include <lumbricus/anatomy/anatomy.h>

#include <string>

namespace lumbricus
{
  /**
   * Finds what looks like a number in other units than the rest. The program
   * itself needs no units: any consistent set will do.
   */
  class UnitCheck : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Lines that begin with "Warning:"; empty where nothing looks odd. */
    std::string
    warnings(const Anatomy &anatomy) const;

  private:
    std::string units = "mm, N, MPa";
  };
} // namespace lumbricus

#endif
