// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_fibre_warnings_h
#define lumbricus_anatomy_fibre_warnings_h

#include <lumbricus/anatomy/anatomy.h>

#include <string>

namespace lumbricus
{
  /** What is doubtful about the directions of the fibres of all muscles and tissues
   * (FibreField::warning()), a line each that begins with "Warning:"; empty where
   * nothing is. */
  std::string
  fibre_warnings(const Anatomy &anatomy);
} // namespace lumbricus

#endif
