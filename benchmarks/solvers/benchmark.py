# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the linear solvers do on the closed segment of tests/physics/segment.prm: the
tables of doc/solvers.md. Every system is solved to 1e-6 with what is computed from its
own tangent, over one load step with up to five resets (where these do not suffice
the row says so, and counts what was solved until then); so the most iterations of a solve are
those of the worst tangent, the first or one after a reset.

  benchmarks/run.sh solvers [--refined TIMES] [TABLE ...]

with tables among walls, liquids, sizes, meshes, on meshes refined once unless said
otherwise (40,000 unknowns with 2: ten times as long).
"""
import argparse
import re

from lumbricus_run import SOURCE, run

SEGMENT = SOURCE / "tests" / "physics" / "segment.prm"
PATTERN = re.compile(
    r"linear solver +[\d.]+ +\d+% +(\d+)\n"
    r" +factorisation +([\d.]+) +\d+% +(\d+)\n"
    r" +iterations +([\d.]+) +\d+% +(\d+)\n"
    r"(?:.*\n)*?Peak memory of the largest rank: (\d+) MB.\n"
    r"Most iterations of a linear solve: (\d+)")
SLIP = ["Interface/Coupling=slip"]
HANGING = ["Mesh/Global refinements=1", "Mesh/Local refinements=1",
           "Mesh/Refine where=x-1.5"]


def wall(thickness):
    return [f"Geometry/segment chain/{name}={thickness}"
            for name in ("Wall layer thicknesses", "Cap thickness")]


def refined(times):
    return [f"Mesh/Global refinements={times}"]


def liquid(ratio):
    return [f"Tissues/liquid/Neo-Hooke/a={0.23 * ratio:g}"]


def row(name, settings, method="multigrid", ranks=1):
    own = ["Least accuracy=1e-6", "Keep=false", "Most iterations=150"]
    if method == "multigrid":
        own.append("Coarsest unknowns=1000")
    settings = ["Time/End=0.1", "Time/First step=0.1", "Time/Smallest step=0.1",
                "Reset/Every=solve", "Reset/Limit=5", "Newton/Increment tolerance=1e-7",
                f"Linear solver/Method={method}"] + [
        f"Linear solver/{method}/{entry}" for entry in own] + settings
    result = run(SEGMENT, re.sub(r"\W+", "_", f"{name} {method}"), settings, ranks)
    unknowns = re.search(r"(\d+) unknowns", result.log)
    found = PATTERN.search(result.log)
    if result.exit_code != 0:
        name += ", not hydrostatic" if "not hydrostatic" in result.message else ", fails"
    if not found:
        print(f"| {name} | {unknowns.group(1) if unknowns else ''} | {method} "
              "| fails | | | | |", flush=True)
        return
    solves, factor_s, factors, solve_s, iterations, megabytes, most = (
        float(group) for group in found.groups())
    print(f"| {name} | {unknowns.group(1)} | {method} | {iterations / solves:.1f} "
          f"| {most:.0f} | {factor_s / factors:.2f} | {solve_s / iterations:.3f} "
          f"| {megabytes:.0f} |", flush=True)


def walls(times):
    for t in (0.6, 0.3, 0.15, 0.075, 0.05):
        row(f"wall {t} mm", refined(times) + wall(t))


def liquids(times):
    for t in (0.3, 0.05):
        for ratio in (1e-1, 1e-2, 1e-3, 1e-4):
            row(f"wall {t} mm, liquid {ratio:g}", refined(times) + wall(t) + liquid(ratio))


def sizes(largest):
    for times in range(1, largest + 1):
        for method in ("multigrid", "kept factor"):
            row(f"refined {times} times", refined(times), method)


def meshes(times):
    for name, settings in (("tied", refined(times)),
                           ("slip", refined(times) + SLIP),
                           ("hanging nodes, tied", HANGING),
                           ("hanging nodes, slip", HANGING + SLIP)):
        for ranks in (1, 2, 4):
            row(f"{name}, {ranks} ranks", settings, ranks=ranks)
    row("additive", refined(times) + ["Linear solver/multigrid/Vanka=additive",
                                  "Linear solver/multigrid/Smoothing sweeps=3",
                                  "Linear solver/multigrid/Damping=0.5"])
    row("cells alone", refined(times) + ["Linear solver/multigrid/Thin=1e9"])


TABLES = {table.__name__: table for table in (walls, liquids, sizes, meshes)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--refined", type=int, default=1)
    parser.add_argument("tables", nargs="*", metavar="TABLE",
                        help=", ".join(TABLES))
    arguments = parser.parse_args()
    for name in arguments.tables or TABLES:
        print(f"\n{name}\n\n| case | unknowns | method | iterations | most | setup (s) "
              "| one iteration (s) | memory (MB) |\n|---|---|---|---|---|---|---|---|")
        TABLES[name](arguments.refined)


if __name__ == "__main__":
    main()
