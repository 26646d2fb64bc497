// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_dimension_h
#define lumbricus_core_dimension_h

namespace lumbricus
{
  /** The program is three-dimensional; nothing is a template on this. */
  constexpr int dim = 3;
} // namespace lumbricus

#endif
