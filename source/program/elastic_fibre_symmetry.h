// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_elastic_fibre_symmetry_h
#define lumbricus_program_elastic_fibre_symmetry_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/mixed_space.h>

#include <string>

#include "plane_of_symmetry.h"

namespace lumbricus
{
  /**
   * What is wrong with elastic fibres, of laws and beside them, at @p plane in the
   * cells of this rank; empty where nothing is. The mirror image of every family
   * has to be one that is as stiff: itself, or the one it crosses.
   */
  std::string
  asymmetric_elastic_fibres(const PlaneOfSymmetry &plane,
                            const MixedSpace      &space,
                            const Anatomy         &anatomy);
} // namespace lumbricus

#endif
