# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checkpoints that somebody has made up, with all checksums right.

'table 0 ../victim/thesis.txt' in progress emptied that file, '..' in MANIFEST
read any, 'cells 4294967295 1' ended with a crash, 'time nan' and an empty
progress went on as time 0. Each of them has to be refused, or left out for the
older one, and nothing outside the folder of the run may change."""
import os
import random
import shutil
import struct
import sys
import zlib

import pytest
from lumbricus_run import SOURCE, Run, call, run

sys.path.insert(0, str(SOURCE / "tests" / "errors"))
from mistakes import JARGON  # noqa: E402

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
SETTINGS = ["Checkpoints/Steps=1", "Output/Points=2, 0, 0",
            "Geometry/block/Cells=2, 1, 1", "Mesh/Refine where=1 - x",
            "Mesh/Local refinements=1"]
# The checkpoints of the two last steps, of four in all.
NEWEST, OLDER = "000002", "000001"


def restart(folder, end):
    return Run(call("--restart", folder, "--set", f"Time/End={end}"), folder)


@pytest.fixture(scope="module")
def world(tmp_path_factory):
    """A run, what it comes to when it goes on, and somebody's files beside."""
    base = tmp_path_factory.mktemp("world")
    first = run(BLOCK, base / "run", SETTINGS)
    assert first.exit_code == 0, first.message
    shutil.copytree(base / "run", base / "whole")
    whole = restart(base / "whole", 1.5)
    assert whole.exit_code == 0, whole.message
    (base / "victim").mkdir()
    (base / "victim/thesis.txt").write_text("years of work\n")
    (base / "victim/table.csv").write_text("t\n1\n")
    return base, whole.segments()


def sign(checkpoint):
    """Make all checksums right that a manifest has."""
    manifest = checkpoint / "MANIFEST"
    lines = manifest.read_bytes().split(b"\n")
    lines = [line for line in lines if line and
             not line.startswith(b"checksum ")]
    for i, line in enumerate(lines):
        words = line.split(b" ")
        if words[0] == b"file" and len(words) == 4:
            try:
                path = checkpoint / words[3].decode()
                if not path.is_file() or path.stat().st_size > 1 << 30:
                    continue
                content = path.read_bytes()
            except (OSError, ValueError):
                continue
            lines[i] = b"file %d %d %s" % (zlib.crc32(content), len(content),
                                           words[3])
    text = b"\n".join(lines) + b"\n"
    manifest.write_bytes(text + b"checksum %d\n" % zlib.crc32(text))


def replaced(name, old, new):
    """A change of a text file; old has to be there."""
    def change(checkpoint):
        path = checkpoint / name
        text = path.read_bytes()
        assert old in text, (name, old, text)
        path.write_bytes(text.replace(old, new, 1))
    return change


def line(name, begin, new):
    """Another line in the place of that which begins so; none where new is
    empty."""
    def change(checkpoint):
        path = checkpoint / name
        lines = path.read_bytes().splitlines(keepends=True)
        at = [i for i, text in enumerate(lines) if text.startswith(begin)]
        assert at, (name, begin)
        lines[at[0]] = new
        path.write_bytes(b"".join(lines))
    return change


def added(name, text):
    def change(checkpoint):
        with open(checkpoint / name, "ab") as file:
            file.write(text)
    return change


def added_to_manifest(text):
    return replaced("MANIFEST", b"\nchecksum ", b"\n" + text + b"checksum ")


def whole(name, content):
    return lambda checkpoint: (checkpoint / name).write_bytes(content)


def a_link(name, to):
    def change(checkpoint):
        content = (checkpoint / name).read_bytes()
        other = checkpoint.parent.parent.parent / "elsewhere"
        other.write_bytes(content)
        (checkpoint / name).unlink()
        (checkpoint / name).symlink_to(other if to is None else to)
    return change


