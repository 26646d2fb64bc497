// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/multigrid/v_cycle.h>
#include <lumbricus/parameters/patterns.h>

#include <algorithm>
#include <map>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_per_cell;
  }



  void
  VCycleParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Coarsest unknowns",
                      n_coarsest,
                      "[number] A mesh with at most so many unknowns is not "
                      "coarsened further but factored.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Smoothing sweeps",
                      n_sweeps,
                      "[number] Sweeps over the cells before and after the "
                      "correction by a coarser mesh.",
                      dealii::Patterns::Integer(1, 100));
    prm.add_parameter("Coarse cycles",
                      n_coarse_cycles,
                      "[number] Corrections by a coarser mesh in each cycle: 1 "
                      "is a V-cycle, 2 a W-cycle.",
                      dealii::Patterns::Integer(1, 10));
    prm.add_parameter("Damping",
                      damping,
                      "[-] Which part of a cell's correction is taken.",
                      dealii::Patterns::Double(0., 2.));
    prm.add_parameter("Thin",
                      thin,
                      "[-] Where cells of the unrefined mesh are longer than "
                      "thick by more than this, the smoother takes those above "
                      "each other together.",
                      dealii::Patterns::Double(1.));
    prm.add_parameter("Vanka",
                      vanka,
                      "Whether a cell sees the corrections of the cells before "
                      "it in a sweep (multiplicative), or not (additive: more "
                      "sweeps, each of a third of the cost).",
                      dealii::Patterns::Selection("multiplicative|additive"));
  }



  VCycle::VCycle(const Tangent &tangent, const VCycleParameters &parameters)
    : tangent(tangent)
    , parameters(parameters)
    , comm(tangent.space.communicator())
  {
    hierarchy.reinit(tangent.space,
                     tangent.unknowns,
                     parameters.n_coarsest,
                     parameters.thin);
    const unsigned int n_levels = hierarchy.n_levels();
    smoothed.resize(n_levels);
    for (unsigned int l = 1; l < n_levels; ++l)
      {
        const Level &level = hierarchy.level(l);
        smoothed[l]        = std::make_unique<Smoothed>();
        Smoothed &on       = *smoothed[l];
        on.matrix.reinit(*level.unknowns, level.n_owned_cells, comm);
        on.smoother.reinit(on.matrix,
                           level.patches,
                           {parameters.vanka == "multiplicative",
                            parameters.damping});
        on.matrix.reinit_vector(on.x);
        on.matrix.reinit_vector(on.b);
        for (Vector *x : {&on.defect, &on.work, &on.weight})
          level.unknowns->reinit_vector(*x);
        for (Vector *x : {&on.coarse_x, &on.coarse_b})
          hierarchy.level(l - 1).unknowns->reinit_vector(*x);
        const auto &constrained = level.unknowns->is_constrained();
        for (unsigned int i = 0; i < level.n_owned_cells; ++i)
          for (unsigned int k = 0; k < n_per_cell; ++k)
            on.weight.local_element(level.unknowns->places(i)[k]) += 1.;
        on.weight.compress(dealii::VectorOperation::add);
        for (unsigned int k = 0; k < constrained.size(); ++k)
          {
            double &w = on.weight.local_element(k);
            w         = constrained[k] || w == 0. ? 0. : 1. / w;
          }
      }
    numbering.reinit(*hierarchy.level(0).unknowns, true, comm);
    mumps = std::make_unique<Mumps<double>>(
      comm, Mumps<double>::Options{tangent.symmetric, true, 0.}, numbering);
    mumps->analyse(*hierarchy.level(0).unknowns,
                   hierarchy.level(0).n_owned_cells,
                   0);
    coarse_matrices.resize(n_levels - 1);
    for (unsigned int l = 0; l + 1 < n_levels; ++l)
      coarse_matrices[l].resize(hierarchy.level(l).n_cells);
  }



  void
  VCycle::factor()
  {
    for (auto &matrices : coarse_matrices)
      for (auto &matrix : matrices)
        matrix.assign(n_per_cell * n_per_cell, 0.);

    std::vector<double> K;
    for (unsigned int l = hierarchy.n_levels(); l-- > 0;)
      {
        const Level &level = hierarchy.level(l);
        if (l > 0)
          smoothed[l]->matrix.begin();
        else
          mumps->begin();
        for (unsigned int i = 0; i < level.n_owned_cells; ++i)
          {
            if (l + 1 == hierarchy.n_levels())
              tangent.cell_matrix(i, K);
            else
              K = coarse_matrices[l][i];
            if (l > 0)
              {
                std::vector<double> &parent =
                  coarse_matrices[l - 1][level.parent[i]];
                if (level.child[i] >= 0)
                  embedding.add_galerkin(level.child[i], K, parent);
                else
                  parent = K;
              }
            level.unknowns->apply_constraints(i, K);
            if (l > 0)
              smoothed[l]->matrix.add(i, K);
            else
              mumps->add(level.unknowns->free_unknowns(i).size(), K.data());
          }
        if (l > 0)
          {
            smoothed[l]->matrix.finish();
            smoothed[l]->smoother.invert();
            gather_split(l - 1);
          }
        else
          mumps->factor();
      }
  }



  void
  VCycle::gather_split(const unsigned int l)
  {
    // To the owner of a cell goes what other ranks have of its matrix.
    const Level                                &level = hierarchy.level(l);
    std::map<unsigned int, std::vector<double>> send;
    for (unsigned int k = 0; k < level.owner.size(); ++k)
      {
        auto       &message = send[level.owner[k]];
        const auto &matrix  = coarse_matrices[l][level.n_owned_cells + k];
        message.push_back(level.split_number[k]);
        message.insert(message.end(), matrix.begin(), matrix.end());
      }
    std::map<unsigned int, unsigned int> cell_with(level.split_cells.begin(),
                                                   level.split_cells.end());
    for (const auto &[rank, message] :
         dealii::Utilities::MPI::some_to_some(comm, send))
      for (auto at = message.begin(); at != message.end();)
        {
          auto &matrix =
            coarse_matrices[l][cell_with.at(static_cast<unsigned int>(*at++))];
          for (double &entry : matrix)
            entry += *at++;
        }
  }



  void
  VCycle::prolongate_and_add(const unsigned int l,
                             const Vector      &coarse,
                             Vector            &fine) const
  {
    const Level &below  = hierarchy.level(l);
    const Level &above  = hierarchy.level(l + 1);
    Vector      &sum    = smoothed[l + 1]->work;
    const auto  &weight = smoothed[l + 1]->weight;
    double       on_parent[n_per_cell], on_child[n_per_cell];

    // An unknown gets the mean of what its cells say, which is the same.
    sum = 0.;
    coarse.update_ghost_values();
    for (unsigned int i = 0; i < above.n_owned_cells; ++i)
      {
        below.unknowns->read_free(above.parent[i], coarse, on_parent);
        if (above.child[i] >= 0)
          embedding.embed(above.child[i], on_parent, on_child);
        const double *const values = above.child[i] >= 0 ? on_child : on_parent;
        const unsigned int *const places = above.unknowns->places(i);
        for (unsigned int k = 0; k < n_per_cell; ++k)
          sum.local_element(places[k]) += values[k];
      }
    coarse.zero_out_ghost_values();
    sum.compress(dealii::VectorOperation::add);
    for (unsigned int k = 0; k < weight.locally_owned_size(); ++k)
      fine.local_element(k) += weight.local_element(k) * sum.local_element(k);
  }



  void
  VCycle::restrict_to(const unsigned int l,
                      const Vector      &fine,
                      Vector            &coarse) const
  {
    const Level &below    = hierarchy.level(l);
    const Level &above    = hierarchy.level(l + 1);
    Vector      &weighted = smoothed[l + 1]->work;
    const auto  &weight   = smoothed[l + 1]->weight;
    double       on_parent[n_per_cell], on_child[n_per_cell];

    for (unsigned int k = 0; k < weight.locally_owned_size(); ++k)
      weighted.local_element(k) =
        weight.local_element(k) * fine.local_element(k);
    weighted.update_ghost_values();
    coarse = 0.;
    for (unsigned int i = 0; i < above.n_owned_cells; ++i)
      {
        const unsigned int *const places = above.unknowns->places(i);
        for (unsigned int k = 0; k < n_per_cell; ++k)
          on_child[k] = weighted.local_element(places[k]);
        if (above.child[i] >= 0)
          {
            std::fill(on_parent, on_parent + n_per_cell, 0.);
            embedding.add_transposed(above.child[i], on_child, on_parent);
          }
        below.unknowns->add(above.parent[i],
                            above.child[i] >= 0 ? on_parent : on_child,
                            coarse);
      }
    weighted.zero_out_ghost_values();
    coarse.compress(dealii::VectorOperation::add);
  }



  void
  VCycle::solve_coarsest(Vector &x, const Vector &b) const
  {
    numbering.extract(b, values);
    mumps->solve(values);
    x = 0.;
    numbering.insert(values, x);
  }



  void
  VCycle::cycle(const unsigned int l, Vector &x, const Vector &b) const
  {
    if (l == 0)
      {
        solve_coarsest(x, b);
        return;
      }
    const Smoothed &on      = *smoothed[l];
    const auto      n_owned = on.matrix.n_owned();

    std::copy(b.begin(), b.begin() + n_owned, on.b.begin());
    on.b.update_ghost_values();
    on.x = 0.;
    for (unsigned int s = 0; s < parameters.n_sweeps; ++s)
      on.smoother.sweep(on.x, on.b, false, s == 0);
    for (unsigned int c = 0; c < parameters.n_coarse_cycles; ++c)
      {
        on.x.update_ghost_values();
        on.matrix.residual(on.x, b.begin(), on.defect.begin());
        on.x.zero_out_ghost_values();
        restrict_to(l - 1, on.defect, on.coarse_b);
        cycle(l - 1, on.coarse_x, on.coarse_b);
        prolongate_and_add(l - 1, on.coarse_x, on.x);
        if (l == 1)
          break;
      }
    for (unsigned int s = 0; s < parameters.n_sweeps; ++s)
      on.smoother.sweep(on.x, on.b, true, false);
    std::copy(on.x.begin(), on.x.begin() + n_owned, x.begin());
  }



  void
  VCycle::vmult(Vector &y, const Vector &x) const
  {
    cycle(hierarchy.n_levels() - 1, y, x);
    const auto &constrained = tangent.unknowns.is_constrained();
    for (unsigned int k = 0; k < constrained.size(); ++k)
      if (constrained[k])
        y.local_element(k) = x.local_element(k);
  }



  double
  VCycle::cost() const
  {
    // Measured: inverting the patches and the coarsest factorisation take the
    // time of about ten cycles.
    return 10.;
  }
} // namespace lumbricus
