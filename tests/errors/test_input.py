# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong input ends with exit code 1 before any work, and with one message that
names the parameter and the way out."""
import concurrent.futures
import pathlib

import pytest

from lumbricus_run import run

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"
CHAIN = HERE / "chain.prm"

FORMULA = "Muscles/biceps/expression/Formula"
PRESSURE = "Boundary conditions/push/follower pressure/Pressure"


def load(kind, parameter, value):
    """One more load, of this kind, on the face at the end of y."""
    return f"""
subsection Boundary conditions
  set Names = wall, push, more
  subsection more
    set Boundary = y max
    set Type = {kind}
    subsection {kind}
      set {parameter} = {value}
    end
  end
end
"""


def fibres(kind, parameter, value):
    """Other fibres for the muscle."""
    return f"""
subsection Muscles
  subsection biceps
    set Fibres = {kind}
    subsection {kind}
      set {parameter} = {value}
    end
  end
end
"""


def another_muscle(text):
    """A second muscle of the block."""
    return f"""
subsection Tissues
  subsection flesh
    set Muscles = biceps, triceps
  end
end
subsection Muscles
  subsection triceps
    {text}
  end
end
"""


# What is wrong; the base; settings, or text that follows the base; what the
# message has to say: the parameter first, the way out last.
MISTAKES = [
    # Adaptivity.
    ("levels of a tissue that is not there", CHAIN,
     ["Adaptivity/Levels of tissues=skin: 1 - 2"],
     ["'Adaptivity/Levels of tissues'", "'skin'", "does not have",
      "'wall'", "'septum'", "'cap'", "'liquid'"]),
    ("levels that are none", CHAIN,
     ["Adaptivity/Levels of tissues=wall: 3 - 1"],
     ["'Adaptivity/Levels of tissues'", "'3 - 1'", "'wall'", "like '1 - 3'"]),
    ("one level only", CHAIN, ["Adaptivity/Levels of tissues=wall: 3"],
     ["'Adaptivity/Levels of tissues'", "'3'", "two numbers"]),
    ("levels the wrong way round", CHAIN,
     ["Adaptivity/Coarsest level=2", "Adaptivity/Finest level=1"],
     ["'Adaptivity/Finest level'", "'Coarsest level'", "is 1"]),
    ("rule that was not chosen", CHAIN,
     ["Adaptivity/number of unknowns/Target=100"],
     ["'Adaptivity/number of unknowns' is not used",
      "'Adaptivity/Marking' is 'fraction of error'"]),
    ("estimator that does not exist", CHAIN, ["Adaptivity/Estimator=kelly"],
     ["'Adaptivity/Estimator'", "'displacement jump'", "'stress jump'"]),
    # Patches of a block.
    ("patch that cuts a cell", BLOCK,
     ["Geometry/block/Patches=half", "Geometry/block/half/To=0.5, 1"],
     ["'Geometry/block/half/To'", "y = 0.5", "not on a mesh line",
      "Move it to 1", "'Cells'"]),
    ("patch in a plane of symmetry", BLOCK,
     ["Geometry/block/Patches=side", "Geometry/block/side/Face=y min",
      "Geometry/block/side/To=2, 1", "Geometry/block/Symmetry=y"],
     ["'Geometry/block/side/Face'", "'y min'", "plane of symmetry",
      "'Geometry/block/Symmetry'"]),
    # Names.
    ("misspelt parameter", BLOCK, ["Time/Ende=1"],
     ["'Time/Ende' is unknown", "Did you mean 'Time/End'?"]),
    ("misspelt parameter in a file", BLOCK, "\nsubsection Time\n"
     "  set Largest stap = 1\nend\n",
     ["case.prm, line 4", "'Time/Largest stap' is unknown",
      "Did you mean 'Time/Largest step'?"]),
    ("misspelt section", BLOCK, ["Tissue/flesh/Neo-Hooke/a=1"],
     ["section 'Tissue' is unknown", "Did you mean 'Tissues'?"]),
    ("nothing like it", BLOCK, ["Time/Gravity=9.81"],
     ["'Time/Gravity' is unknown", "known there", "'Largest step'",
      "--parameters"]),
    ("shape that was not chosen", BLOCK, ["Geometry/segment chain/Radius=1"],
     ["'Geometry/segment chain' is not used", "'Geometry/Shape' is 'block'",
      "Choose 'segment chain' there, or remove the section"]),
    ("law that was not chosen", BLOCK, ["Tissues/flesh/Mooney-Rivlin/b=1"],
     ["'Tissues/flesh/Mooney-Rivlin' is not used",
      "'Tissues/flesh/Law' is 'Neo-Hooke'", "Choose 'Mooney-Rivlin' there"]),
    ("activation that was not chosen", BLOCK, ["Muscles/biceps/wave/Duty=1"],
     ["'Muscles/biceps/wave' is not used",
      "'Muscles/biceps/Active stretch' is 'expression'",
      "Choose 'wave' there"]),
    ("load type that was not chosen", BLOCK,
     ["Boundary conditions/push/spring/Stiffness=1"],
     ["'Boundary conditions/push/spring' is not used",
      "'Boundary conditions/push/Type' is 'follower pressure'"]),
    ("solver that was not chosen", BLOCK,
     ["Linear solver/kept factor/Most iterations=9"],
     ["'Linear solver/kept factor' is not used",
      "'Linear solver/Method' is 'direct'"]),
    ("tissue the shape does not have", BLOCK, ["Tissues/septum/Law=Neo-Hooke"],
     ["'Tissues/septum' is unknown", "'flesh'"]),
    ("muscle no tissue has", BLOCK, ["Muscles/triceps/Fibres=radial"],
     ["'Muscles/triceps'", "Did you mean 'Muscles/biceps'?"]),
    ("load that is not listed", BLOCK, ["Boundary conditions/Names=push"],
     ["'Boundary conditions/wall'", "'push'", "lists its name"]),

    # Types and ranges.
    ("word for a number", BLOCK, ["Tissues/flesh/Neo-Hooke/a=stiff"],
     ["'Tissues/flesh/Neo-Hooke/a' is 'stiff'", "a number > 0"]),
    ("negative stiffness", BLOCK, ["Tissues/flesh/Neo-Hooke/a=-1"],
     ["'Tissues/flesh/Neo-Hooke/a' is '-1'", "a number > 0"]),
    ("negative stiffness in a file", BLOCK,
     "subsection Tissues\n  subsection flesh\n    subsection Neo-Hooke\n"
     "      set a = \\\n -1\n    end\n  end\nend\n",
     ["case.prm, line 5", "'Tissues/flesh/Neo-Hooke/a' is '-1'",
      "a number > 0"]),
    ("Poisson's ratio above 0.5", BLOCK, ["Tissues/flesh/Neo-Hooke/nu=0.6"],
     ["'Tissues/flesh/Neo-Hooke/nu' is '0.6'", "a number from 0 to 0.5"]),
    ("negative radius", CHAIN, ["Geometry/segment chain/Radius=-2"],
     ["'Geometry/segment chain/Radius' is '-2'", "a number > 0"]),
    ("infinite length", BLOCK, ["Geometry/block/Lengths=1, inf, 1"],
     ["'Geometry/block/Lengths' is '1, inf, 1'", "3 entries",
      "a number > 0"]),
    ("two lengths for three axes", BLOCK, ["Geometry/block/Lengths=1, 1"],
     ["'Geometry/block/Lengths' is '1, 1'", "3 entries"]),
    ("broken number of cells", BLOCK, ["Geometry/block/Cells=1, 1.5, 1"],
     ["'Geometry/block/Cells' is '1, 1.5, 1'", "a whole number, at least 1"]),
    ("no segments", CHAIN, ["Geometry/segment chain/Number of segments=0"],
     ["'Geometry/segment chain/Number of segments' is '0'",
      "a whole number from 1 to 10000"]),
    ("word that is neither true nor false", BLOCK,
     ["Geometry/block/Liquid=maybe"],
     ["'Geometry/block/Liquid' is 'maybe'", "true or false"]),
    ("shape there is not", BLOCK, ["Geometry/Shape=sphere"],
     ["'Geometry/Shape' is 'sphere'",
      "one of 'block', 'mesh file', 'open cylinder', 'segment chain'"]),
    ("load type there is not", BLOCK,
     ["Boundary conditions/push/Type=gravity"],
     ["'Boundary conditions/push/Type' is 'gravity'", "'dead traction'"]),
    ("solver there is not", BLOCK, ["Linear solver/Method=magic"],
     ["'Linear solver/Method' is 'magic'", "'direct', 'kept factor'"]),
    ("reset mode there is not", BLOCK, ["Reset/Mode=none"],
     ["'Reset/Mode' is 'none'", "'isochoric', 'full'"]),
    ("no end of time", BLOCK, ["Time/End=0"],
     ["'Time/End' is '0'", "a number > 0"]),
    ("smallest step above the largest", BLOCK, ["Time/Smallest step=1"],
     ["'Time/Smallest step'", "'Time/Largest step'", "1, 0.5 and 0.5",
      "Change them so that"]),
    ("first step above the largest", BLOCK, ["Time/First step=2"],
     ["'Time/First step'", "'Time/Largest step'", "Change them so that"]),
    ("odd number of cells", CHAIN,
     ["Geometry/segment chain/Cells along a segment=3"],
     ["'Geometry/segment chain/Cells along a segment' is 3", "even"]),

    # The body.
    ("two rules for one segment", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=1-2, 2"],
     ["'Geometry/segment chain/Segments with their own measures'",
      "two rules for segment 2", "Make the ranges disjoint"]),
    ("range beyond the chain", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=2-9"],
     ["'Geometry/segment chain/Segments with their own measures'",
      "'Segments 2-9' is not within the chain", "from 1 (head) to 2 (tail)"]),
    ("not a range", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=first"],
     ["'Geometry/segment chain/Segments with their own measures'", "'first'",
      "Write a list like '1, 8-10'"]),
    ("more layers than thicknesses", CHAIN,
     ["Geometry/segment chain/Wall layers=wall, skin"],
     ["'Geometry/segment chain/Wall layer thicknesses' has 1 entries",
      "'Geometry/segment chain/Wall layers' has 2",
      "Give one thickness for every layer"]),
    ("layer with the name of the liquid", CHAIN,
     ["Geometry/segment chain/Wall layers=wall, liquid"],
     ["'Geometry/segment chain/Wall layers'", "'liquid'",
      "Give every layer a name of its own"]),
    ("stiff liquid", CHAIN, ["Tissues/liquid/Neo-Hooke/a=0.05"],
     ["'Tissues/liquid/Neo-Hooke'", "0.05", "more than a tenth",
      "0.23 ('cap')", "1% of the wall's stiffness or less", "0.0023"]),

    # Muscles.
    ("muscle without fibres", BLOCK,
     another_muscle("set Active stretch = wave"),
     ["'Muscles/triceps/Fibres' is not set", "no fibres",
      "Set it to one of", "circumferential"]),
    ("muscle without active stretch", BLOCK,
     another_muscle("set Fibres = radial"),
     ["'Muscles/triceps/Active stretch' is not set", "Set it to one of",
      "wave"]),
    ("muscle that is listed, but has no section", BLOCK,
     ["Tissues/flesh/Muscles=biceps, triceps"],
     ["'Muscles/triceps/Fibres' is not set", "Set it to one of"]),
    ("muscle in a liquid", BLOCK, ["Geometry/block/Liquid=true"],
     ["'Tissues/flesh/Muscles' has to be empty", "a liquid has no fibres",
      "Put the muscle into a tissue of the wall"]),
    ("active stretch of zero", BLOCK, [FORMULA + "=1 - 2*t"],
     ["'Muscles/biceps/expression'", "segment 1", "at time 0.5",
      "a number > 0", "Change"]),
    ("active stretch that is NaN late", BLOCK, [FORMULA + "=sqrt(0.985 - t)"],
     ["'Muscles/biceps/expression'", "segment 1", "at time 0.99", "nan",
      "a number > 0"]),
    ("active stretch that does not parse", BLOCK, [FORMULA + "=1 - 0.1*q"],
     [f"'{FORMULA}'", "'1 - 0.1*q'", '"q"', "It may use t, x, y, z, n, pi, s"]),
    ("active stretch that breaks off", BLOCK, [FORMULA + "=1 +"],
     [f"'{FORMULA}'", "Unexpected end of expression", "It may use"]),
    ("active stretch that is empty", BLOCK, [FORMULA + "="],
     [f"'{FORMULA}'", "it is empty", "It may use"]),
    ("wave that shortens to nothing", BLOCK,
     another_muscle("set Fibres = radial\nset Active stretch = wave\n"
                    "subsection wave\nset Amplitude = 1\nend"),
     ["'Muscles/triceps/wave/Amplitude' is 1", "has to be less than 1"]),
    ("wave that lasts more than its period", BLOCK,
     another_muscle("set Fibres = radial\nset Active stretch = wave\n"
                    "subsection wave\nset Duty = 1.5\nend"),
     ["'Muscles/triceps/wave/Duty' is 1.5", "at most 1"]),
    ("fibres of no direction", BLOCK, fibres("direction", "Direction",
                                             "0, 0, 0"),
     ["'Muscles/biceps/direction/Direction'", "Give a vector like '1, 0, 0'"]),
    ("fibres that do not parse", BLOCK,
     fibres("vector expression", "Formulas", "1; q; 0"),
     ["'Muscles/biceps/vector expression/Formulas'", '"q"', "It may use"]),
    ("fibres of two components", BLOCK,
     fibres("vector expression", "Formulas", "1; 0"),
     ["'Muscles/biceps/vector expression/Formulas'", "2 components",
      "three expressions separated by semicolons"]),
    ("fibres that vanish somewhere", BLOCK,
     fibres("vector expression", "Formulas", "0; 0; 0"),
     ["'Muscles/biceps/vector expression/Formulas'", "no direction at the "
      "point", "Change the formulas"]),

    # Loads and supports.
    ("boundary there is not", BLOCK, ["Boundary conditions/push/Boundary=top"],
     ["'Boundary conditions/push/Boundary' is 'top'",
      "'x min', 'x max', 'y min', 'y max', 'z min', 'z max'"]),
    ("boundary that is cut away by symmetry", BLOCK,
     ["Geometry/block/Symmetry=x"],
     ["'Boundary conditions/wall/Boundary' is 'x min'", "Give one of 'x max'"]),
    ("no boundary", BLOCK, ["Boundary conditions/push/Boundary="],
     ["'Boundary conditions/push/Boundary' is ''", "Give one of 'x min'"]),
    ("no type", BLOCK, ["Boundary conditions/Names=wall, push, more"],
     ["'Boundary conditions/more/Type' is not set", "Set it to one of",
      "follower pressure"]),
    ("pressure that does not parse", BLOCK, [PRESSURE + "=0.1*sin("],
     [f"'{PRESSURE}'", "'0.1*sin('", "It may use t, x, y, z, pi"]),
    ("traction that does not parse", BLOCK,
     load("dead traction", "Traction", "0; 2*p; 0"),
     ["'Boundary conditions/more/dead traction/Traction'", '"p"',
      "It may use t, x, y, z, pi"]),
    ("traction of one component", BLOCK,
     load("dead traction", "Traction", "t"),
     ["'Boundary conditions/more/dead traction/Traction'", "1 components",
      "three expressions separated by semicolons"]),
    ("displacement that does not parse", BLOCK,
     load("displacement", "Displacement", "0; 0.1 t; 0"),
     ["'Boundary conditions/more/displacement/Displacement'", "'0.1 t'",
      "It may use t, x, y, z, pi"]),
    ("springs that push", BLOCK, load("spring", "Stiffness", "-1"),
     ["'Boundary conditions/more/spring/Stiffness' is '-1'", "a number > 0"]),
    ("component there is not", BLOCK, load("displacement", "Components", "r"),
     ["'Boundary conditions/more/displacement/Components' is 'r'",
      "one of 'x', 'y', 'z'"]),
    ("pressure that is NaN late", BLOCK, [PRESSURE + "=sqrt(0.985 - t)"],
     [f"'{PRESSURE}'", "nan", "at time 0.99", "Change it"]),
    ("traction that is infinite on the boundary", BLOCK,
     load("dead traction", "Traction", "0; 1/(y - 1); 0"),
     ["'Boundary conditions/more/dead traction/Traction'", "inf",
      "at time 0", "Change it"]),
    ("displacement prescribed twice", BLOCK,
     load("displacement", "Components", "x").replace("y max", "x min"),
     ["'Boundary conditions/more'", "along x", "'x min'", "twice",
      "Remove one"]),
    ("body that can move", BLOCK,
     ["Boundary conditions/Minimal support=false",
      "Boundary conditions/wall/displacement/Components=x"],
     ["translation along y, translation along z, rotation about x",
      "Set 'Boundary conditions/Minimal support' to true"]),

    # The file.
    ("subsection without end", BLOCK, "subsection Time\n  set End = 2\n",
     ["case.prm: ", "unequal numbers of 'subsection' and 'end'", "for each of "
      "these, 'end'"]),
    ("end without subsection", BLOCK, "set Title = x\nend\n",
     ["case.prm, line 3: ", "no subsection to leave"]),
    ("line that is neither", BLOCK, "set Title = x\nTitle = y\n",
     ["case.prm, line 3: ", "<Title = y>", "'set Name = value'"]),
    ("no equals sign", BLOCK, "set Title\n",
     ["case.prm, line 2: ", "'set Name = value'"]),
    ("setting without a value", BLOCK, ["Time/End"],
     ["'Time/End'", '--set "Section/Name=value"']),
    ("setting without a name", BLOCK, ["=1"],
     ["'=1'", '--set "Section/Name=value"']),
    ("setting of a section", BLOCK, ["Time=1"],
     ["'Time' is unknown"]),
]


def start(job):
    """Run with a mistake on some ranks, in a folder of its own."""
    mistake, ranks, folder = job
    _, base, change, _ = mistake
    settings = change if isinstance(change, list) else []
    folder.mkdir()
    case = folder / "case.prm"
    case.write_text(f"include {base}\n" +
                    (change if isinstance(change, str) else ""))
    return run(case, folder / "out", settings, ranks)


ON_TWO_RANKS = ["misspelt parameter", "active stretch that does not parse",
                "active stretch of zero", "fibres that vanish somewhere",
                "body that can move"]
CASES = [(mistake, 1) for mistake in MISTAKES] + \
    [(mistake, 2) for mistake in MISTAKES if mistake[0] in ON_TWO_RANKS]


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """All runs, two at a time: most of a run is the start of the program."""
    base = tmp_path_factory.mktemp("mistakes")
    jobs = [(mistake, ranks, base / str(i))
            for i, (mistake, ranks) in enumerate(CASES)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(start, jobs))


@pytest.mark.parametrize("i", range(len(CASES)), ids=[
    f"{mistake[0]}, {ranks} rank" for mistake, ranks in CASES])
def test_one_message_names_the_parameter_and_the_way_out(i, results):
    (_, _, _, words), ranks = CASES[i]
    result = results[i]
    everything = result.log + result.message
    assert result.exit_code == 1, everything
    for frame in ("An error occurred", "Stacktrace", "exception", "Exception",
                  "TimerOutput", "violated", "bug"):
        assert frame not in everything, everything
    assert result.log == ""
    # Nothing was computed, and no earlier results were touched.
    assert not [path for path in result.folder.glob("**/*") if path.is_file()]

    # mpirun adds its own lines on processes that fail.
    message = " ".join(result.message.split("\n---")[0].split())
    assert message.startswith("lumbricus: ")
    for part in words:
        assert part in message
    assert everything.count("lumbricus: ") == 1, everything


@pytest.mark.parametrize("folder, ranks", [("file/below", 1),
                                           ("file/below", 2),
                                           ("/proc/lumbricus", 1)])
def test_output_folder_that_cannot_be_written(folder, ranks, tmp_path):
    (tmp_path / "file").write_text("")
    result = run(BLOCK, tmp_path / folder, ranks=ranks)
    assert result.exit_code == 1
    assert result.message.count("cannot be written") == 1
    assert str(tmp_path / folder) in result.message
    assert "'Output/Folder' or --output" in result.message
    assert result.log == ""


def test_expressions_are_tried_where_they_are_used(tmp_path):
    """Not a mistake: defined on its boundary and in its tissue only."""
    case = tmp_path / "case.prm"
    case.write_text(f"include {BLOCK}\n" +
                    load("dead traction", "Traction",
                         "0; 0*sqrt(y - 0.9); 0"))
    result = run(case, tmp_path / "out",
                 [PRESSURE + "=0.01*sqrt(x - 1.9)",
                  FORMULA + "=1 - 0.01*t*y/sqrt(y^2 + z^2)"])
    assert result.exit_code == 0, result.message


def test_the_bases_have_no_mistake(tmp_path):
    for base in (BLOCK, CHAIN):
        result = run(base, tmp_path / "out", options=["--check"])
        assert result.exit_code == 0, result.message
