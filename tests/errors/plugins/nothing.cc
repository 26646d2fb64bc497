// SPDX-License-Identifier: LGPL-2.1-or-later
// A library without any registration.
extern "C" int
nothing();

int
nothing()
{
  return 0;
}
