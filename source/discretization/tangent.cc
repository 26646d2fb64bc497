// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/tangent.h>

namespace lumbricus
{
  Tangent::Tangent(const MixedSpace   &space,
                   const ShapeCache   &shapes,
                   const CellUnknowns &unknowns)
    : space(space)
    , shapes(shapes)
    , unknowns(unknowns)
  {}



  void
  Tangent::reinit()
  {
    cells.clear();
    cells.resize(shapes.n_owned_cells());
    shear_modulus.assign(shapes.n_owned_cells(), 0.);
    of_surface_cell.assign(shapes.n_owned_cells(), -1);
    surface_matrices.clear();
  }



  void
  Tangent::vmult(Vector &y, const Vector &x) const
  {
    double x_cell[n_per_cell], y_cell[n_per_cell];
    x.update_ghost_values();
    y = 0.;
    for (unsigned int i = 0; i < cells.size(); ++i)
      {
        unknowns.read_free(i, x, x_cell);
        vmult_cell(i, x_cell, y_cell);
        unknowns.add(i, y_cell, y);
      }
    y.compress(dealii::VectorOperation::add);
    x.zero_out_ghost_values();

    const auto &constrained = unknowns.is_constrained();
    for (unsigned int k = 0; k < constrained.size(); ++k)
      if (constrained[k])
        y.local_element(k) = x.local_element(k);
  }



  void
  Tangent::vmult_cell(const unsigned int i, const double *x, double *y) const
  {
    cells[i].vmult(shapes.cell(i), shapes.pressure_modes(), x, y);
    if (of_surface_cell[i] >= 0)
      surface_matrices[of_surface_cell[i]].vmult_add(x, y);
  }



  void
  Tangent::cell_matrix(const unsigned int i, std::vector<double> &K) const
  {
    cell_matrix(i, true, K);
  }



  void
  Tangent::exact_cell_matrix(const unsigned int i, std::vector<double> &K) const
  {
    cell_matrix(i, false, K);
  }



  void
  Tangent::cell_matrix(const unsigned int   i,
                       const bool           for_preconditioner,
                       std::vector<double> &K) const
  {
    cells[i].matrix(
      shapes.cell(i), shapes.pressure_modes(), for_preconditioner, K);
    if (of_surface_cell[i] >= 0)
      surface_matrices[of_surface_cell[i]].add_to(K);
  }



  std::array<double, Tangent::n_per_cell>
  Tangent::diagonal(const unsigned int i) const
  {
    std::array<double, n_per_cell> d;
    cells[i].diagonal(shapes.cell(i), shapes.pressure_modes(), d.data());
    if (of_surface_cell[i] >= 0)
      surface_matrices[of_surface_cell[i]].add_diagonal_to(d.data());
    return d;
  }



  std::array<double,
             MixedSpace::n_pressure_modes * MixedSpace::n_pressure_modes>
  Tangent::pressure_mass(const unsigned int i) const
  {
    constexpr unsigned int n_modes = MixedSpace::n_pressure_modes;
    std::array<double, n_modes * n_modes> M{};
    const double                         *JxW = shapes.cell(i).JxW;
    for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
      {
        const double *psi = shapes.pressure_modes() + n_modes * q;
        for (unsigned int n = 0; n < n_modes; ++n)
          for (unsigned int m = 0; m < n_modes; ++m)
            M[n * n_modes + m] += psi[n] * psi[m] * JxW[q];
      }
    return M;
  }



  CellLinearisation &
  Tangent::cell(const unsigned int i)
  {
    return cells[i];
  }



  void
  Tangent::clear_surface_matrices()
  {
    surface_matrices.clear();
    of_surface_cell.assign(cells.size(), -1);
  }



  std::vector<double> &
  Tangent::surface_matrix(const unsigned int i)
  {
    if (of_surface_cell[i] < 0)
      {
        of_surface_cell[i] = surface_matrices.size();
        surface_matrices.emplace_back();
      }
    return surface_matrices[of_surface_cell[i]].entries();
  }
} // namespace lumbricus
