// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_dimension_h
#define lumbricus_core_dimension_h

/**
 * All of the program. Which class does what, and in which order, is on the page
 * on its structure (doc/structure.md).
 */
namespace lumbricus
{
  /** The program is three-dimensional; nothing is a template on this. */
  constexpr int dim = 3;
} // namespace lumbricus

#endif
