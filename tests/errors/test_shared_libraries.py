# SPDX-License-Identifier: LGPL-2.1-or-later
"""'Additional shared libraries': what is wrong with a library is said in one
message before anything is done, on all ranks alike; one that is right adds to
what there is to choose from, whatever names it."""
import json
import os
import pathlib
import re
import shutil
import subprocess

import pytest
from lumbricus_run import call, go_on, outline, run, run_well
from mistakes import check_one_message, names, on_ranks, run_all

BLOCK = pathlib.Path(__file__).resolve().parent / "block.prm"
PLUGINS = pathlib.Path(os.environ["PLUGINS"])
STILL = PLUGINS / "libstill.so"
TAKEN = PLUGINS / "libtaken_name.so"
ENTRY = "Additional shared libraries"
CHOICE = "Muscles/biceps/Active stretch"

# "lumbricus VERSION (deal.II VERSION, BUILD TYPE)"
VERSION = call("--version").stdout.strip()


def built_for(other):
    """A library that was built for another version, as its file says."""
    def make(folder):
        here, there = VERSION, other(VERSION)
        assert here != there
        content = STILL.read_bytes()
        assert content.count(b"\0plug-in of " + here.encode() + b"\0") == 1
        path = folder / "other.so"
        path.write_bytes(content.replace(
            here.encode(), there.encode().ljust(len(here), b"\0")))
        assert path.stat().st_size == len(content)
        return path
    return make


def file_of(content):
    def make(folder):
        path = folder / "file.so"
        path.write_bytes(content)
        return path
    return make


def folder_itself(folder):
    return folder


def copies(folder):
    """Two files with the same class."""
    paths = [folder / name for name in ("one.so", "two.so")]
    for path in paths:
        shutil.copy(STILL, path)
    return ", ".join(map(str, paths))


def path(given):
    return lambda folder: given


