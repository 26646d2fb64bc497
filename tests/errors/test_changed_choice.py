# SPDX-License-Identifier: LGPL-2.1-or-later
"""parameters.prm of a run is as good as the input it was made from. It has the
section of everything that the run chose, and so no choice could be changed over
it: `lumbricus results/parameters.prm --set "Linear solver/Method=direct"`, and
the same at --restart, were refused because of the section of the other
method."""
import pathlib

import pytest
from lumbricus_run import call, outline, run, run_well
from lumbricus_run import resolved as resolved_in

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"
SPHERE = HERE.parent / "physics" / "sphere.prm"
SHORT = ["Time/End=0.01", "Time/First step=0.01", "Adaptivity/Every=1",
         "Body forces/Names=weight", "Body forces/weight/Type=dead body force"]
FIBRES = [*SHORT, "Tissues/flesh/Law=Guccione",
          "Tissues/flesh/Elastic fibres/Names=net",
          "Tissues/flesh/Elastic fibres/net/Fibres=longitudinal"]
CONTACT = [*SHORT[:2], "Boundary conditions/Names=wall, push, ground",
           "Boundary conditions/ground/Boundary=z min",
           "Boundary conditions/ground/Type=contact"]
CAVITY = [*SHORT[:2], "Cavities/Segments with their own content=1",
          "Geometry/hollow sphere/Cells around a quarter=2",
          "Geometry/hollow sphere/Cells through the wall=1"]
PULL = [*SHORT[:2], "Muscles/biceps/Action=active stress",
        "Muscles/biceps/Activation=expression",
        "Muscles/biceps/expression/Formula=t",
        "Muscles/biceps/active stress/Force-length=Blemker",
        "Muscles/biceps/active stress/Force-velocity=Hill"]
GROWTH = [*SHORT[:2], "Muscles/biceps/Action=growth",
          "Muscles/biceps/Growth=expression",
          "Muscles/biceps/expression/Formula=1 + t"]
UNUSED = "Not used, because of --set: "


@pytest.fixture(scope="module")
def resolved(tmp_path_factory):
    """parameters.prm of six runs by their names: of a block, of one on the
    ground, of one whose muscle pulls, of one that grows, of one with elastic fibres,
    and of a body with a cavity."""
    folder = tmp_path_factory.mktemp("resolved")
    for name, case, settings in (("block", BLOCK, SHORT),
                                 ("contact", BLOCK, CONTACT),
                                 ("pull", BLOCK, PULL),
                                 ("growth", BLOCK, GROWTH),
                                 ("fibres", BLOCK, FIBRES),
                                 ("cavity", SPHERE, CAVITY)):
        run_well(case, folder / name, settings)
    return {name: folder / name / "parameters.prm"
            for name in ("block", "contact", "pull", "growth", "fibres", "cavity")}


def choices():
    """(parameter, name) for all that is registered: a choice lists in its
    documentation the names of the sections beside it."""
    sections, words, choice = [], "", None
    parameters, names = {}, {}
    for line in map(str.strip, call("--parameters").stdout.splitlines()):
        if line.startswith("#"):
            words += " " + line[1:].strip()
            continue
        if line.startswith("subsection "):
            names.setdefault("/".join(sections), []).append(
                line[len("subsection "):])
            sections.append(line[len("subsection "):])
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name = line[len("set "):].split("=")[0].strip()
            parameters["/".join([*sections, name])] = words
        words = ""
    found = []
    for parameter, words in parameters.items():
        section, _, _ = parameter.rpartition("/")
        found += [(parameter, name) for name in names.get(section, [])
                  if f"'{name}': " in words]
    return found


CHOICES = choices()


def body_of(parameter):
    """Which of the runs uses it."""
    return "cavity" if parameter.startswith("Cavities/") else \
        "contact" if "/contact/" in parameter else \
        "pull" if "/active stress/" in parameter or \
        parameter.endswith("/Activation") else \
        "growth" if parameter.endswith("/Growth") else \
        "fibres" if "/Elastic fibres/" in parameter or \
        "/Guccione/" in parameter else "block"


def in_block(parameter):
    """The parameter with the names that the block has."""
    return parameter.replace("<tissue>", "flesh").replace("<family>", "net").replace(
        "<muscle>", "biceps").replace(
            "<load or support>",
            "ground" if body_of(parameter) == "contact" else "push").replace(
                "<body force>", "weight").replace(
                    "Cavities/Segments 8-10", "Cavities/Segment 1")


def test_all_choices_are_found():
    assert {"Geometry/Shape", "Tissues/<tissue>/Law", "Muscles/<muscle>/Fibres",
            "Muscles/<muscle>/Active stretch", "Muscles/<muscle>/Activation",
            "Muscles/<muscle>/Growth",
            "Muscles/<muscle>/active stress/Force-length",
            "Muscles/<muscle>/active stress/Force-velocity", "Linear solver/Method",
            "Boundary conditions/<load or support>/Type",
            "Body forces/<body force>/Type", "Adaptivity/Marking",
            "Adaptivity/Estimator"} <= {
                parameter for parameter, _ in CHOICES}


