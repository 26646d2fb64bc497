# SPDX-License-Identifier: LGPL-2.1-or-later
"""The block with FEniCSx (dolfinx 0.5): mpirun -np 2 dolfinx_block.py CELLS.

Triquadratic displacements, pressures linear in every cell, L D L^T of MUMPS."""
import sys

import numpy as np
import ufl
from dolfinx import fem, geometry, mesh
from dolfinx.cpp.mesh import GhostMode
from mpi4py import MPI
from petsc4py import PETSc

import block

COMPILER = {"cffi_extra_compile_args": ["-O3", "-march=native"],
            "cffi_libraries": ["m"]}
# As many points as the others have, 3 x 3 x 3.
QUADRATURE = {"quadrature_degree": 5}
MUMPS = {"ksp_type": "preonly", "pc_type": "cholesky",
         "pc_factor_mat_solver_type": "mumps"}


def energy(u, p):
    F = ufl.Identity(3) + ufl.grad(u)
    J = ufl.det(F)
    return 0.5 * block.MU * (J**(-2 / 3) * ufl.inner(F, F) - 3) \
        + p * (J - 1) - p**2 / (2 * block.KAPPA)


def make_space(n):
    cube = mesh.create_unit_cube(MPI.COMM_WORLD, n, n, n,
                                 mesh.CellType.hexahedron,
                                 ghost_mode=GhostMode.none)
    cell = cube.ufl_cell()
    return cube, fem.FunctionSpace(cube, ufl.MixedElement(
        ufl.VectorElement("Q", cell, 2), ufl.FiniteElement("DPC", cell, 1)))


def constraints(cube, space):
    """Planes x = 0, y = 0, z = 0 hold their normal, the top x and y."""
    planes = ((0, 0., (0,)), (1, 0., (1,)), (2, 0., (2,)), (2, 1., (0, 1)))
    result = []
    for axis, place, components in planes:
        faces = mesh.locate_entities_boundary(
            cube, 2, lambda x, a=axis, c=place: np.isclose(x[a], c))
        for component in components:
            part = space.sub(0).sub(component)
            dofs = fem.locate_dofs_topological(part, 2, faces)
            result.append(fem.dirichletbc(PETSc.ScalarType(0), dofs, part))
    return result


def loaded_faces(cube):
    faces = mesh.locate_entities_boundary(
        cube, 2, lambda x: np.isclose(x[2], 1.) & (x[0] < 0.5 + 1e-9) &
        (x[1] < 0.5 + 1e-9))
    faces = np.sort(faces)
    tags = mesh.meshtags(cube, 2, faces, np.ones(len(faces), dtype=np.int32))
    return ufl.Measure("ds", cube, subdomain_data=tags)(1)


def values_at_points(cube, u):
    """uz at the points, on every rank."""
    tree = geometry.BoundingBoxTree(cube, 3)
    values = []
    for point in np.array(block.POINTS):
        cells = geometry.compute_colliding_cells(
            cube, geometry.compute_collisions(tree, point), point)
        here = u.eval(point, cells[0])[2] if len(cells) else np.inf
        values.append(cube.comm.allreduce(here, MPI.MIN))
    return values


def solve(n):
    report = block.Report()
    cube, space = make_space(n)
    state, test, trial = (fem.Function(space), ufl.TestFunction(space),
                          ufl.TrialFunction(space))
    u, p = ufl.split(state)
    part = fem.Constant(cube, PETSc.ScalarType(0.))
    potential = energy(u, p) * ufl.dx(metadata=QUADRATURE) \
        + block.LOAD * part * u[2] * loaded_faces(cube)
    first = ufl.derivative(potential, state, test)
    form = fem.form(first, jit_params=COMPILER)
    tangent_form = fem.form(ufl.derivative(first, state, trial),
                            jit_params=COMPILER)
    held = constraints(cube, space)

    matrix = fem.petsc.create_matrix(tangent_form)
    matrix.setOption(PETSc.Mat.Option.SYMMETRIC, True)
    residual = fem.petsc.create_vector(form)
    solution = residual.duplicate()
    solver = PETSc.KSP().create(cube.comm)
    options = PETSc.Options()
    for name, value in MUMPS.items():
        options[name] = value
    solver.setFromOptions()
    solver.setOperators(matrix)

    _, displacement_dofs = space.sub(0).collapse()
    owned = space.dofmap.index_map.size_local * space.dofmap.index_map_bs
    displacement_dofs = np.array([i for i in displacement_dofs if i < owned])

    def norm_of_displacements(vector):
        part_here = np.sum(vector.array[displacement_dofs]**2)
        return np.sqrt(cube.comm.allreduce(part_here, MPI.SUM))

    def residual_norm():
        with residual.localForm() as local:
            local.set(0.)
        fem.petsc.assemble_vector(residual, form)
        residual.ghostUpdate(PETSc.InsertMode.ADD, PETSc.ScatterMode.REVERSE)
        fem.petsc.set_bc(residual, held, scale=0.)
        return norm_of_displacements(residual)

    def increment_norm():
        matrix.zeroEntries()
        fem.petsc.assemble_matrix(matrix, tangent_form, held)
        matrix.assemble()
        solver.solve(residual, solution)
        state.vector.axpy(-1., solution)
        state.x.scatter_forward()
        return norm_of_displacements(solution)

    for step in range(1, block.N_STEPS + 1):
        part.value = step / block.N_STEPS
        iterations = block.newton(residual_norm, increment_norm)
        report.step(iterations, values_at_points(cube, state.sub(0).collapse()))
    return report, space.dofmap.index_map.size_global


if __name__ == "__main__":
    # A first solve compiles the forms, which are the same for all meshes.
    solve(2)
    result, n_unknowns = solve(int(sys.argv[1]))
    if MPI.COMM_WORLD.rank == 0:
        result.print(n_unknowns)
