// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/equilibrium/harmonic_extension.h>
#include <lumbricus/equilibrium/liquid_mesh.h>
#include <lumbricus/measures/mesh_quality.h>
#include <lumbricus/measures/rest_volume.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_nodes;

    // Of the scaled Jacobian: nothing moves for less.
    constexpr double least_gain = 1e-6;

    // Of the scaled Jacobian at rest: a mesh is good as long as it has this.
    constexpr double good = 0.5;

    // Call function(cell) for the owned cells of liquid of some segments.
    template <typename Function>
    void
    for_each_cell(const Body              &body,
                  const std::vector<bool> &in_segment,
                  const Function          &function)
    {
      for (const OwnedCell cell : body.owned_cells())
        if (cell.is_liquid && in_segment[cell.region.segment])
          function(cell);
    }



    // The mean of p over the stress-free volume of every segment's liquid, so
    // that a uniform p of this value goes with the same volume.
    std::vector<double>
    mean_pressures(const Body              &body,
                   const std::vector<bool> &in_segment,
                   CellStateReader         &reader)
    {
      const unsigned int  n_segments = in_segment.size();
      std::vector<double> sums(2 * n_segments, 0.);
      const unsigned int  u_vol = reader.layout.begin_of(volume_displacement);
      std::vector<double> values;
      ElementKernel       kernel;
      for_each_cell(body, in_segment, [&](const OwnedCell &cell) {
        reader.read(cell.iterator, values);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < n_nodes; ++n)
            kernel.u[c][n] = values[u_vol + c * n_nodes + n];
        std::copy_n(&values[CellLayout::pressure_begin],
                    MixedSpace::n_pressure_modes,
                    kernel.p);
        const ShapeCache::Cell shape = body.shapes.cell(cell.index);
        kernel.compute_deformation(shape);
        const unsigned int segment = cell.region.segment;
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            const double J_v_dV = determinant(kernel.F[q]) * shape.JxW[q];
            sums[segment] += J_v_dV;
            sums[n_segments + segment] +=
              kernel.pressure(body.shapes.pressure_modes(), q) * J_v_dV;
          }
      });
      dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);
      std::vector<double> means(n_segments, 0.);
      for (unsigned int s = 0; s < n_segments; ++s)
        if (in_segment[s])
          means[s] = sums[n_segments + s] / sums[s];
      return means;
    }



    // The nodes inside the liquid of some segments moved by a correction; the
    // shape they make then without stress, and the pressure uniform. The volume
    // of that shape is the stress-free one up to a factor.
    State
    relaxed_state(const Body                &body,
                  const CellUnknowns        &unknowns,
                  const std::vector<bool>   &in_segment,
                  const Vector              &correction,
                  const std::vector<double> &pressures,
                  CellStateReader           &reader,
                  const State               &state)
    {
      const MixedSpace   &space   = body.space;
      State               relaxed = state;
      CellStateWriter     writer(space, relaxed);
      std::vector<double> values, of_cell(CellUnknowns::n_per_cell);
      const double        constant_mode =
        space.fe.shape_value(space.pressure_dof[0], dealii::Point<dim>());
      for_each_cell(body, in_segment, [&](const OwnedCell &cell) {
        reader.read(cell.iterator, values);
        unknowns.read_free(cell.index, correction, of_cell.data());
        const auto u = values.begin(), p = u + CellLayout::pressure_begin;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < n_nodes; ++n)
            u[c * n_nodes + n] += of_cell[CellUnknowns::displacement(c, n)];
        for (const auto *history : {&rest_displacement, &volume_displacement})
          std::copy_n(u,
                      CellLayout::n_displacements,
                      u + reader.layout.begin_of(*history));
        std::fill_n(p, MixedSpace::n_pressure_modes, 0.);
        *p = pressures[cell.region.segment] / constant_mode;
        writer.write(cell.iterator, values);
      });
      return relaxed;
    }
  } // namespace



  void
  LiquidMesh::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Reset");
    prm.add_parameter("Relax below",
                      relax_below,
                      "[-] Before a load step the mesh inside the liquid of a "
                      "segment is relaxed where its least scaled Jacobian is "
                      "less than this times what it is at rest; 0: never. With "
                      "1 the shape of the mesh forgets the way it took, and "
                      "loads that repeat give results that repeat.",
                      dealii::Patterns::Double(0., 1.));
    prm.leave_subsection();
  }



  LiquidMesh::Relaxation
  LiquidMesh::relax(const Body         &body,
                    const CellUnknowns &unknowns,
                    State              &state) const
  {
    Vector     change     = state.solution;
    const auto relaxation = relax_where(
      body, unknowns, state, [&](const double quality, const double at_rest) {
        return Wanted{quality < relax_below * at_rest,
                      std::max(0., quality) + least_gain};
      });
    if (relaxation.in_segment.empty())
      return relaxation;
    // What is extrapolated begins at the nodes where they are now.
    change.sadd(-1., 1., state.solution);
    for (State::Past &earlier : state.past)
      earlier.solution += change;
    return relaxation;
  }



  LiquidMesh::Relaxation
  LiquidMesh::settle(const Body         &body,
                     const CellUnknowns &unknowns,
                     State              &state) const
  {
    // What decides does not hang on where the nodes happen to be, as long as the
    // mesh that it makes is good.
    return relax_where(
      body, unknowns, state, [](const double quality, const double at_rest) {
        return Wanted{quality < 1.,
                      std::min(good * at_rest,
                               std::max(0., quality) + least_gain)};
      });
  }



  template <typename Wish>
  LiquidMesh::Relaxation
  LiquidMesh::relax_where(const Body         &body,
                          const CellUnknowns &unknowns,
                          State              &state,
                          const Wish         &wish) const
  {
    Relaxation relaxation;
    if (!relaxes() || !body.anatomy.has_liquid())
      return relaxation;
    const MixedSpace   &space   = body.space;
    const Vector        before  = space.with_ghosts(state.solution);
    const auto          quality = mesh_qualities(body, &before);
    const auto          at_rest = mesh_qualities(body, nullptr);
    std::vector<double> least_quality;
    for (unsigned int s = 0; s < quality.size(); ++s)
      {
        const Wanted wanted = wish(quality[s].liquid, at_rest[s].liquid);
        relaxation.in_segment.push_back(wanted.relaxes);
        least_quality.push_back(wanted.least_quality);
      }

    std::vector<bool> &in_segment = relaxation.in_segment;
    const auto         none       = [&]() {
      if (std::find(in_segment.begin(), in_segment.end(), true) !=
          in_segment.end())
        return false;
      in_segment.clear();
      return true;
    };
    if (none())
      return relaxation;
    const Vector correction =
      harmonic_correction(body, unknowns, before, in_segment);
    CellStateReader reader(space, state);
    const auto      pressures  = mean_pressures(body, in_segment, reader);
    const auto      relax_them = [&]() {
      return relaxed_state(
        body, unknowns, in_segment, correction, pressures, reader, state);
    };
    State        relaxed = relax_them();
    const Vector after   = space.with_ghosts(relaxed.solution);
    const auto   better  = mesh_qualities(body, &after);
    bool         all     = true;
    for (unsigned int s = 0; s < better.size(); ++s)
      if (in_segment[s] && better[s].liquid < least_quality[s])
        in_segment[s] = all = false;
    if (none())
      return relaxation;
    if (!all)
      relaxed = relax_them();

    set_rest_volumes(rest_volumes(body, state), body, relaxed);
    state = relaxed;
    return relaxation;
  }
} // namespace lumbricus
