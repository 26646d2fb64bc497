# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of lumbricus-plot, which draws a run and reports on it."""
