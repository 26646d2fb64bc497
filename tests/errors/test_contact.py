# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles that are none, or are where the body is, and a body that nothing
holds: exit code 1 before any work, and one message with the way out. What is
apart from an obstacle was once taken to be anchored where it is, and held."""
import pathlib

import pytest
from lumbricus_run import run
from mistakes import check_one_message, names, on_ranks, run_all

TESTS = pathlib.Path(__file__).resolve().parent.parent
GROUND = TESTS / "physics" / "ground.prm"
CHAIN = TESTS / "physics" / "chain.prm"

CONTACT = "Boundary conditions/ground/contact/"
ALONE = ["Boundary conditions/Names=ground"]
WEIGHT = ["Body forces/Names=weight", "Body forces/weight/Type=weight",
          "Body forces/weight/weight/Gravity=0; 0; -9810",
          "Tissues/block/Density=1e-9"]
HALF_BELOW = ["Boundary conditions/Names=ground",
              "Boundary conditions/ground/Boundary=skin",
              "Boundary conditions/ground/Type=contact",
              CONTACT + "plane/Point=0; 0; -5"]

# Name, file, settings, words of the message.
MISTAKES = [
    ("inside of the ground", GROUND, [CONTACT + "plane/Point=0; 0; 0.4"],
     ["At time 0 the boundary 'z min' is 0.4 mm inside of 'ground'",
      "a third of its cells' thickness (0.5 mm)", "contact/plane'"]),
    ("nothing touches", GROUND,
     [*ALONE, *WEIGHT, CONTACT + "plane/Point=0; 0; -0.25"],
     ["Nothing of the body touches 'ground' (it is 0.25 mm away)", "it falls",
      "'displacement' or 'spring'"]),
    ("not held along the ground", GROUND,
     [*ALONE, "Boundary conditions/Minimal support=false"],
     ["The body can still move rigidly", "'contact' with friction"]),
    ("no normal", GROUND, [CONTACT + "plane/Normal=0; 0; 1 - 2*t"],
     ["contact/plane'", "'Normal' has no direction", "at time 0.5"]),
    ("no radius", GROUND, [CONTACT + "Obstacle=sphere",
                           CONTACT + "sphere/Radius=1 - 2*t"],
     ["contact/sphere'", "'Radius' is 0", "at time 0.5"]),
    ("an axis without length", GROUND,
     [CONTACT + "Obstacle=burrow", CONTACT + "burrow/Axis=0, 0, 0"],
     ["contact/burrow/Axis", "no direction", "'1, 0, 0'"]),
    ("a curved burrow that grows", GROUND,
     [CONTACT + "Obstacle=burrow", CONTACT + "burrow/Curvature=0.1",
      CONTACT + "burrow/Radius=2 + t"],
     ["contact/burrow/Radius", "constant"]),
    ("no forward direction", GROUND, [CONTACT + "Forward=0, 0, 0"],
     ["contact/Forward", "no direction", "'-1, 0, 0'"]),
    ("forward is into the ground", GROUND,
     [CONTACT + "Friction=0.1, 0.2, 0.1", CONTACT + "Forward=0, 0, -2"],
     ["contact': 'Forward' is along the normal of 'ground'",
      "a vector along its surface", "in all directions"]),
    ("slip without friction", GROUND, [CONTACT + "Elastic slip=0.01"],
     ["contact/Elastic slip", "nothing holds the skin", "'Friction'"]),
    ("setae that push", GROUND,
     [CONTACT + "Friction=0.1, 0.1, 0.1", CONTACT + "Setae=1 - 4*t"],
     ["'Setae' is -0.04", "not negative"]),
    ("a quarter on the ground", CHAIN,
     [*HALF_BELOW, "Geometry/segment chain/Cross-section=quarter"],
     ["'ground' is not symmetric", "0, 0, 1", "Cross-section"]),
]
CASES = on_ranks(MISTAKES, ["nothing touches", "inside of the ground",
                            "forward is into the ground"])


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    base = tmp_path_factory.mktemp("contact")

    def start(mistake, ranks, folder, run_here):
        return run_here(mistake[1], folder, mistake[2], ranks)

    return run_all(start, CASES, base)


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_one_message(i, results):
    check_one_message(results[i], CASES[i][0][3])


def test_what_goes_to_and_fro_is_named(tmp_path):
    """Where Newton's method fails with a skin that begins to slide."""
    result = run(GROUND, tmp_path, [
        CONTACT + "Friction=0.1, 0.1, 0.1", "Newton/Most iterations=2",
        "Time/Smallest step=0.5", "Time/First step=1"])
    assert result.exit_code == 2
    words = result.said()
    assert "of 36 points of 'ground' change between sticking, sliding" in words
    assert "most of them in segment 1: raise its 'Elastic slip'" in words


def test_no_forward_where_friction_is_equal(tmp_path):
    """Then it does not matter."""
    result = run(GROUND, tmp_path, [CONTACT + "Friction=0.1, 0.1, 0.1",
                                    CONTACT + "Forward=0, 0, -2"])
    assert result.exit_code == 0


def test_the_base_has_no_mistake(tmp_path):
    assert run(GROUND, tmp_path).exit_code == 0
