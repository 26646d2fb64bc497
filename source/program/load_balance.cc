// SPDX-License-Identifier: LGPL-2.1-or-later
#include "load_balance.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/discretization/loaded_points.h>
#include <lumbricus/parameters/expression.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    // Loads on curved surfaces balance as well as meshes and quadrature do.
    constexpr double refused = 1e-2, mentioned = 1e-4;

    const std::string how_to_balance =
      "The minimal support only keeps a body in its place whose loads are in "
      "balance: its points would be pulled out, the more the finer the mesh. "
      "Balance the loads, or hold the body by a condition of type "
      "'displacement' or 'spring', or by friction in a 'contact'.";



    // A quadrature point where something pulls.
    struct LoadPoint
    {
      // Its number among the boundary conditions, or the body forces behind
      // them.
      unsigned int load;
      Point<dim>   X;
      // The force at a time, and whether it follows the deformation.
      std::function<std::pair<Tensor<1, dim>, bool>(const double)> force;
    };



    void
    add_tractions(const MixedSpace         &space,
                  const BoundaryConditions &conditions,
                  std::vector<LoadPoint>   &points)
    {
      for (const LoadedPoint &loaded : loaded_points(space, conditions))
        {
          const SurfacePoint point = loaded.at_rest();
          points.push_back(
            {loaded.condition,
             point.X,
             [&term = *conditions.condition(loaded.condition).surface_term(),
              point,
              JxW = loaded.JxW](const double t) {
               SurfacePoint at = point;
               at.t            = t;
               SurfaceResponse response;
               term.surface(at, response);
               return std::make_pair(Tensor<1, dim>(JxW * response.T),
                                     response.depends_on_shape());
             }});
        }
    }



    void
    add_body_forces(const Body             &body,
                    const BodyForces       &forces,
                    const unsigned int      first_number,
                    std::vector<LoadPoint> &points)
    {
      for (const OwnedCell cell : body.owned_cells())
        for (unsigned int i = 0; i < forces.n_forces(); ++i)
          if (forces.force(i).acts_in[cell.region.tissue])
            for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
              {
                VolumePoint point;
                point.X = body.shapes.quadrature_point(cell.index, q);
                point.density = cell.tissue.density();
                points.push_back(
                  {first_number + i,
                   point.X,
                   [&term = *forces.force(i).type,
                    point,
                    JxW = body.shapes.cell(cell.index).JxW[q]](
                     const double t) {
                     VolumePoint at = point;
                     at.t           = t;
                     VolumeResponse response;
                     term.volume(at, response);
                     return std::make_pair(Tensor<1, dim>(JxW * response.b),
                                           response.depends_on_place());
                   }});
              }
    }



    // What the liquids of the whole mesh weigh, at their centres.
    void
    add_liquid_weight(const LiquidWeight     &liquid_weight,
                      const BodyForces       &forces,
                      const unsigned int      first_number,
                      std::vector<LoadPoint> &points)
    {
      for (const LiquidWeight::Chamber &chamber : liquid_weight.chambers())
        for (unsigned int i = 0; i < forces.n_forces(); ++i)
          points.push_back(
            {first_number + i,
             chamber.centre,
             [&liquid_weight, mass = chamber.density * chamber.volume, i](
               const double t) {
               return std::make_pair(
                 Tensor<1, dim>(mass * liquid_weight.gravity(i, t)), false);
             }});
    }



    double
    norm(const RigidMotions::Row &row)
    {
      double square = 0.;
      for (const double entry : row)
        square += entry * entry;
      return std::sqrt(square);
    }



    // Three entries of a row, times a factor; without what is rounding only.
    std::string
    vector_text(const RigidMotions::Row &row,
                const unsigned int       first,
                const double             factor)
    {
      std::ostringstream out;
      out.precision(3);
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double entry = row[first + c];
          out << (c == 0 ? "(" : ", ")
              << (std::abs(entry) <= 1e-6 * norm(row) ? 0. : factor * entry);
        }
      out << ")";
      return out.str();
    }
  } // namespace



  void
  check_load_balance(const Body                &body,
                     const BoundaryConditions  &conditions,
                     const BodyForces          &forces,
                     const LiquidWeight        &liquid_weight,
                     const Supports            &supports,
                     const std::vector<double> &all_times)
  {
    const RigidMotions &held = supports.held_without_minimal_support();
    if (held.all_held())
      return;
    const MPI_Comm           comm = body.space.communicator();
    const unsigned int       n_conditions = conditions.n_conditions();
    std::vector<LoadPoint>   points;
    add_tractions(body.space, conditions, points);
    add_body_forces(body, forces, n_conditions, points);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      add_liquid_weight(liquid_weight, forces, n_conditions, points);
    std::vector<std::string> names;
    for (unsigned int i = 0; i < n_conditions; ++i)
      names.push_back(conditions.condition(i).name);
    for (unsigned int i = 0; i < forces.n_forces(); ++i)
      names.push_back(forces.force(i).name);

    // As many times as take no time.
    const double n_points =
      dealii::Utilities::MPI::max(static_cast<double>(points.size()), comm);
    constexpr double    most_evaluations = 1e5;
    std::vector<double> times            = all_times;
    if (n_points * times.size() > most_evaluations)
      {
        const std::size_t stride =
          std::min(all_times.size() / 4,
                   static_cast<std::size_t>(
                     std::ceil(n_points * all_times.size() /
                               most_evaluations)));
        times.clear();
        for (std::size_t i = 0; i < all_times.size(); i += stride)
          times.push_back(all_times[i]);
      }

    // For every time: the resultant, the sum of magnitudes, and what follows
    // the deformation; then the magnitude of every load.
    constexpr unsigned int n_of_row = 2 * dim;
    const unsigned int     n        = names.size();
    const std::size_t      block    = n_of_row + 2 + n;
    std::vector<double>    sums(block * times.size(), 0.);
    for (const LoadPoint &point : points)
      for (std::size_t k = 0; k < times.size(); ++k)
        {
          double *sum                   = sums.data() + k * block;
          const auto &[force, follows] = point.force(times[k]);
          const auto row                = held.row(point.X, force);
          for (unsigned int i = 0; i < n_of_row; ++i)
            sum[i] += row[i];
          sum[n_of_row] += norm(row);
          if (follows)
            sum[n_of_row + 1] += norm(row);
          sum[n_of_row + 2 + point.load] += norm(row);
        }
    dealii::Utilities::MPI::sum(sums, comm, sums);

    std::size_t       worst      = 0;
    double            worst_norm = 0.;
    RigidMotions::Row worst_row  = {};
    for (std::size_t k = 0; k < times.size(); ++k)
      {
        const double     *sum = sums.data() + k * block;
        RigidMotions::Row row;
        std::copy(sum, sum + n_of_row, row.begin());
        const auto rest = held.unheld(row);
        if (norm(rest) > refused * sum[n_of_row] && sum[n_of_row + 1] == 0. &&
            norm(rest) > worst_norm)
          {
            worst      = k;
            worst_norm = norm(rest);
            worst_row  = rest;
          }
      }
    if (worst_norm == 0.)
      return;

    std::ostringstream message;
    std::vector<std::string> acting;
    for (unsigned int i = 0; i < n; ++i)
      if (sums[worst * block + n_of_row + 2 + i] > 0.)
        acting.push_back(names[i]);
    message << "The loads are not in balance. At time " << times[worst] << " "
            << quoted_list(acting) << " add up to the force "
            << vector_text(worst_row, 0, 1.) << " N and the moment "
            << vector_text(worst_row, dim, held.L) << " N mm about "
            << point_text(held.X0)
            << " that no other support holds. " << how_to_balance;
    AssertThrow(false, ExcInput(message.str()));
  }



  std::string
  imbalance(const std::vector<ExternalForce> &forces)
  {
    const ExternalForce *largest = nullptr;
    double               loads   = 0.;
    Tensor<1, dim>       sum;
    for (const ExternalForce &entry : forces)
      {
        sum += entry.force;
        if (entry.kind != ExternalForce::Kind::minimal_support)
          loads += entry.magnitude;
        else if (largest == nullptr ||
                 entry.force.norm() > largest->force.norm())
          largest = &entry;
      }
    // Not what is only due to a residual that is not quite zero.
    if (largest == nullptr || !(largest->force.norm() > mentioned * loads) ||
        !(largest->force.norm() > 10. * sum.norm()) || loads == 0.)
      return "";

    std::ostringstream message;
    message << std::setprecision(3) << "the loads are not in balance: at "
            << point_text(largest->X) << " the minimal support pulls with "
            << largest->force[largest->direction] << " N along "
            << "xyz"[largest->direction] << ", "
            << 100. * largest->force.norm() / loads
            << " % of all loads. reactions.csv has all of its forces. "
            << how_to_balance;
    return message.str();
  }
} // namespace lumbricus
