// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_build_version_h
#define lumbricus_core_build_version_h

#include <deal.II/base/config.h>

/**
 * @file
 * What has to be the same in all that is linked or loaded together, as literals
 * that each library has for itself: the version of this program (which the
 * target lumbricus_library defines), that of deal.II and the build type, with
 * which deal.II's assertions come and go.
 */
#ifdef DEBUG
/** Whether there are deal.II's assertions. */
#  define LUMBRICUS_BUILD_TYPE "Debug"
#else
/** Whether there are deal.II's assertions. */
#  define LUMBRICUS_BUILD_TYPE "Release"
#endif

/** All of it, as --version prints it. */
#define LUMBRICUS_BUILD_VERSION                                      \
  "lumbricus " LUMBRICUS_VERSION " (deal.II " DEAL_II_PACKAGE_VERSION \
  ", " LUMBRICUS_BUILD_TYPE ")"

/** What stands before LUMBRICUS_BUILD_VERSION in the file of a library that the
 * program may load. */
#define LUMBRICUS_PLUGIN_MARK "plug-in of "

#endif
