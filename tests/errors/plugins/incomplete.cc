// SPDX-License-Identifier: LGPL-2.1-or-later
// A library that lacks one of its sources.
int
left_out_by_mistake();

extern "C" int
incomplete();

int
incomplete()
{
  return left_out_by_mistake();
}