def huge(name):
    """A file with a hole of 8 TB."""
    def change(checkpoint):
        with open(checkpoint / name, "r+b") as file:
            file.truncate(8 << 40)
        text = (checkpoint / "MANIFEST").read_text()
        lines = [f"file 0 {8 << 40} {name}" if at.endswith(f" {name}") else at
                 for at in text.splitlines()]
        (checkpoint / "MANIFEST").write_text("\n".join(lines) + "\n")
    return change


def values_of_a_cell(value):
    def change(checkpoint):
        path = checkpoint / "cells.0"
        content = bytearray(path.read_bytes())
        content[16:24] = struct.pack("d", value)
        path.write_bytes(content)
    return change


def a_cell_twice(checkpoint):
    path = checkpoint / "cells.0"
    content = path.read_bytes()
    n = int([text.split()[2] for text in
             (checkpoint / "MANIFEST").read_text().splitlines()
             if text.startswith("cells ")][0])
    size = len(content) // n
    path.write_bytes(content[:size] + content[:len(content) - size])


P, M = "progress", "MANIFEST"
# A name, and what is done to the newest checkpoint before it is signed.
LIES = {
    "a table outside": added(P, b"table 0 0 ../victim/table.csv\n"),
    "a table outside, absolute": added(P, b"table 0 0 /tmp/table.csv\n"),
    "a file that is no table": added(P, b"table 0 0 log.txt\n"),
    "a table nobody writes": added(P, b"table 0 0 mine.csv\n"),
    "a table twice": added(P, b"table 0 0 segments.csv\n"),
    "a table cut to nothing": line(P, b"table ", b"table 0 0 body.csv\n"),
    "a table of 2^64 bytes": line(
        P, b"table ", b"table 18446744073709551615 0 body.csv\n"),
    "a table of 2^64 + 1 bytes": line(
        P, b"table ", b"table 18446744073709551617 0 body.csv\n"),
    "a table of -1 bytes": line(P, b"table ", b"table -1 0 body.csv\n"),
    "a picture outside": line(P, b"vtu ", b"vtu 0 ../victim/thesis.txt\n"),
    "a picture of nan": line(P, b"vtu ", b"vtu nan vtu/solution_00000.pvtu\n"),
    "no picture": line(P, b"vtu ", b""),
    "time nan": line(P, b"time ", b"time nan\n"),
    "time inf": line(P, b"time ", b"time inf\n"),
    "time -1": line(P, b"time ", b"time -1\n"),
    "time 1e999": line(P, b"time ", b"time 1e999\n"),
    "time of two words": line(P, b"time ", b"time 1 1\n"),
    "no time": line(P, b"time ", b""),
    "time twice": added(P, b"time 0.5\n"),
    "a later time": line(P, b"time ", b"time 1e9\n"),
    "step -1": line(P, b"step ", b"step -1\n"),
    "another step": line(P, b"step ", b"step 7\n"),
    "step 2^32": line(P, b"step ", b"step 4294967296\n"),
    "step 0x2": line(P, b"step ", b"step 0x2\n"),
    "step size 0": line(P, b"number step_size ", b"number step_size 0\n"),
    "step size nan": line(P, b"number step_size ", b"number step_size -nan\n"),
    "no step size": line(P, b"number step_size ", b""),
    "step size twice": added(P, b"number step_size 0.5\n"),
    "a number of another control": added(P, b"number radius 0.5\n"),
    "no control": line(P, b"control ", b""),
    "an empty control": line(P, b"control ", b"control\n"),
    "seconds nan": line(P, b"elapsed_seconds ", b"elapsed_seconds nan\n"),
    "a picture that is not sure": line(P, b"vtu_is_", b"vtu_is_current 2\n"),
    "an empty progress": whole(P, b""),
    "a progress of zeros": whole(P, bytes(1000)),
    "a progress without end": whole(P, b"time 1" * 100000),
    "a global that is not the body's": added(P, b"global pressure 1 0.5\n"),
    "a global of nan": added(P, b"global pressure 1 nan\n"),
    "a global of too few": added(P, b"global pressure 2 0.5\n"),
    "a past of now": line(P, b"past ", b"past 1\n"),
    "a past to come": line(P, b"past ", b"past 2\n"),
    "a past of nan": line(P, b"past ", b"past nan\n"),
    "a past that is not there": line(P, b"past ", b""),
    "a past more": added(P, b"past 0.25\n"),
    "a history more": added(P, b"history u_ref2\n"),
    "a history twice": added(P, b"history u_ref\n"),
    "a history less": line(P, b"history ", b""),
    "an item of another version": added(P, b"temperature 300\n"),
    "a file outside": added_to_manifest(b"file 0 0 ../../../victim/thesis.txt\n"),
    "a file of its folder": added_to_manifest(b"file 0 0 .\n"),
    "an absolute file": added_to_manifest(b"file 0 0 /etc/passwd\n"),
    "a file twice": added_to_manifest(b"file 0 0 mesh\n"),
    "cells of rank 2^32-1": added_to_manifest(b"cells 4294967295 1 2000\n"),
    "cells of a rank that is not there": added_to_manifest(b"cells 1 1 2000\n"),
    "too many cells": line(M, b"cells ", b"cells 0 4294967295 2672\n"),
    "too few cells": line(M, b"cells ", b"cells 0 0 2672\n"),
    "cells of no size": line(M, b"cells ", b"cells 0 9 0\n"),
    "cells of another size": replaced(M, b" 2672\n", b" 2671\n"),
    "cells without a size": replaced(M, b" 2672\n", b"\n"),
    "no cells": line(M, b"cells ", b""),
    "no run": line(M, b"run ", b""),
    "another run": line(M, b"run ", b"run " + 32 * b"0" + b"\n"),
    "no version": line(M, b"version ", b""),
    "no parameters": line(M, b"file ", b"file 0 0 nothing\n"),
    "an empty manifest": whole(M, b""),
    "a manifest of zeros": whole(M, bytes(1000)),
    "a link to the cells": a_link("cells.0", None),
    "a link to the manifest": a_link(M, None),
    "a link to progress": a_link(P, None),
    "a device": a_link("mesh", "/dev/zero"),
    "a huge mesh": huge("mesh"),
    "a huge file of cells": huge("cells.0"),
    "half a mesh": whole("mesh", b"cells that are"),
    "half a cell in the mesh": added("mesh", b"\0"),
    "a mesh of everything": added("mesh", bytes(16) * 1000),
    "an input without end": whole("inputs", b"parameter a\n"),
    "an input of another kind": whole("inputs", b"file a\n"),
    "an input that is not there": whole(
        "inputs", b"parameter Geometry/block/Lengths\nname none.msh\n"
        b"path /none.msh\ncontent 1 1\n"),
    "an input of -1 bytes": whole(
        "inputs", b"parameter a\nname b\npath \ncontent -1 0\n"),
    "parameters that include": whole(
        "parameters.prm", b"include /etc/passwd\nset Title = x\n"),
    "parameters of zeros": whole("parameters.prm", bytes(1000)),
    "no text in the parameters": whole("parameters.prm", b""),
    "a state of nan": values_of_a_cell(float("nan")),
    "a state of inf": values_of_a_cell(float("-inf")),
    "a cell twice": a_cell_twice,
}


