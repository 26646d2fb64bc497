// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_stride_warning_h
#define lumbricus_program_stride_warning_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/measures/body_motion.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <string>

namespace lumbricus
{
  /**
   * What to say at the end of a run where muscles have taken a body somewhere, with
   * nothing but friction to hold on to, and that is so few elastic slips away that
   * they count: a stride is about 2.5 of them too short (benchmarks/crawling). Empty
   * where that is less than a tenth, and where the body has not got ahead.
   */
  std::string
  stride_warning(const Anatomy            &anatomy,
                 const BoundaryConditions &conditions,
                 const BodyMotion         &motion);
} // namespace lumbricus

#endif
