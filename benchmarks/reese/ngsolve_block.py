# SPDX-License-Identifier: LGPL-2.1-or-later
"""The block with NGSolve: ngsolve_block.py CELLS.

Triquadratic displacements; the pressure, linear in every cell, is made of four
constants a cell times 1 and the coordinates about its middle. Pressures and inner nodes
are condensed statically. PARDISO comes with mkl."""
import sys
from importlib import metadata

import ngsolve as ng
import numpy as np
from ngsolve.meshes import MakeStructured3DMesh

import block

N_THREADS = 2


def direct_solver():
    try:
        metadata.version("mkl")
        return "pardiso"
    except metadata.PackageNotFoundError:
        return "sparsecholesky"


def pressures(mesh):
    """The space of four constants a cell, and what makes a pressure of them."""
    constants = ng.L2(mesh, order=0)
    offsets = []
    for x in (ng.x, ng.y, ng.z):
        middle = ng.GridFunction(constants)
        middle.Set(x)
        offsets.append(x - middle)
    return constants**4, lambda c: c[0] + sum(
        c[i + 1] * offset for i, offset in enumerate(offsets))


def energy(u, p):
    F = ng.Id(3) + ng.Grad(u)
    J = ng.Det(F)
    return 0.5 * block.MU * (J**(-2 / 3) * ng.InnerProduct(F, F) - 3) \
        + p * (J - 1) - p**2 / (2 * block.KAPPA)


def solve(n):
    report = block.Report()
    mesh = MakeStructured3DMesh(hexes=True, nx=n, ny=n, nz=n)
    constants, pressure = pressures(mesh)
    # Back and left are x = 0 and y = 0.
    space = ng.VectorH1(mesh, order=2, dirichletx="back|top",
                        dirichlety="left|top", dirichletz="bottom") * constants
    (u, c), _ = space.TnT()
    part = ng.Parameter(0.)
    on_patch = ng.IfPos(0.5 - ng.x, 1, 0) * ng.IfPos(0.5 - ng.y, 1, 0)
    form = ng.BilinearForm(space, condense=True, symmetric=True)
    form += ng.Variation(energy(u, pressure(c)).Compile() * ng.dx)
    form += ng.Variation(block.LOAD * part * on_patch * u[2] *
                         ng.ds(definedon="top"))

    state = ng.GridFunction(space)
    residual, solution = state.vec.CreateVector(), state.vec.CreateVector()
    everything = ng.Projector(space.FreeDofs(), True)
    n_displacements = space.components[0].ndof
    # The values at the vertices; those at other nodes are not unknowns, for the
    # basis is hierarchical.
    at_vertices = [i * (n_displacements // 3) + v
                   for i in range(3) for v in range(mesh.nv)]
    inverse = None

    def residual_norm():
        form.Apply(state.vec, residual)
        residual.data = everything * residual
        return residual[0:n_displacements].Norm()

    def increment_norm():
        nonlocal inverse
        form.AssembleLinearization(state.vec)
        if inverse is None:
            inverse = form.mat.Inverse(space.FreeDofs(coupling=True),
                                       direct_solver())
        else:
            inverse.Update()
        residual.data += form.harmonic_extension_trans * residual
        solution.data = inverse * residual
        solution.data += form.harmonic_extension * solution
        solution.data += form.inner_solve * residual
        state.vec.data -= solution
        return np.linalg.norm(solution.FV().NumPy()[at_vertices])

    places = [mesh(*point) for point in block.POINTS]
    for step in range(1, block.N_STEPS + 1):
        part.Set(step / block.N_STEPS)
        iterations = block.newton(residual_norm, increment_norm)
        report.step(iterations,
                    [state.components[0](place)[2] for place in places])
    report.print(space.ndof)


if __name__ == "__main__":
    ng.SetNumThreads(N_THREADS)
    with ng.TaskManager():
        solve(int(sys.argv[1]))
