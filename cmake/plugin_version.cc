// SPDX-License-Identifier: LGPL-2.1-or-later
// Part of every library that lumbricus_add_plugin() makes: what it was built
// for. The program looks this text up in the file before it loads the library,
// since loading one of another build type brings a second deal.II, which makes
// its global objects in the place of those of the first.
#include <lumbricus/core/build_version.h>

// Seen from outside, whatever the visibility of the others: so it is kept.
extern "C" __attribute__((visibility("default")))
const char lumbricus_plugin_version[];

// Between zero bytes, for it to be found.
const char lumbricus_plugin_version[] =
  "\0" LUMBRICUS_PLUGIN_MARK LUMBRICUS_BUILD_VERSION;
