# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the linear solvers do on the closed segment of tests/physics/segment.prm: the
tables of doc/solvers.md. Every system is solved to 1e-6 with what is computed from its
own tangent, over one load step with its resets; so the most iterations of a solve are
those of the worst tangent, the first or one after a reset.

  benchmarks/run.sh solvers [TABLE ...]     one of: walls, liquids, sizes, meshes
"""
import re
import sys

from lumbricus_run import SOURCE, run

SEGMENT = SOURCE / "tests" / "physics" / "segment.prm"
PATTERN = re.compile(
    r"rank: (\d+) MB; (\d+) factorisations in ([\d.]+) s, (\d+) linear iterations "
    r"in ([\d.]+) s, (\d+) solves with at most (\d+)")
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
    settings = ["Time/End=0.2", "Time/First step=0.2", f"Linear solver/Method={method}"] + [
        f"Linear solver/{method}/{entry}" for entry in own] + settings
    result = run(SEGMENT, re.sub(r"\W+", "_", f"{name} {method}"), settings, ranks)
    unknowns = re.search(r"(\d+) unknowns", result.log)
    found = PATTERN.search(result.log)
    if result.exit_code != 0 or not found:
        print(f"| {name} | {unknowns.group(1) if unknowns else ''} | {method} "
              "| fails | | | | |", flush=True)
        return
    megabytes, factors, factor_s, iterations, solve_s, solves, most = (
        float(group) for group in found.groups())
    print(f"| {name} | {unknowns.group(1)} | {method} | {iterations / solves:.1f} "
          f"| {most:.0f} | {factor_s / factors:.2f} | {solve_s / iterations:.3f} "
          f"| {megabytes:.0f} |", flush=True)


def walls():
    for t in (0.6, 0.3, 0.15, 0.075, 0.05):
        row(f"wall {t} mm", refined(1) + wall(t))


def liquids():
    for t in (0.3, 0.05):
        for ratio in (1e-1, 1e-2, 1e-3, 1e-4):
            row(f"wall {t} mm, liquid {ratio:g}", refined(1) + wall(t) + liquid(ratio))


def sizes():
    for times in (1, 2, 3):
        for method in ("multigrid", "kept factor"):
            row(f"refined {times} times", refined(times), method)


def meshes():
    for name, settings in (("tied", refined(1)), ("slip", refined(1) + SLIP),
                           ("hanging nodes, tied", HANGING),
                           ("hanging nodes, slip", HANGING + SLIP)):
        for ranks in (1, 2, 4):
            row(f"{name}, {ranks} ranks", settings, ranks=ranks)
    row("additive", refined(1) + ["Linear solver/multigrid/Vanka=additive",
                                  "Linear solver/multigrid/Smoothing sweeps=3",
                                  "Linear solver/multigrid/Damping=0.5"])
    row("cells alone", refined(1) + ["Linear solver/multigrid/Thin=1e9"])


TABLES = {table.__name__: table for table in (walls, liquids, sizes, meshes)}


def main():
    for name in sys.argv[1:] or TABLES:
        print(f"\n{name}\n\n| case | unknowns | method | iterations | most | setup (s) "
              "| one iteration (s) | memory (MB) |\n|---|---|---|---|---|---|---|---|")
        TABLES[name]()


if __name__ == "__main__":
    main()