# What a choice needs that has no default.
ELLIPSOID = ("'truncated ellipsoid'",)
LIQUID = ("'Tissues/liquid/", "'Boundary conditions/wall/Boundary'")
NEEDS = {
    "Geometry/Shape=mesh file": ("'Geometry/mesh file/File'",),
    "Geometry/Shape=segment chain": LIQUID,
    "Geometry/Shape=open cylinder": LIQUID,
    "Geometry/Shape=hollow sphere": LIQUID,
    "Muscles/biceps/Action=active stress": ("'Muscles/biceps/Activation'",),
    "Muscles/biceps/Action=growth": ("'Muscles/biceps/Growth'",),
    "Muscles/biceps/Action=growth along fibres": ("'Muscles/biceps/Growth'",),
    "Muscles/biceps/active stress/Force-length=file": (
        "'Muscles/biceps/active stress/file/File'",),
    "Geometry/Shape=truncated ellipsoid": (
        "'Boundary conditions/wall/Boundary'",),
    "Muscles/biceps/Fibres=ellipsoidal": ELLIPSOID,
    "Tissues/flesh/Guccione/Fibres=ellipsoidal": ELLIPSOID,
    "Tissues/flesh/Elastic fibres/net/Fibres=ellipsoidal": ELLIPSOID,
    "Muscles/biceps/Fibres=file": ("'Muscles/biceps/file/File'",),
}


@pytest.mark.parametrize("parameter, name", CHOICES)
def test_any_choice_changes_over_a_resolved_file(parameter, name, resolved,
                                                 tmp_path):
    """The run goes on, or says what the new choice lacks; its parameters.prm is
    an input that gives the same run."""
    setting = f"{in_block(parameter)}={name}"
    resolved = resolved[body_of(parameter)]
    result = run(resolved, tmp_path / "out", [setting])
    if result.exit_code == 1:
        assert "not used" not in result.message, result.message
        assert "unknown" not in result.message, result.message
        assert any(need in result.message for need in NEEDS.get(
            setting, (f"/{name}/", f"'{name}'"))), result.message
        return
    assert result.exit_code in (0, 2), result.message
    log = (tmp_path / "out" / "log.txt").read_text()
    before = outline(resolved.read_text())
    after = outline((tmp_path / "out/parameters.prm").read_text())
    assert after[in_block(parameter)] == name
    assert (UNUSED in log) == (before[in_block(parameter)] != name)

    again = run(tmp_path / "out/parameters.prm", tmp_path / "again")
    assert again.exit_code == result.exit_code, again.message
    assert UNUSED not in (tmp_path / "again" / "log.txt").read_text()
    assert (tmp_path / "again/segments.csv").read_bytes() == \
        (tmp_path / "out/segments.csv").read_bytes()
    assert resolved_in(tmp_path / "again") == resolved_in(tmp_path / "out")


def test_a_restart_may_change_a_choice(tmp_path):
    """Over the parameters of the checkpoint; what the state hangs on stays."""
    folder = tmp_path / "out"
    run_well(BLOCK, folder, ["Time/End=0.5", "Time/First step=0.25",
                             "Checkpoints/Steps=1",
                             "Linear solver/Method=kept factor"])
    whole = (folder / "segments.csv").read_text()
    result = call("--restart", folder, "--set", "Time/End=1", "--set",
                       "Linear solver/Method=direct")
    assert result.returncode == 0, result.stderr
    assert f"{UNUSED}'Linear solver/kept factor'" in result.stdout
    values = outline((folder / "parameters.prm").read_text())
    assert values["Linear solver/Method"] == "direct"
    assert not any(name.startswith("Linear solver/kept factor")
                   for name in values)
    table = (folder / "segments.csv").read_text()
    assert table.startswith(whole) and len(table) > len(whole)

    result = call("--restart", folder, "--set", "Geometry/Shape=block")
    assert result.returncode == 1
    assert "cannot change at a restart" in result.stderr


def test_a_section_that_no_choice_takes_stays_a_mistake(resolved, tmp_path):
    """In a file by hand it is a typing error, whatever the settings say."""
    case = tmp_path / "case.prm"
    case.write_text(f"include {resolved['block']}\n"
                    "subsection Linear solver\n  subsection multigrid\n"
                    "  end\nend\n")
    for settings in ([], ["Time/End=2"], ["Linear solver/Method=kept factor"]):
        result = run(case, tmp_path / "out", settings)
        assert result.exit_code == 1
        assert "case.prm, line 3" in result.message
        assert "'Linear solver/multigrid' is not used" in result.message
