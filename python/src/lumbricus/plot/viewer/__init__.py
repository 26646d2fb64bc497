# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene that is turned and played in a browser: scene.html."""
