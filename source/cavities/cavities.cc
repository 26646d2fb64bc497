// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavities.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/measures/cavity_volume.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // Of the sum of its area vectors, relative to its area.
    constexpr double closed = 1e-10;



    // Sparse sums over faces, one for each cavity.
    class SparseSums
    {
    public:
      // Of entries at places of a vector like @p like.
      SparseSums(const unsigned int n, const Vector &like)
        : partitioner(like.get_partitioner())
        , of_cavities(n)
      {}

      void
      add(const unsigned int k, const unsigned int place, const double value)
      {
        of_cavities[k].emplace_back(place, value);
      }

      // The sums of all ranks, where they are owned. Collective.
      std::vector<BorderVector>
      owned()
      {
        send_to_owners();
        std::vector<BorderVector> sums;
        for (Terms &terms : of_cavities)
          {
            sum_up(terms);
            std::vector<unsigned int> places;
            std::vector<double>       values;
            for (const auto &[place, value] : terms)
              {
                places.push_back(place);
                values.push_back(value);
              }
            sums.emplace_back(places, values);
          }
        return sums;
      }

    private:
      using Terms = std::vector<std::pair<unsigned int, double>>;

      // Let every place have one term, in ascending order.
      static void
      sum_up(Terms &terms)
      {
        // The order of summation stays what it is.
        std::stable_sort(terms.begin(),
                         terms.end(),
                         [](const auto &a, const auto &b) {
                           return a.first < b.first;
                         });
        Terms sums;
        for (const auto &term : terms)
          if (!sums.empty() && sums.back().first == term.first)
            sums.back().second += term.second;
          else
            sums.push_back(term);
        terms = sums;
      }

      // Those of ghost entries. All cavities at once.
      void
      send_to_owners()
      {
        const MPI_Comm comm = partitioner->get_mpi_communicator();
        if (dealii::Utilities::MPI::n_mpi_processes(comm) == 1)
          return;
        std::vector<unsigned int> owner_of_ghost;
        for (const auto &[rank, n] : partitioner->ghost_targets())
          owner_of_ghost.insert(owner_of_ghost.end(), n, rank);

        // Cavity, index, value; what is no value is a whole number and small
        // enough.
        std::map<unsigned int, std::vector<double>> messages;
        const unsigned int n_owned = partitioner->locally_owned_size();
        for (unsigned int k = 0; k < of_cavities.size(); ++k)
          {
            Terms &terms = of_cavities[k];
            sum_up(terms);
            while (!terms.empty() && terms.back().first >= n_owned)
              {
                const auto [place, value] = terms.back();
                auto &message = messages[owner_of_ghost[place - n_owned]];
                message.push_back(k);
                message.push_back(partitioner->local_to_global(place));
                message.push_back(value);
                terms.pop_back();
              }
          }
        const auto received =
          dealii::Utilities::MPI::some_to_some(comm, messages);
        for (const auto &[rank, message] : received)
          for (unsigned int i = 0; i < message.size(); i += 3)
            add(message[i],
                partitioner->global_to_local(
                  static_cast<dealii::types::global_dof_index>(
                    message[i + 1])),
                message[i + 2]);
      }

      const std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
                         partitioner;
      std::vector<Terms> of_cavities;
    };
  } // namespace



  const std::string cavity_filling = "cavity_filling";



  Cavities::Cavities(const Body           &body,
                     const CellUnknowns   &unknowns,
                     const CavityContents &contents,
                     const LiquidWeight   &weight)
    : body(body)
    , unknowns(unknowns)
    , contents(contents)
    , weight(weight)
    , faces(body.anatomy.geometry())
    , surface(body.space)
  {}



  void
  Cavities::reinit()
  {
    walls.clear();
    chambers.clear();
    const Geometry &geometry = body.anatomy.geometry();
    for (const CavityWall &wall : geometry.cavities())
      {
        walls.emplace_back();
        walls.back().around = wall;
        chambers.push_back(
          {wall.segment, contents.content(wall.segment).keeps_amount()});
      }
    if (!any())
      return;

    // For each wall its volume, its area and the sum of its area vectors; then
    // the volume of the solid.
    constexpr unsigned int n_sums = 2 + dim;
    std::vector<double>    sums(n_sums * walls.size() + 1);
    const double at_rest[dim][ShapeCache::padded_nodes] = {};
    for (unsigned int i = 0; i < body.shapes.n_owned_cells(); ++i)
      for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
        sums.back() += body.shapes.cell(i).JxW[q];
    faces.for_each(body,
                   [&](const OwnedCell   &cell,
                       const unsigned int f,
                       const unsigned int k) {
                     walls[k].faces.push_back({cell.index, cell.iterator, f});
                     surface.reinit(cell.iterator, f);
                     double *sum = &sums[n_sums * k];
                     for (unsigned int q = 0; q < surface.n_points(); ++q)
                       {
                         surface.set(q, at_rest);
                         sum[0] += volume_in_cavity(surface,
                                                    walls[k].around);
                         sum[1] += surface.JxW;
                         for (unsigned int c = 0; c < dim; ++c)
                           sum[2 + c] += area_out_of_cavity(surface)[c];
                       }
                   });
    dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);

    body_volume = sums.back();
    for (unsigned int k = 0; k < walls.size(); ++k)
      {
        double *sum             = &sums[n_sums * k];
        walls[k].volume_at_rest = sum[0];
        body_volume += sum[0];
        // A plane of symmetry closes it there.
        for (const SymmetryPlane &plane : geometry.symmetry_planes())
          sum[2 + plane.direction] = 0.;
        // Pistons do so at their planes.
        if (!walls[k].around.pistons.empty())
          sum[2] = 0.;
        const dealii::Tensor<1, dim> open({sum[2], sum[3], sum[4]});
        if (open.norm() > closed * sum[1] || !(sum[0] > 0.))
          {
            std::ostringstream message;
            message << "The cavity of segment " << walls[k].around.segment + 1
                    << " is not closed: the area vectors of its "
                    << "wall add up to (" << open << ") mm^2, and it holds "
                    << sum[0] << " mm^3. Which surface is missing?";
            AssertThrow(false, ExcInput(message.str()));
          }
      }
  }



  void
  Cavities::set_to(const State &state)
  {
    last_time = state.last_time;
  }



  void
  Cavities::end_step(State &state) const
  {
    if (!any())
      return;
    const auto P = pressures(state.globals, state.time).P;
    const auto M = amounts(state.globals, P, state.time).M;
    const auto V = cavity_volumes(body, body.space.with_ghosts(state.solution));
    std::vector<double> &filling = state.globals.at(cavity_filling);
    for (unsigned int k = 0; k < walls.size(); ++k)
      filling[k] =
        (chambers[k].keeps_amount ? M[k] : V[k]) / walls[k].volume_at_rest;
  }



  Globals
  Cavities::globals_at_rest() const
  {
    if (!any())
      return {};
    return {{cavity_pressure, std::vector<double>(walls.size(), 0.)},
            {cavity_filling, std::vector<double>(walls.size(), 1.)}};
  }



  Cavities::Pressures
  Cavities::pressures(const Globals &globals, const LoadTime &t) const
  {
    Pressures pressures{globals.at(cavity_pressure), {}};
    for (unsigned int k = 0; k < walls.size(); ++k)
      {
        const unsigned int segment = walls[k].around.segment;
        const auto         given =
          contents.content(segment).given_pressure(segment, t);
        pressures.given.push_back(given.has_value());
        if (given)
          pressures.P[k] = *given;
      }
    return pressures;
  }



  CavityExchange::Amounts
  Cavities::amounts(const Globals             &globals,
                    const std::vector<double> &P,
                    const LoadTime            &t) const
  {
    std::vector<double> before, excess;
    for (unsigned int k = 0; k < walls.size(); ++k)
      {
        before.push_back(globals.at(cavity_filling)[k] *
                         walls[k].volume_at_rest);
        excess.push_back(
          weight.excess(walls[k].around.segment, dealii::Point<dim>()));
      }
    return contents.exchange().amounts(chambers,
                                       before,
                                       P,
                                       excess,
                                       t,
                                       t.to() - last_time);
  }



  Cavities::Shape
  Cavities::shape(const Vector              &solution,
                  const std::vector<double> &P,
                  Tangent                   *tangent,
                  Vector                    &r)
  {
    constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;
    const unsigned int     n          = walls.size();
    Vector                 u, pull;
    unknowns.reinit_vector(u);
    unknowns.reinit_vector(pull);
    u.copy_locally_owned_data_from(solution);
    u.update_ghost_values();

    Shape               shape;
    std::vector<double> sums(3 * n); // volumes, their rounding, what is missing
    double              of_cell[n_per_cell], area[n_per_cell];
    double              force[n_per_cell], missing[n_per_cell];
    std::vector<double> of_face;
    ElementKernel       kernel;
    SparseSums          areas(n, u);
    for (unsigned int k = 0; k < n; ++k)
      {
        for (const Face &face : walls[k].faces)
          {
            unknowns.read(face.cell, u, of_cell);
            kernel.set(of_cell);
            surface.reinit(face.iterator, face.number);
            std::fill(area, area + n_per_cell, 0.);
            // What is prescribed and still missing pulls here too: there the
            // matrix of the face alone is needed.
            const bool is_missing =
              tangent != nullptr &&
              unknowns.read_inhomogeneity(face.cell, missing);
            if (is_missing)
              of_face.assign(n_per_cell * n_per_cell, 0.);
            for (unsigned int q = 0; q < surface.n_points(); ++q)
              {
                surface.set(q, kernel.u);
                const double V = volume_in_cavity(surface, walls[k].around);
                sums[k] += V;
                sums[n + k] += std::abs(V);
                add_volume_derivative(surface, walls[k].around, area);
                if (tangent != nullptr)
                  add_volume_second_derivative(surface,
                                               walls[k].around,
                                               -P[k],
                                               is_missing ?
                                                 of_face :
                                                 tangent->surface_matrix(
                                                   face.cell));
              }
            for (unsigned int i = 0; i < n_per_cell; ++i)
              force[i] = -P[k] * area[i];
            if (is_missing)
              {
                std::vector<double> &all = tangent->surface_matrix(face.cell);
                for (unsigned int i = 0; i < of_face.size(); ++i)
                  all[i] += of_face[i];
                for (unsigned int i = 0; i < n_per_cell; ++i)
                  {
                    force[i] += std::inner_product(missing,
                                                   missing + n_per_cell,
                                                   &of_face[i * n_per_cell],
                                                   0.);
                    sums[2 * n + k] += area[i] * missing[i];
                  }
              }
            unknowns.add(face.cell, force, pull);
            // Also where it is zero just now: a factorisation keeps the places.
            if (tangent != nullptr)
              for (const unsigned int node : surface.face_nodes)
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    const unsigned int i = CellUnknowns::displacement(c, node);
                    for (const auto &[place, weight] :
                         unknowns.row(face.cell, i))
                      areas.add(k, place, weight * area[i]);
                  }
          }
      }
    if (tangent != nullptr)
      shape.areas = areas.owned();
    pull.compress(dealii::VectorOperation::add);
    for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
      r.local_element(i) += pull.local_element(i);
    dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);
    const auto part = [&](const unsigned int i) {
      return std::vector<double>(sums.begin() + i * n,
                                 sums.begin() + (i + 1) * n);
    };
    shape.volumes  = part(0);
    shape.rounding = part(1);
    shape.missing  = part(2);
    return shape;
  }



  Border
  Cavities::border(const Vector   &solution,
                   const Globals  &globals,
                   const LoadTime &t,
                   Tangent        *tangent,
                   Vector         &r)
  {
    const std::vector<double> &unknown = globals.at(cavity_pressure);
    const unsigned int         n       = walls.size();
    AssertDimension(unknown.size(), n);
    const auto [P, given]  = pressures(globals, t);
    const Shape  now       = shape(solution, P, tangent, r);
    const auto   inside    = amounts(globals, P, t);
    const double stiffness = body.anatomy.wall_stiffness();

    Border border;
    border.names = {{cavity_pressure, n}};
    if (tangent != nullptr)
      border.corner.reinit(n, n);
    for (unsigned int k = 0; k < n; ++k)
      {
        const Wall          &wall    = walls[k];
        const unsigned int   segment = wall.around.segment;
        const CavityEquation equation =
          contents.content(segment)
            .equation({segment,
                       now.volumes[k],
                       wall.volume_at_rest,
                       inside.M[k],
                       unknown[k],
                       stiffness,
                       t});
        border.residual.push_back(equation.s +
                                  equation.ds_dV * now.missing[k]);
        border.scale.push_back(equation.scale * body_volume /
                               wall.volume_at_rest);
        border.rounding.push_back(std::numeric_limits<double>::epsilon() *
                                  std::abs(equation.ds_dV) * now.rounding[k]);
        if (tangent == nullptr)
          continue;
        border.columns.push_back(given[k] ? BorderVector() : now.areas[k]);
        border.columns.back().scale(-1.);
        border.rows.push_back(now.areas[k]);
        border.rows.back().scale(equation.ds_dV);
        for (unsigned int j = 0; j < n; ++j)
          border.corner(k, j) =
            given[j] ? 0. : equation.ds_dM * inside.dM_dP(k, j);
        border.corner(k, k) += equation.ds_dP;
      }
    return border;
  }
} // namespace lumbricus
