# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of the user's own in what a run writes. A muscle called M&M, a<b or
"x" made VTU files that were no XML, and the fields of 'left arm' and
'left_arm' became one."""
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
import pyvista

from lumbricus_run import SOURCE, resolved, run, run_well

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.command import main  # noqa: E402

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
NAMES = ["circular muscle", "M&M", "a<b>", 'tibialis "anterior"', "Längsmuskel",
         "it's", "50% power", "fibre:left", "筋", "$x$ a;b|c", "{d}",
         "&amp;", "value", "Fibres"]
TITLE = 'a < b & "c" <script>alert(1)</script> $y$ {z}'


def with_muscles(names, file_name):
    """The block with one muscle more for every name, each weaker than the one
    before; on a load and a patch the names do no harm either."""
    lines = [f"include {BLOCK}", f"set Title = {TITLE}",
             "subsection Tissues", "  subsection flesh",
             f"    set Muscles = {', '.join(['biceps', *names])}", "  end",
             "end", "subsection Muscles"]
    for i, name in enumerate(names):
        lines += [f"  subsection {name}", "    set Fibres = longitudinal",
                  "    set Active stretch = expression",
                  "    subsection expression",
                  f"      set Formula = 1 - {0.001 * (i + 1)}*t", "    end",
                  "  end"]
    lines += ["end", "subsection Boundary conditions",
              f"  set Names = wall, push, {', '.join(names)}"]
    for name in names:
        lines += [f"  subsection {name}", "    set Boundary = y max",
                  "    set Type = dead traction",
                  "    subsection dead traction",
                  "      set Traction = 0; 0; 0", "    end", "  end"]
    file_name.write_text("\n".join([*lines, "end", ""]), encoding="utf-8")
    return file_name


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    base = tmp_path_factory.mktemp("names")
    case = with_muscles(NAMES, base / "case.prm")
    return run_well(case, base / "out",
                    ["Time/End=1", "Time/First step=1", "Time/Largest step=1"],
                    ranks=2).folder


def test_vtu_files_are_xml_with_the_names_of_the_user(folder):
    files = [folder / "solution.pvd", *(folder / "vtu").iterdir()]
    assert len(files) == 7  # at two times two pieces and what joins them
    for file in files:
        tree = ElementTree.parse(file)
        if file.suffix == ".pvd":
            continue
        arrays = [array.get("Name") for array in tree.iter(
            "PDataArray" if file.suffix == ".pvtu" else "DataArray")]
        for name in NAMES:
            for field in ("fibre_", "active_stretch_"):
                assert arrays.count(field + name.replace(" ", "_")) == 1


def test_paraview_reads_the_fields_by_their_names(folder):
    reader = pyvista.get_reader(folder / "solution.pvd")
    reader.set_active_time_value(reader.time_values[-1])
    fields = reader.read()[0].point_data
    for i, name in enumerate(NAMES):
        name = name.replace(" ", "_")
        assert fields["active_stretch_" + name] == pytest.approx(
            1 - 0.001 * (i + 1))
        assert fields["fibre_" + name].shape[1] == 3
        assert np.linalg.norm(fields["fibre_" + name], axis=1) == \
            pytest.approx(1, abs=0.01)


def test_a_resolved_file_has_them(folder, tmp_path):
    run_well(folder / "parameters.prm", tmp_path / "out", ranks=2)
    assert (tmp_path / "out/segments.csv").read_text() == \
        (folder / "segments.csv").read_text()
    assert resolved(tmp_path / "out") == resolved(folder)


def test_the_report_has_them_as_text(folder, tmp_path):
    assert main([str(folder), "--output", str(tmp_path), "--only", "kymograph",
                 "report"]) == 0
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "<script" not in report
    assert "a &lt; b &amp; &quot;c&quot; &lt;script&gt;" in report
    assert "Muscles/M&amp;M/" in report


@pytest.mark.parametrize("names, words", [
    (["left arm", "left_arm"], ["'Muscles/left_arm'", "'Muscles/left arm'",
                                "both are 'left_arm'", "Rename one"]),
    (["biceps", "x"], ["'Tissues/flesh/Muscles' has 'biceps' twice"]),
    (["a=b"], ["Names' is 'wall, push, a=b'", "'a=b' has a '='"]),
    (["a/b"], ["line 9", "'subsection a/b' has a '/'"]),
    (["x" * 101], ["has a name of more than 100 characters"]),
    (["alias"], ["'alias' is a word that parameter files keep"]),
    (["Names"], ["'Names' cannot be a name of yours",
                 "Choose another name"]),
])
def test_others_are_refused(names, words, tmp_path):
    result = run(with_muscles(names, tmp_path / "case.prm"), tmp_path / "out")
    assert result.exit_code == 1, result.log
    for word in words:
        assert word in result.message
