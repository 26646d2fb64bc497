// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/errors/enrichment.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <map>
#include <utility>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int none   = dealii::numbers::invalid_unsigned_int;
    constexpr unsigned int n_cell = CellUnknowns::n_per_cell;

    constexpr unsigned int n               = FamilyFunctions::n;
    constexpr unsigned int n_displacements = FamilyFunctions::n_displacements;
    constexpr unsigned int n_pressures     = FamilyFunctions::n_pressures;

    // The bulk modulus that takes the place of the volume constraint, in shear
    // moduli: what is wrong with it the next iteration sees.
    constexpr double penalty = 100.;
  } // namespace



  Enrichment::Enrichment(const Body     &small,
                         const Tangent  &tangent,
                         const CutCells &cells)
    : body(small)
    , tangent(tangent)
  {
    number(cells);
  }



  void
  Enrichment::number(const CutCells &cells)
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

    const HangingFunctions hanging(body, unknowns, cells, functions);
    Vector                 used, used_by_hanging;
    unknowns.reinit_vector(used);
    used_by_hanging = used;
    for (Family &family : families)
      {
        family.places.assign(n, none);
        for (unsigned int k = 0; k < n_displacements; ++k)
          {
            const auto &[child, unknown] = functions.nodes()[k];
            const unsigned int cell      = family.children[child];
            const unsigned int place     = unknowns.places(cell)[unknown];
            if (unknowns.is_constrained(cell, unknown) || hanging.leads(place))
              continue;
            family.places[k]          = place;
            used.local_element(place) = 1.;
          }
        auto of_family = hanging.of_family(family.children);
        family.hanging = std::move(of_family.entries);
        for (const unsigned int place : of_family.places)
          {
            family.places.push_back(place);
            used_by_hanging.local_element(place) = 1.;
          }
      }
    used.compress(dealii::VectorOperation::add);
    used_by_hanging.compress(dealii::VectorOperation::add);
    for (unsigned int i = 0; i < used_by_hanging.locally_owned_size(); ++i)
      if (used_by_hanging.local_element(i) > 0.)
        of_hanging.push_back(i);
    used += used_by_hanging;
    numbering.reinit(used, comm);
  }



  dealii::FullMatrix<double>
  Enrichment::matrix(const Family &family) const
  {
    constexpr unsigned int     n_modes = MixedSpace::n_pressure_modes;
    dealii::FullMatrix<double> all(family.places.size());
    std::vector<double>        K;
    for (unsigned int c = 0; c < FamilyFunctions::n_children; ++c)
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
        functions.add_matrix(c, K, all);
        if (!family.hanging.empty())
          add_hanging(family, c, K, all);
      }
    return all;
  }



  void
  Enrichment::add_hanging(const Family               &family,
                          const unsigned int          child,
                          const std::vector<double>  &K,
                          dealii::FullMatrix<double> &all) const
  {
    // With X of hanging functions: K X by columns, X^T K by rows.
    const unsigned int  n_hanging = family.places.size() - n;
    std::vector<double> KX(n_hanging * n_cell, 0.), XTK(n_hanging * n_cell, 0.);
    for (const HangingFunctions::Entry &X : family.hanging)
      for (unsigned int k = 0; k < n_cell && X.child == child; ++k)
        {
          KX[X.column * n_cell + k] += X.weight * K[k * n_cell + X.row];
          XTK[X.column * n_cell + k] += X.weight * K[X.row * n_cell + k];
        }
    for (const HangingFunctions::Entry &X : family.hanging)
      for (unsigned int s = 0; s < n_hanging && X.child == child; ++s)
        all(n + X.column, n + s) += X.weight * KX[s * n_cell + X.row];
    for (unsigned int s = 0; s < n_hanging; ++s)
      {
        double column[n] = {}, row[n] = {};
        functions.add_transposed(child, &KX[s * n_cell], column);
        functions.add_transposed(child, &XTK[s * n_cell], row);
        for (unsigned int k = 0; k < n; ++k)
          {
            all(k, n + s) += column[k];
            all(n + s, k) += row[k];
          }
      }
  }



  void
  Enrichment::factor()
  {
    const bool  is_planned = mumps != nullptr;
    MoreEntries entries;
    for (Family &family : families)
      {
        auto all           = matrix(family);
        family.elimination = FamilyFunctions::eliminate_pressures(all);

        std::vector<unsigned int> numbers;
        for (const unsigned int place : family.places)
          numbers.push_back(place == none ? none : numbering.number(place));
        for (unsigned int r = 0; r < numbers.size(); ++r)
          for (unsigned int s = 0; s < numbers.size() && numbers[r] != none; ++s)
            {
              if (numbers[s] == none ||
                  (tangent.symmetric && numbers[r] < numbers[s]))
                continue;
              // Where they are is known from the first time on.
              if (is_planned)
                entries.own.values.push_back(all(r, s));
              else
                entries.own.add(numbers[r], numbers[s], all(r, s));
            }
      }
    if (mumps == nullptr)
      {
        mumps = std::make_unique<Mumps<double>>(
          body.space.communicator(),
          Mumps<double>::Options{tangent.symmetric, !tangent.symmetric, 0.},
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
    std::vector<std::array<double, n>> r_f(families.size());
    double                             of_child[n_cell];
    r.update_ghost_values();
    for (unsigned int i = 0; i < families.size(); ++i)
      {
        // E^T r, and r_u - B^T C^(-1) r_p.
        const Family &family = families[i];
        r_f[i].fill(0.);
        for (unsigned int c = 0; c < FamilyFunctions::n_children; ++c)
          {
            const unsigned int        cell   = family.children[c];
            const unsigned int *const places = unknowns.places(cell);
            for (unsigned int k = 0; k < n_cell; ++k)
              of_child[k] = unknowns.is_constrained(cell, k) ?
                              0. :
                              shares.local_element(places[k]) *
                                r.local_element(places[k]);
            functions.add_transposed(c, of_child, r_f[i].data());
          }
        const auto &of_displacements = family.elimination.of_displacements;
        for (unsigned int s = 0; s < family.places.size(); ++s)
          if (family.places[s] != none)
            {
              double r_u = s < n ? r_f[i][s] : 0.;
              for (unsigned int k = 0; k < n_pressures; ++k)
                r_u -= of_displacements(k, s) * r_f[i][n_displacements + k];
              of_nodes.local_element(family.places[s]) += r_u;
            }
      }
    for (const unsigned int place : of_hanging)
      of_nodes.local_element(place) += r.local_element(place);
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
        const Family       &family = families[i];
        std::vector<double> f(family.places.size(), 0.);
        for (unsigned int s = 0; s < f.size(); ++s)
          if (family.places[s] != none)
            f[s] = of_nodes.local_element(family.places[s]);
        for (unsigned int k = 0; k < n_pressures; ++k)
          {
            double &p = f[n_displacements + k];
            for (unsigned int l = 0; l < n_pressures; ++l)
              p += family.elimination.of_pressures(k, l) *
                   r_f[i][n_displacements + l];
            for (unsigned int s = 0; s < f.size(); ++s)
              if (family.places[s] != none)
                p -= family.elimination.of_displacements(k, s) * f[s];
          }
        for (unsigned int c = 0; c < FamilyFunctions::n_children; ++c)
          {
            const unsigned int        cell   = family.children[c];
            const unsigned int *const places = unknowns.places(cell);
            functions.evaluate(c, f.data(), of_child);
            for (unsigned int k = 0; k < n_cell; ++k)
              if (!unknowns.is_constrained(cell, k))
                sum.local_element(places[k]) +=
                  shares.local_element(places[k]) * of_child[k];
          }
      }
    for (const unsigned int place : of_hanging)
      sum.local_element(place) += of_nodes.local_element(place);
    sum.compress(dealii::VectorOperation::add);
    x += sum;
  }
} // namespace lumbricus
