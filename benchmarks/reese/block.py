# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the programs of this benchmark have in common: the numbers of
parameters/block_compression, when Newton's method stops, and the report."""
import json
import time

MU, NU = 80.194, 0.4999
KAPPA = 2 * MU * (1 + NU) / (3 * (1 - 2 * NU))
LOAD = 400.
N_STEPS = 10
FORCE_TOLERANCE, DISPLACEMENT_TOLERANCE = 1e-9, 1e-6
MOST_ITERATIONS = 15
# The middle of the top, its corner, and the middle of an edge.
POINTS = ((0., 0., 1.), (1., 1., 1.), (1., 0., 1.))


def newton(residual_norm, increment_norm):
    """Newton's method for one load step. residual_norm() assembles the residual,
    increment_norm() solves for the increment and adds it; both norms count
    relative to their first. Returns the number of iterations."""
    first_force = residual_norm()
    first_increment = None
    for iteration in range(1, MOST_ITERATIONS + 1):
        increment = increment_norm()
        first_increment = first_increment or increment
        if residual_norm() <= FORCE_TOLERANCE * first_force and \
                increment <= DISPLACEMENT_TOLERANCE * first_increment:
            return iteration
    raise RuntimeError("Newton's method does not converge")


class Report:
    """Collects a run, from the moment it is made, and prints it as JSON."""

    def __init__(self):
        self.start = time.perf_counter()
        self.iterations = 0
        self.displacements = []

    def step(self, iterations, uz_at_points):
        self.iterations += iterations
        self.displacements.append([float(uz) for uz in uz_at_points])
        self.seconds = time.perf_counter() - self.start

    def print(self, unknowns):
        print(json.dumps({"seconds": self.seconds, "unknowns": int(unknowns),
                          "newton_iterations": self.iterations,
                          "displacements": self.displacements}), flush=True)
