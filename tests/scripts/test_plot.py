# SPDX-License-Identifier: LGPL-2.1-or-later
"""lumbricus-plot draws a small run, also one that is still going on, and says
what is wrong with a folder that it cannot draw."""
import base64
import html.parser
import io
import json
import re
import shutil
import subprocess
import sys

import imageio
import pytest
from PIL import Image

from lumbricus_run import SOURCE, run_well

SCRIPTS = SOURCE / "scripts"
sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot import segments  # noqa: E402
from lumbricus.plot.command import main  # noqa: E402
from lumbricus.plot.errors import in_per_cent  # noqa: E402
from lumbricus.plot.run_folder import RunFolder  # noqa: E402

PICTURES = ["picture.png", "kymograph.png", "segments.png",
            "convergence.png"]
TITLE = "Waves <b>& $more$</b>"
FRAMES = 3


def plot(*arguments):
    """As from the command line. Most tests call main instead, since a process
    takes a second to start."""
    return subprocess.run(
        [sys.executable, str(SCRIPTS / "lumbricus-plot"),
         *map(str, arguments)], capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A run of three coarse segments, which nobody changes."""
    return run_well(
        SOURCE / "tests" / "physics" / "chain.prm",
        tmp_path_factory.mktemp("run"),
        ["Output/Every=1", f"Title={TITLE}"])


@pytest.fixture(scope="module")
def report(finished, tmp_path_factory):
    """The folder with all that is drawn of that run."""
    folder = tmp_path_factory.mktemp("report")
    process = plot(finished.folder, "--output", folder, "--fibres",
                   "--frames", FRAMES)
    assert process.returncode == 0, process.stderr
    assert process.stderr == ""
    assert "animation.gif" in process.stdout
    return folder


@pytest.fixture
def copy(finished, tmp_path):
    """A copy of the run to be damaged."""
    return shutil.copytree(finished.folder, tmp_path / "copy")


class Page(html.parser.HTMLParser):
    """Tags, what they refer to, and the text."""

    EMPTY = {"meta", "img", "br"}

    def __init__(self, file_name):
        super().__init__()
        self.open, self.tags, self.references, self.text = [], [], [], []
        self.feed(file_name.read_text(encoding="utf-8"))
        self.close()
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        if tag not in self.EMPTY:
            self.open.append(tag)
        self.references += [value for name, value in attrs if name in
                            ("src", "href", "srcset", "poster", "data",
                             "action", "style")]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def test_pictures(report):
    for name in PICTURES:
        with Image.open(report / name) as image:
            assert image.format == "PNG"
            assert min(image.size) > 300
    with Image.open(report / "animation.gif") as image:
        assert image.n_frames == FRAMES
        frames = []
        for number in range(image.n_frames):
            image.seek(number)
            frames.append(image.convert("RGB"))
    assert len({frame.size for frame in frames}) == 1
    assert len({frame.tobytes() for frame in frames}) == FRAMES
    # Paper stays white in the palette that all frames share.
    assert {frame.getpixel((1, 1)) for frame in frames} == {(255, 255, 255)}


def test_estimated_errors(tmp_path, monkeypatch):
    """Bars of the largest errors, in the report too; without estimates neither."""
    run = run_well(SOURCE / "tests" / "physics" / "chain.prm", tmp_path / "run",
                   ["Output/Every=0", "Output/Errors=1"])
    assert main([str(run.folder), "--only", "errors", "report"]) == 0
    assert Image.open(run.folder / "errors.png").size[0] > 500
    page = (run.folder / "report.html").read_text()
    assert "Estimated errors" in page and "smaller cells would add" in page
    drawn = RunFolder(run.folder)
    rows = run.table("errors.csv")
    largest = max(abs(row["fluid_pressure"]) for row in rows)
    assert abs(in_per_cent(drawn, "fluid_pressure")).max() == pytest.approx(
        100 * max(abs(row["fluid_pressure_error"]) for row in rows) / largest)

    # With few segments the picture of these has bars too, where there are estimates.
    monkeypatch.setattr(segments, "MOST_LINES", drawn.n_segments)
    times, values, sizes = segments.bars(drawn, "length")
    assert segments.bars(drawn, "fluid_volume") is None
    assert list(times) == sorted({row["t"] for row in rows})
    at_first = [row for row in rows if row["t"] == times[0]]
    assert list(values[0]) == [row["length"] for row in at_first]
    assert list(sizes[0]) == [abs(row["length_error"]) for row in at_first]
    drawings = []
    for name in ("with", "without"):
        segments.draw_segments(drawn, tmp_path / f"{name}.png")
        drawings.append((tmp_path / f"{name}.png").read_bytes())
        drawn.errors = None
    assert drawings[0] != drawings[1]

    # Those of steps and resets, apart, without those of the mesh.
    for line in (["Output/Errors of steps=true"],
                 ["Output/Errors of steps=true", "Output/Errors of resets=2"]):
        other = run_well(SOURCE / "parameters" / "viscous_segment" / "case.prm",
                         tmp_path / str(len(line)),
                         [*line, "Output/Every=0", "Time/End=0.1",
                          "Geometry/segment chain/Cells along a segment=2"])
        assert main([str(other.folder), "--only", "errors"]) == 0
        assert Image.open(other.folder / "errors.png").size[0] > 500
        assert abs(in_per_cent(RunFolder(other.folder), "middle_x",
                               "_of_steps")).max() == pytest.approx(
            100 * max(abs(row["middle_x_error_of_steps"]) / row["length"]
                      for row in other.table("errors.csv")), rel=0.1)

    (run.folder / "errors.csv").unlink()
    assert main([str(run.folder), "--only", "errors", "report"]) == 0
    assert "Estimated errors" not in (run.folder / "report.html").read_text()


def test_report_is_in_one_file(report):
    page = Page(report / "report.html")
    assert page.tags.count("iframe") == 1
    assert "script" not in page.tags and "link" not in page.tags
    assert page.tags.count("img") == 4
    for reference in page.references:
        kind, _, data = reference.partition(";base64,")
        assert kind in ("data:image/png", "data:image/gif")
        Image.open(io.BytesIO(base64.b64decode(data))).verify()
    source = re.sub(r"base64,[^\"]*", "", (report / "report.html").read_text())
    assert not re.search(r"https?:|file:|url\(|@import", source)
    # The title is no markup.
    assert "b" not in page.tags
    assert TITLE in page.text


def test_report_has_the_numbers(finished, report):
    text = Page(report / "report.html").text
    rows = finished.segments()
    segments = sorted({row["segment"] for row in rows})

    def of_segment(name, segment):
        return [row[name] for row in rows if row["segment"] == segment]

    def largest_change(name):
        return max(abs(value / of_segment(name, s)[0] - 1)
                   for s in segments for value in of_segment(name, s))

    ratios = [max(of_segment("length", s)) / min(of_segment("length", s))
              for s in segments]
    expected = {
        "largest relative change of a liquid's volume":
            largest_change("fluid_volume"),
        "largest relative change of a wall's volume":
            largest_change("wall_volume"),
        "largest divergence η at the end of a step":
            max(row["eta"] for row in rows),
        "largest ratio of longest to shortest length of a segment":
            max(ratios),
        "least quality of the liquid's mesh":
            min(row["fluid_mesh_quality"] for row in rows),
        "least quality of the wall's mesh":
            min(row["wall_mesh_quality"] for row in rows)}
    for name, value in expected.items():
        # The cell after the name.
        assert text[text.index(name) + 1] == f"{value:.3g}"
    for ratio in ratios:
        assert f"{ratio:.4g}" in text
    # The walls of this case are compressible: there is something to see.
    assert largest_change("wall_volume") > 1e-6


def test_report_has_versions_times_and_parameters(finished, report):
    text = Page(report / "report.html").text
    assert f"{finished.log.splitlines()[0]}, 1 rank" in text
    assert "factorisation" in "".join(text)
    seconds = finished.log.split("Where the time went")[1].split(
        "\n  total")[1].split()[0]
    assert text[text.index("total") + 1] == seconds
    assert any("The run is done." in part for part in text)
    assert "It was not adapted." in text
    named = [part for part in text if part == "Tissues/liquid/Neo-Hooke/a"]
    assert len(named) == 2  # among those that differ, and among all
    assert len([part for part in text if part == "Newton/Force tolerance"]) == 1


def test_run_that_is_going_on(finished, copy):
    # A last line is written in two halves, the last time lacks a segment, and
    # the newest fields are not in solution.pvd.
    (copy / "segments.csv").write_text(
        (copy / "segments.csv").read_text()[:-4])
    for name in ("resets.csv", "steps.csv", "newton.csv", "mesh.csv"):
        with open(copy / name, "a") as file:
            file.write("9,0.9")
    description = json.loads((copy / "run.json").read_text())
    description["status"].update(state="running", step=0, time=0)
    description["where_the_time_went"] = None
    (copy / "run.json").write_text(json.dumps(description))
    # What the run has for people is not needed.
    (copy / "log.txt").unlink()
    (copy / "parameters.prm").unlink()
    names = sorted((copy / "vtu").glob("*.pvtu"))
    names[-1].unlink()
    pvd = (copy / "solution.pvd").read_text()
    (copy / "solution.pvd").write_text(
        re.sub(rf".*{names[-1].name}.*\n", "", pvd))

    assert main([str(copy), "--frames", "2"]) == 0
    text = Page(copy / "report.html").text
    assert any("The run is going on" in part for part in text)
    times = sorted({row["t"] for row in finished.segments()})
    assert any(f"{len(times) - 2} load steps to time {times[-2]:g} of" in part
               for part in text)
    rows = [row for row in finished.segments() if row["t"] < times[-1]]
    assert f"{max(row['eta'] for row in rows):.3g}" in text
    with Image.open(copy / "animation.gif") as image:
        assert image.n_frames == 2


def test_what_was_drawn_goes_with_the_run(copy, tmp_path):
    """A second run in the folder left the report of the first. What the user has
    put there stays."""
    (copy / "poster.png").write_bytes(b"mine")
    for _ in range(2):
        assert main([str(copy), "--only", "segments", "report"]) == 0
    record = (copy / "lumbricus.run").read_text().splitlines()
    for name in ("segments.png", "report.html"):
        assert record.count(f"file {name}") == 1
    # Elsewhere there is no record.
    assert main([str(copy), "--only", "segments", "--output",
                 str(tmp_path / "other")]) == 0
    assert (copy / "lumbricus.run").read_text().splitlines() == record
    run_well(SOURCE / "tests" / "errors" / "block.prm", copy)
    assert not (copy / "segments.png").exists()
    assert not (copy / "report.html").exists()
    assert (copy / "poster.png").read_bytes() == b"mine"


@pytest.fixture
def refused(capsys):
    """lumbricus-plot ends with exit code 1 and one sentence with WORDS."""
    def check(folder, *words, options=()):
        assert main([str(folder), *options]) == 1
        message = capsys.readouterr().err
        assert message.startswith("lumbricus-plot: ")
        assert message.endswith(".\n") and message.count("\n") == 1
        for word in words:
            assert word in message
        assert not (folder / "report.html").exists()

    return check


def test_folder_that_is_no_run(refused, tmp_path):
    refused(tmp_path, "run.json", "give the output folder of a run")
    refused(tmp_path / "nowhere", "run.json")
    process = plot(tmp_path)
    assert process.returncode == 1
    assert process.stderr.count("\n") == 1


def test_tables_that_are_missing_or_empty(refused, copy):
    for name in ("segments.csv", "resets.csv", "steps.csv", "newton.csv",
                 "mesh.csv"):
        table = copy / name
        text = table.read_text()
        table.unlink()
        refused(copy, name, "missing", "run the case again")
        table.write_text("")
        refused(copy, name, "is empty", "wait")
        table.write_text(text.replace(",", ";", 1))
        refused(copy, name, "damaged", "run the case again")
        table.write_text(text)

    table = copy / "segments.csv"
    text = table.read_text()
    table.write_text(text.split("\n")[0] + "\n")
    refused(copy, "segments.csv", "no load step", "wait")
    table.write_text(text.replace("wall_mesh_quality", "other", 1))
    refused(copy, "segments.csv", "'wall_mesh_quality'")
    table.write_text(text)


def test_description_that_is_missing_or_damaged(refused, copy):
    description = copy / "run.json"
    text = description.read_text()
    description.unlink()
    refused(copy, "run.json", "older version", "run the case again")
    description.write_text(text[:-100])
    refused(copy, "run.json", "is damaged", "run the case again")
    description.write_text("[]")
    refused(copy, "run.json", "run the case again")
    description.write_text(text.replace('"symmetry_planes"', '"planes"'))
    refused(copy, "run.json", "'symmetry_planes'", "run the case again")


@pytest.mark.parametrize("state, words", [
    ("interrupted", "The run was interrupted."),
    ("failed", "The run could not go on.")])
def test_report_says_how_the_run_ended(state, words, copy):
    description = json.loads((copy / "run.json").read_text())
    description["status"].update(state=state, message="Because <b>.")
    description["restart"] = {"version": "0.0.7", "step": 2, "time": 0.05}
    (copy / "run.json").write_text(json.dumps(description))
    assert main([str(copy), "--only", "report"]) == 0
    text = Page(copy / "report.html").text
    assert any(words in part for part in text)
    assert "Because <b>." in text
    assert any("from time 0.05 on, until which it was version 0.0.7" in part
               for part in text)
    assert "Since the last restart." in text


def test_fields_that_are_missing(refused, copy):
    next((copy / "vtu").glob("*_00001.pvtu")).unlink()
    refused(copy, "solution_00001.pvtu", "cannot be read", "bring the file")
    (copy / "solution.pvd").write_text("<VTKFile>")
    refused(copy, "solution.pvd", "run the case again")


def test_pieces_that_are_missing_or_damaged(refused, copy):
    pieces = sorted((copy / "vtu").glob("*.vtu"))
    text = pieces[1].read_text()
    pieces[1].write_text(text[:len(text) // 2])
    refused(copy, "solution_00001", "bring the files back")
    pieces[1].unlink()
    refused(copy, "solution_00001", "bring the files back")


def test_film(finished, tmp_path):
    assert main([str(finished.folder), "--output", str(tmp_path), "--mp4",
                 "--frames", str(FRAMES), "--only", "animation", "report"]) == 0
    # A list asks for the number of frames first, which no film tells.
    film = [frame for frame in imageio.get_reader(tmp_path / "animation.mp4")]
    # 25 a second: 0.15 s for each but the last, which stays for one.
    assert abs(len(film) - (4 * (FRAMES - 1) + 25)) <= FRAMES
    assert film[0].min() < 50 and film[0].max() > 250
    assert abs(film[0].astype(float) - film[-1]).max() > 50
    page = Page(tmp_path / "report.html")
    assert page.tags.count("video") == 1 and "img" not in page.tags
    assert sorted(p.name for p in tmp_path.iterdir()) == ["animation.mp4",
                                                          "report.html"]


def test_run_without_fields(finished, copy, capsys):
    (copy / "solution.pvd").unlink()
    assert main([str(copy)]) == 0
    assert "There are no fields yet" in capsys.readouterr().out
    assert not (copy / "picture.png").exists()
    assert Page(copy / "report.html").tags.count("img") == 3
    assert main([str(copy), "--thumbnail", "0"]) == 1
    assert "no fields yet" in capsys.readouterr().err


def without_packages(tmp_path, *options):
    """Call the command of a checkout in a Python that has no packages."""
    scripts = tmp_path / "scripts"
    scripts.mkdir()
    shutil.copy(SCRIPTS / "lumbricus-plot", scripts)
    return subprocess.run(
        [sys.executable, "-I", "-S", str(scripts / "lumbricus-plot"), *options],
        capture_output=True, text=True, timeout=60)


def test_python_without_packages(tmp_path):
    process = without_packages(tmp_path, "RUN")
    assert process.returncode == 1
    assert process.stderr.count("\n") == 1
    assert "is missing; run" in process.stderr
    assert "scripts/set_up_python.sh" in process.stderr


def test_python_of_the_environment_is_found(tmp_path):
    python = tmp_path / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text("#!/bin/sh\necho $@\n")
    python.chmod(0o755)
    process = without_packages(tmp_path, "RUN", "--mesh")
    assert process.returncode == 0
    assert process.stdout == f"{tmp_path}/scripts/lumbricus-plot RUN --mesh\n"


def test_help(capsys):
    with pytest.raises(SystemExit) as end:
        main(["--help"])
    assert end.value.code == 0
    said = capsys.readouterr().out
    for word in ("RUN_DIR", "--frames", "--fibres", "--mp4", "--mesh", "--only",
                 "--times", "--thumbnail", "picture.png", "report.html"):
        assert word in said