def outside(base):
    return {str(path): path.read_bytes()
            for path in sorted(base.glob("victim/*"))}


def check(base, rows, folder, name):
    """Exit code 1 and a message, or what the run comes to."""
    before = outside(base)
    run = restart(folder, 1.5)
    everything = run.log + run.message
    assert run.exit_code in (0, 1), (name, run.exit_code, everything)
    assert outside(base) == before, name
    for word in JARGON:
        assert word not in run.message, (name, everything)
    if run.exit_code == 1:
        assert run.message.count("lumbricus: ") == 1, (name, everything)
        return run
    last, expected = run.segments()[-1], rows[-1]
    for key in ("t", "length", "wall_volume"):
        assert last[key] == pytest.approx(expected[key], rel=1e-8), (name, key)
    times = [row["t"] for row in run.segments()]
    assert times == sorted(set(times)), name
    return run


def lie(world, tmp_path, change, signed=True):
    base, rows = world
    folder = shutil.copytree(base / "run", tmp_path / "run", symlinks=True)
    # A path like ../victim leads to the same from here.
    if not (tmp_path / "victim").exists():
        (tmp_path / "victim").symlink_to(base / "victim")
    change(folder / "checkpoints" / NEWEST)
    if signed:
        sign(folder / "checkpoints" / NEWEST)
    return base, rows, folder


