# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the paper's experiments, and write their table and diagrams.

    LUMBRICUS=build-Release/lumbricus python3 parameters/paper/report.py

prints a table and leaves it, the diagrams and the runs in results/paper.
parameters/paper/run.sh installs and builds what is needed before.
"""
import sys

import diagrams
import experiments


def number(value):
    return "" if value is None else f"{value:.4g}"


def main(folder="results/paper"):
    runs = experiments.Runs(folder, fine=True)
    rows = [row for experiment in experiments.EXPERIMENTS
            for row in experiment(runs)]
    lines = ["| | Paper | Closed form | Lumbricus | |", "|---|---|---|---|---|"]
    lines += [f"| {row.what} | {number(row.paper)} | "
              f"{number(row.closed_form)} | {number(row.ours)} | "
              f"{'' if row.agrees() else 'DIFFERS'} |" for row in rows]
    table = "\n".join(lines) + "\n"
    print(table)
    (runs.folder / "table.md").write_text(table)
    diagrams.draw(runs)
    return 0 if all(row.agrees() for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
