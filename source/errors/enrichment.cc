// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/errors/enrichment.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>
#include <deal.II/fe/fe_tools.h>

#include <cmath>
#include <map>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int none   = dealii::numbers::invalid_unsigned_int;
    constexpr unsigned int n_cell = CellUnknowns::n_per_cell;

    // The bulk modulus that takes the place of the volume constraint, in shear
    // moduli: what is wrong with it the next iteration sees.
    constexpr double penalty = 100.;

    // The quadratic that is 1 at i/2 and 0 at the two others of 0, 1/2, 1.
    double
    quadratic(const unsigned int i, const double xi)
    {
      return i == 0 ? 2. * (xi - 0.5) * (xi - 1.) :
             i == 1 ? -4. * xi * (xi - 1.) :
                      2. * xi * (xi - 0.5);
    }



    // Whether a child is the second one in a direction.
    unsigned int
    half(const unsigned int child, const unsigned int d)
    {
      return child >> d & 1;
    }
  } // namespace



  Enrichment::Enrichment(const Body     &small,
                         const Tangent  &tangent,
                         const CutCells &cells)
    : body(small)
    , tangent(tangent)
  {
    number(embed(), cells);
  }



  Enrichment::Nodes
  Enrichment::embed()
  {
    const auto order =
      dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(
        MixedSpace::degree);
    Nodes nodes;
    nodes.fill({none, none});
    for (unsigned int child = 0; child < n_children; ++child)
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        {
          // Where the node is in the large cell, in quarters.
          std::array<unsigned int, dim> x;
          unsigned int                  rest = order[n], n_between = 0;
          for (unsigned int d = 0; d < dim; ++d)
            {
              x[d] = rest % 3 + 2 * half(child, d);
              n_between += x[d] % 2;
              rest /= 3;
            }
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int line = 0; line < n_lines && x[d] % 2 == 1; ++line)
              {
                const double weight =
                  quadratic(line % 3, 0.25 * x[(d + 1) % dim]) *
                  quadratic(line / 3, 0.25 * x[(d + 2) % dim]);
                if (weight == 0.)
                  continue;
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    const unsigned int row = CellUnknowns::displacement(c, n);
                    const unsigned int column =
                      dim * ((d * n_lines + line) * 2 + x[d] / 2) + c;
                    displacement[child].push_back({row, column, weight});
                    if (n_between == 1 && nodes[column].first == none)
                      nodes[column] = {child, row};
                  }
              }
        }

    // x_d x_e without its mean and slopes on the large cell, with x from its
    // middle; the modes of a child are 1 and sqrt(3) (2 xi - 1).
    const double of_slope = 1. / (4. * std::sqrt(3.));
    for (unsigned int child = 0; child < n_children; ++child)
      {
        const auto x = [child](const unsigned int d) {
          return half(child, d) == 1 ? 0.25 : -0.25;
        };
        unsigned int column = 0;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = d; e < dim; ++e, ++column)
            {
              auto &entries = pressure[child];
              entries.push_back({CellUnknowns::pressure(0),
                                 column,
                                 x(d) * x(e) +
                                   (d == e ? 1. / 48. - 1. / 12. : 0.)});
              entries.push_back(
                {CellUnknowns::pressure(1 + d), column, of_slope * x(e)});
              entries.push_back(
                {CellUnknowns::pressure(1 + e), column, of_slope * x(d)});
            }
      }
    return nodes;
  }



  void
  Enrichment::number(const Nodes &nodes, const CutCells &cells)
  {
    const CellUnknowns &unknowns = tangent.unknowns;
    const MPI_Comm      comm     = body.space.communicator();

    std::map<unsigned int, unsigned int> family_of;
    unknowns.reinit_vector(shares);
    for (const OwnedCell cell : body.owned_cells())
      {
        if (cell.is_liquid)
          continue;
        const auto found =
          family_of.emplace(cells.family(cell.index), families.size());
        if (found.second)
          families.emplace_back();
        families[found.first->second].children[cells.child(cell.index)] =
          cell.index;
        for (unsigned int k = 0; k < n_cell; ++k)
          shares.local_element(unknowns.places(cell.index)[k]) += 1.;
      }
    shares.compress(dealii::VectorOperation::add);
    for (double &share : shares)
      share = share > 0. ? 1. / share : 0.;
    shares.update_ghost_values();

    // Nodes that hanging ones follow: the functions would go on beyond the family.
    Vector leads;
    unknowns.reinit_vector(leads);
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      for (unsigned int k = 0; k < n_cell; ++k)
        if (unknowns.is_constrained(i, k))
          for (const auto &[place, weight] : unknowns.row(i, k))
            leads.local_element(place) += std::abs(weight);
    leads.compress(dealii::VectorOperation::add);
    leads.update_ghost_values();

    Vector used;
    unknowns.reinit_vector(used);
    for (Family &family : families)
      for (unsigned int k = 0; k < n_displacements; ++k)
        {
          const unsigned int cell = family.children[nodes[k].first];
          const unsigned int place = unknowns.places(cell)[nodes[k].second];
          family.places[k] = unknowns.is_constrained(cell, nodes[k].second) ||
                                 leads.local_element(place) > 0. ?
                               none :
                               place;
          if (family.places[k] != none)
            used.local_element(family.places[k]) = 1.;
        }
    used.compress(dealii::VectorOperation::add);
    numbering.reinit(used, comm);
  }



  std::vector<double>
  Enrichment::matrix(const Family &family) const
  {
    constexpr unsigned int n       = n_displacements + n_pressures;
    constexpr unsigned int n_modes = MixedSpace::n_pressure_modes;
    std::vector<double>    K, rows(n * n_cell), turned(n_cell * n), all(n * n, 0.);
    for (unsigned int c = 0; c < n_children; ++c)
      {
        tangent.exact_cell_matrix(family.children[c], K);
        // Softer by the penalty.
        const auto   mass = tangent.pressure_mass(family.children[c]);
        const double bulk =
          penalty * tangent.shear_modulus[family.children[c]];
        for (unsigned int k = 0; k < n_modes; ++k)
          for (unsigned int l = 0; l < n_modes; ++l)
            K[CellUnknowns::pressure(k) * n_cell + CellUnknowns::pressure(l)] -=
              mass[k * n_modes + l] / bulk;

        // rows = E^T K and all^T += E^T rows^T, both by whole rows.
        const auto add = [&](const std::vector<double> &from,
                             const unsigned int         width,
                             std::vector<double>       &to) {
          const auto add_entries = [&](const std::vector<Entry> &E,
                                       const unsigned int        begin) {
            for (const Entry &entry : E)
              {
                const double *const source = &from[entry.row * width];
                double *const target = &to[(begin + entry.column) * width];
                for (unsigned int s = 0; s < width; ++s)
                  target[s] += entry.weight * source[s];
              }
          };
          add_entries(displacement[c], 0);
          add_entries(pressure[c], n_displacements);
        };
        rows.assign(n * n_cell, 0.);
        add(K, n_cell, rows);
        for (unsigned int r = 0; r < n; ++r)
          for (unsigned int s = 0; s < n_cell; ++s)
            turned[s * n + r] = rows[r * n_cell + s];
        add(turned, n, all);
      }
    if (!tangent.symmetric)
      for (unsigned int r = 0; r < n; ++r)
        for (unsigned int s = 0; s < r; ++s)
          std::swap(all[r * n + s], all[s * n + r]);
    return all;
  }



  void
  Enrichment::factor()
  {
    constexpr unsigned int n = n_displacements + n_pressures;
    MoreEntries            entries;
    for (Family &family : families)
      {
        const auto all = matrix(family);
        const auto at  = [&](const unsigned int r, const unsigned int s) {
          return all[r * n + s];
        };
        dealii::FullMatrix<double> B(n_pressures, n_displacements);
        family.of_pressures.reinit(n_pressures, n_pressures);
        family.of_displacements.reinit(n_pressures, n_displacements);
        for (unsigned int k = 0; k < n_pressures; ++k)
          {
            for (unsigned int s = 0; s < n_displacements; ++s)
              B(k, s) = at(n_displacements + k, s);
            for (unsigned int l = 0; l < n_pressures; ++l)
              family.of_pressures(k, l) =
                at(n_displacements + k, n_displacements + l);
          }
        family.of_pressures.gauss_jordan();
        family.of_pressures.mmult(family.of_displacements, B);

        // A - B^T C^(-1) B
        for (unsigned int r = 0; r < n_displacements; ++r)
          for (unsigned int s = 0; s < n_displacements; ++s)
            {
              if (family.places[r] == none || family.places[s] == none)
                continue;
              const unsigned int row    = numbering.number(family.places[r]);
              const unsigned int column = numbering.number(family.places[s]);
              if (tangent.symmetric && row < column)
                continue;
              double value = at(r, s);
              for (unsigned int k = 0; k < n_pressures; ++k)
                value -=
                  at(r, n_displacements + k) * family.of_displacements(k, s);
              entries.own.add(row, column, value);
            }
      }
    if (mumps == nullptr)
      {
        mumps = std::make_unique<Mumps<double>>(
          body.space.communicator(),
          Mumps<double>::Options{tangent.symmetric, true, 0.},
          numbering);
        mumps->analyse(tangent.unknowns, 0, 0, entries);
      }
    mumps->begin();
    mumps->add(entries);
    mumps->factor();
  }



  void
  Enrichment::correct(Vector &x, const Vector &r) const
  {
    const CellUnknowns &unknowns = tangent.unknowns;
    Vector              of_nodes;
    unknowns.reinit_vector(of_nodes);
    std::vector<std::array<double, n_pressures>> r_p(families.size());
    r.update_ghost_values();
    for (unsigned int i = 0; i < families.size(); ++i)
      {
        // E^T r, and r_u - B^T C^(-1) r_p.
        const Family &family               = families[i];
        double        r_u[n_displacements] = {};
        r_p[i].fill(0.);
        for (unsigned int c = 0; c < n_children; ++c)
          {
            const unsigned int        cell   = family.children[c];
            const unsigned int *const places = unknowns.places(cell);
            for (const Entry &E : displacement[c])
              if (!unknowns.is_constrained(cell, E.row))
                r_u[E.column] += E.weight *
                                 shares.local_element(places[E.row]) *
                                 r.local_element(places[E.row]);
            for (const Entry &E : pressure[c])
              r_p[i][E.column] += E.weight * r.local_element(places[E.row]);
          }
        for (unsigned int s = 0; s < n_displacements; ++s)
          if (family.places[s] != none)
            {
              for (unsigned int k = 0; k < n_pressures; ++k)
                r_u[s] -= family.of_displacements(k, s) * r_p[i][k];
              of_nodes.local_element(family.places[s]) += r_u[s];
            }
      }
    r.zero_out_ghost_values();
    of_nodes.compress(dealii::VectorOperation::add);

    std::vector<double> values;
    numbering.extract(of_nodes, values);
    mumps->solve(values);
    of_nodes = 0.;
    numbering.insert(values, of_nodes);
    of_nodes.update_ghost_values();

    Vector sum;
    unknowns.reinit_vector(sum);
    for (unsigned int i = 0; i < families.size(); ++i)
      {
        const Family &family             = families[i];
        double        u[n_displacements] = {};
        double        p[n_pressures]     = {};
        for (unsigned int s = 0; s < n_displacements; ++s)
          if (family.places[s] != none)
            u[s] = of_nodes.local_element(family.places[s]);
        for (unsigned int k = 0; k < n_pressures; ++k)
          {
            for (unsigned int l = 0; l < n_pressures; ++l)
              p[k] += family.of_pressures(k, l) * r_p[i][l];
            for (unsigned int s = 0; s < n_displacements; ++s)
              p[k] -= family.of_displacements(k, s) * u[s];
          }
        for (unsigned int c = 0; c < n_children; ++c)
          {
            const unsigned int        cell   = family.children[c];
            const unsigned int *const places = unknowns.places(cell);
            for (const Entry &E : displacement[c])
              if (!unknowns.is_constrained(cell, E.row))
                sum.local_element(places[E.row]) +=
                  E.weight * shares.local_element(places[E.row]) * u[E.column];
            for (const Entry &E : pressure[c])
              sum.local_element(places[E.row]) += E.weight * p[E.column];
          }
      }
    sum.compress(dealii::VectorOperation::add);
    x += sum;
  }
} // namespace lumbricus
