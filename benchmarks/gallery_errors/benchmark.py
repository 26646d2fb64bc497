# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error bars of the cases of the gallery: of lengths, radii and pressures of segments
what Output/Errors estimates, the largest of all segments and times, in percent of the
largest value; of other numbers, and where there are no estimates, how much they change
on one finer mesh and with steps half as long. Each on one rank.

  benchmarks/run.sh gallery_errors [NAME ...] [--write]

with folders of parameters/ for which it is done, by default all. What is found is kept
in results/gallery_errors; --write puts all of that into doc/accuracy.md and the READMEs.
"""
import argparse
import contextlib
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import time

from cases import CASES
from lumbricus_run import SOURCE, run

COLUMNS = ("length", "mid_radius", "fluid_pressure")
HEADER = ("unknowns", "length", "radius", "pressure", "other numbers")
PAGE = SOURCE / "doc" / "accuracy.md"
TIMEOUT = 7200


def percent(part):
    return "–" if part is None or not math.isfinite(part) else \
        "< 0.001 %" if part < 1e-5 else f"{100 * part:.2g} %"


@contextlib.contextmanager
def served(case):
    """Beside its controller, if it has one: the case names the address."""
    if not case.controller:
        yield
        return
    address = SOURCE / f"{case.name}.sock"
    address.unlink(missing_ok=True)
    with subprocess.Popen([sys.executable, SOURCE / "parameters" / case.name /
                           "controller.py", address]) as controller:
        try:
            while not address.exists() and controller.poll() is None:
                time.sleep(0.1)
            yield
        finally:
            controller.kill()
            address.unlink(missing_ok=True)


def compute(case, folder, what, settings):
    """A run of a case, which may end at a limit point."""
    name = case.file.removesuffix(".prm").replace("/", "-")
    with served(case):
        result = run(SOURCE / "parameters" / case.file, folder / f"{name}-{what}",
                     ["Output/Every=0", *case.settings, *settings],
                     timeout=TIMEOUT)
    if result.exit_code != 2 * case.may_stop:
        raise RuntimeError(result.log + result.message)
    print(name, what, *case.settings, *settings, f"{result.costs()['seconds']:.0f} s",
          file=sys.stderr, flush=True)
    return result


def estimated(result):
    """The largest errors of all segments and times, of the largest value; None where
    no segment has the number."""
    rows = result.table("errors.csv")

    def largest(column):
        return max((abs(row[column]) for row in rows
                    if math.isfinite(row[column])), default=0)
    return [largest(f"{name}_error") / largest(name)
            if largest(name) > 0 else None for name in COLUMNS]


def half_steps(result):
    """The settings of steps half as long as those of a run."""
    of_run = {entry["path"]: entry["value"] for entry in json.loads(
        (result.folder / "run.json").read_text())["parameters"]}
    return [f"{path}={of_run[path] / 2:g}"
            for path in ("Time/First step", "Time/Largest step")]


def measure(case, folder):
    """What is kept of a case."""
    result = compute(case, folder, "as it is",
                     [f"Output/Errors={case.every}"] if case.every else [])
    found = {"unknowns": int(result.table("mesh.csv")[-1]["unknowns"]),
             "estimated": estimated(result) if case.every else [None] * 3}
    number = case.number
    if number is not None:
        value = number.of(result)
        halved = half_steps(result) if number.halved is None else number.halved
        found["number"] = value
        found["changes"] = {
            what: abs(number.of(compute(case, folder, what, settings)) / value - 1)
            for what, settings in (("finer mesh", number.finer),
                                   ("half the steps", halved)) if settings}
    return found


def row(case, found):
    other = f"{case.number.words}: " + ", ".join(
        f"{what} {percent(change)}" for what, change in found["changes"].items()
    ) if case.number else ""
    return [case.rest, f"{found['unknowns']:,}",
            *(percent(part) for part in found["estimated"]), other]


def table(first, rows):
    return "\n".join(f"| {' | '.join(cells)} |".replace("  |", " |") for cells in (
        [*first, *HEADER], ["---"] * (len(first) + len(HEADER)), *rows)) + "\n"


def write(page, text):
    """In place of the table below the words that name this benchmark."""
    old = page.read_text(encoding="utf-8")
    new, n = re.subn(r"(    benchmarks/run\.sh gallery_errors\b[^\n]*\n\n)"
                     r"(?:\|[^\n]*\n)*", lambda found: found[1] + text, old)
    if n != 1:
        raise RuntimeError(f"{page} has no place for the table, or several")
    page.write_text(new, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--write", action="store_true",
                        help="what is kept, without a run where no NAME is given")
    options = parser.parse_args()
    folder = pathlib.Path.cwd()
    # Cases name their files from the top folder.
    os.chdir(SOURCE)
    kept = {}
    for case in CASES:
        file = folder / f"{case.file.replace('/', '-')}.json"
        if case.name in options.names or not (options.names or options.write):
            file.write_text(json.dumps(measure(case, folder)))
        if file.exists():
            kept[case] = json.loads(file.read_text())
    everything = [[f"[{case.name}](../parameters/{case.name}/README.md)",
                   *row(case, found)] for case, found in kept.items()]
    print(table(["case", "file"], everything))
    if options.write:
        write(PAGE, table(["case", "file"], everything))
        for name in {case.name for case in kept}:
            write(SOURCE / "parameters" / name / "README.md", table(
                ["file"], [row(case, found) for case, found in kept.items()
                           if case.name == name]))


if __name__ == "__main__":
    main()