# What is found only after a checkpoint was chosen ends the run, because its
# parameters, its inputs or its mesh are not those of the older one.
ENDS = {"a table nobody writes", "a table cut to nothing",
        "a table of 2^64 bytes", "a later time",
        "a global that is not the body's", "an input that is not there",
        "parameters that include", "parameters of zeros",
        "no text in the parameters", "a state of nan", "a state of inf",
        "a cell twice"}


@pytest.mark.parametrize("name", LIES)
def test_a_lie(world, tmp_path, name):
    base, rows, folder = lie(world, tmp_path, LIES[name])
    before = (folder / "segments.csv").read_bytes()
    run = check(base, rows, folder, name)
    if name in ENDS:
        assert run.exit_code == 1, run.log
        # Refused before anything was changed.
        assert (folder / "segments.csv").read_bytes() == before
    else:
        assert run.exit_code == 0, run.message
        assert f"{NEWEST}' cannot be used: it " in run.log, run.log
        assert "after step 1" in run.log


def test_that_a_true_one_is_taken(world, tmp_path):
    """Or none of these tests would say anything."""
    base, rows, folder = lie(world, tmp_path, lambda checkpoint: None)
    run = check(base, rows, folder, "none")
    assert run.exit_code == 0 and "after step 2" in run.log


def test_of_two_lies_none_is_taken(world, tmp_path):
    base, rows, folder = lie(world, tmp_path, LIES["time nan"])
    LIES["time nan"](folder / "checkpoints" / OLDER)
    sign(folder / "checkpoints" / OLDER)
    run = check(base, rows, folder, "both")
    assert run.exit_code == 1
    assert "has no checkpoint to go on from" in run.said()


NASTY = [b"nan", b"-1", b"1e999", b"99999999999999999999", b"4294967295",
         b"../x", b"/etc/passwd", b"", b"\0", b"%s", b"0x1", b"1 1", b"\n",
         b"\xff\xfe", b"A" * 5000, b".", b"inf"]


def test_a_word_or_a_byte_at_random(world, tmp_path):
    """Words of the text files in each other's places, and bytes of all files;
    every second time all is signed."""
    chance = random.Random(18)
    folder = None
    for number in range(40):
        name = chance.choice([P, M, "inputs", "mesh", "cells.0",
                              "parameters.prm"])
        signed = number % 2 == 0 and name in (P, M, "inputs")

        def change(checkpoint):
            content = (checkpoint / name).read_bytes()
            if signed:
                words = content.split(b" ")
                words[chance.randrange(len(words))] = chance.choice(NASTY)
                content = b" ".join(words)
            else:
                at = chance.randrange(max(len(content), 1))
                content = content[:at] + bytes([chance.randrange(256)]) + \
                    content[at + chance.randrange(3):]
            (checkpoint / name).write_bytes(content)

        shutil.rmtree(tmp_path / "run", ignore_errors=True)
        base, rows, folder = lie(world, tmp_path, change, signed)
        check(base, rows, folder, f"number {number}: {name}, signed {signed}")