# Name; what the parameter is, in a folder for it; words of the message.
MISTAKES = [
    ("no file", path("nowhere/mine.so"),
     ["'nowhere/mine.so', which cannot be read: No such file or directory",
      "from the working directory"]),
    ("folder", folder_itself, ["which cannot be read: it is a folder"]),
    ("second of two", path(f"{STILL}, mine.so"),
     ["'mine.so', which cannot be read: No such file"]),
    ("text", file_of(b"a law of my own\n" * 40),
     ["file.so', which cannot be loaded: ", "invalid ELF header",
      "lumbricus_add_plugin()", "doc/extending.md"]),
    ("empty", file_of(b""), ["which cannot be loaded: ", "file too short"]),
    ("no plug-in", path(os.environ["LIBRARY"]),
     ["which does not say what it was built for", "lumbricus_add_plugin()"]),
    ("cut", lambda folder: file_of(
        STILL.read_bytes()[:STILL.stat().st_size // 2])(folder),
     ["file.so', which "]),
    ("undefined symbol", path(PLUGINS / "libincomplete.so"),
     ["which cannot be loaded: ", "undefined symbol: ", "left_out_by_mistake"]),
    ("another version", built_for(lambda text: text.replace(" 0.", " 9.", 1)),
     ["other.so', which was built for lumbricus 9.", "but this is lumbricus 0.",
      "Build it anew"]),
    ("another deal.II", built_for(
        lambda text: text.replace("deal.II ", "deal.II 1", 1)[:-2] + ")"),
     ["which was built for lumbricus 0.", "(deal.II 1", "but this is "]),
    ("another build type", built_for(
        lambda text: re.sub("Debug|Release", "Fast", text)),
     ["which was built for lumbricus 0.", ", Fast), but this is "]),
    ("no registration", path(PLUGINS / "libnothing.so"),
     ["libnothing.so', which registers nothing", "Register<...>"]),
    ("name of the program's", path(TAKEN),
     ["libtaken_name.so', but with it the name 'wave' is that of two classes of "
      "lumbricus::Activation: ", "WaveActivation in '", "liblumbricus.so'",
      "Still in '", "libtaken_name.so'. Choose another name"]),
    ("name of another library", copies,
     ["two.so', but with it the name 'still' is that of two classes of ",
      "Still in '", "one.so' and ", "two.so'. Choose another"]),
]
CASES = on_ranks(MISTAKES, ["no file", "text", "undefined symbol",
                            "another build type", "no registration",
                            "name of another library"])


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    def start(mistake, ranks, folder, run_one):
        _, make, _ = mistake
        folder.mkdir()
        return run_one(BLOCK, folder / "out", [f"{ENTRY}={make(folder)}"], ranks)

    found = run_all(start, CASES, tmp_path_factory.mktemp("libraries"))
    return dict(zip(names(CASES), found))


@pytest.mark.parametrize("mistake, ranks", CASES, ids=names(CASES))
def test_message(mistake, ranks, results):
    result = results[names([(mistake, ranks)])[0]]
    check_one_message(result, [f"Parameter '{ENTRY}' names '", *mistake[-1]])


def test_two_of_a_name_are_no_program():
    """Where the linker brings them together: exit code 1 at the start."""
    process = subprocess.run(
        [os.environ["LUMBRICUS"], "--version"], capture_output=True, text=True,
        timeout=60, env=dict(os.environ, LD_PRELOAD=str(TAKEN)))
    assert process.returncode == 1 and process.stdout == ""
    assert "In this program the name 'wave' is that of two classes of " \
        "lumbricus::Activation" in process.stderr
    assert "WaveActivation in '" in process.stderr
    assert "Still in '" in process.stderr


@pytest.mark.parametrize("listed, environment", [
    (str(STILL), {}), (f"{STILL}, {STILL}", {}),
    (str(STILL), {"LD_PRELOAD": str(STILL)})],
    ids=["once", "twice", "in the program already"])
def test_a_library_is_loaded_once(listed, environment, tmp_path):
    process = subprocess.run(
        [os.environ["LUMBRICUS"], "--check", BLOCK, "--set", f"{CHOICE}=still",
         "--set", f"{ENTRY}={listed}"], capture_output=True, text=True,
        timeout=60, cwd=tmp_path, env={**os.environ, **environment})
    assert process.returncode == 0, process.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ["prm", "json", "included"])
def test_what_names_a_library(kind, tmp_path):
    """The library comes first, wherever its name stands in the file."""
    shutil.copy(STILL, tmp_path / "mine.so")
    parts = re.match("(.*Active stretch = )expression.*?end(.*)",
                     BLOCK.read_text(), flags=re.S)
    text = f"{parts[1]}still{parts[2]}"
    case = tmp_path / "case.prm"
    settings = []
    if kind == "prm":
        case.write_text(f"{text}\nset {ENTRY} = ./mine.so\n")
    elif kind == "included":
        (tmp_path / "libraries.prm").write_text(f"set {ENTRY} = mine.so\n")
        case.write_text("include libraries.prm\n" + text)
    else:
        case = tmp_path / "case.json"
        case.write_text(json.dumps({"Title": "x", ENTRY: ["mine.so"]}))
        settings = [word for name, value in outline(text).items()
                    for word in ("--set", f"{name}={value}")]
    result = call("--check", case, *settings, folder=tmp_path)
    assert result.returncode == 0, result.stderr

    result = call("--check", case, *settings, "--set", f"{ENTRY}=",
                  folder=tmp_path)
    assert result.returncode == 1
    assert f"'{CHOICE}' is 'still', but has to be one of" in result.stderr


def test_parameters_of_a_library(tmp_path):
    section = "Muscles/<muscle>/still/Patience"
    case = tmp_path / "case.prm"
    case.write_text(f"set {ENTRY} = {STILL}\nset Titel = not looked at\n")
    for arguments in ([case], ["--set", f"{ENTRY}={STILL}"]):
        result = call("--parameters", *arguments)
        assert result.returncode == 0, result.stderr
        assert outline(result.stdout)[section] == "2"
        assert "'still': a muscle that does nothing." in result.stdout
    result = call("--parameters")
    assert result.returncode == 0
    values = outline(result.stdout)
    assert section not in values and values[ENTRY] == ""

    result = call("--parameters", "--set", f"{ENTRY}={TAKEN}")
    assert result.returncode == 1 and result.stdout == ""
    assert "'wave' is that of two classes" in result.stderr
    # The others do not wait for the rank that prints.
    result = run(case, tmp_path / "out", options=["--parameters"], ranks=2)
    assert result.exit_code == 0 and result.log.count("set Patience") == 1


def test_restart(tmp_path):
    """The library is that of the checkpoint, from wherever the run goes on."""
    library = tmp_path / "mine.so"
    shutil.copy(STILL, library)
    folder = tmp_path / "out"
    settings = [f"{ENTRY}={library}", f"{CHOICE}=still", "Time/End=0.5",
                "Checkpoints/Steps=1"]
    run_well(BLOCK, folder, settings)
    settings[2] = "Time/End=1"
    whole = run_well(BLOCK, tmp_path / "whole", settings)

    content = library.read_bytes()
    library.write_bytes(content + b"\0")
    refused = call("--restart", folder, "--set", "Time/End=1")
    assert refused.returncode == 1
    assert f"mine.so' (parameter '{ENTRY}') is not the one that the checkpoint " \
        "was made with: it has changed since" in refused.stderr
    library.write_bytes(content)
    result = go_on(folder, ["Time/End=1"])
    assert (folder / "segments.csv").read_text() == \
        (whole.folder / "segments.csv").read_text()
    assert result.last()["t"] == 1
