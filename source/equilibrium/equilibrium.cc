// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/interruption.h>
#include <lumbricus/discretization/regime_changes.h>
#include <lumbricus/equilibrium/equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // What rounding leaves of the residual is at most this many times what is
    // expected.
    constexpr double certain = 2.;

  } // namespace



  const std::string LoadUnknown::name = "load_parameter";



  Equilibrium::Equilibrium(const Body          &body,
                           Assembler           &assembler,
                           SurfaceTerms        &surface_terms,
                           Supports            &supports,
                           LinearSolver        &linear_solver,
                           dealii::TimerOutput &timer)
    : body(body)
    , assembler(assembler)
    , surface_terms(surface_terms)
    , supports(supports)
    , linear_solver(linear_solver)
    , timer(timer)
  {}



  void
  Equilibrium::reinit()
  {
    const MixedSpace &space  = body.space;
    const ShapeCache &shapes = body.shapes;
    const MPI_Comm    comm   = space.communicator();
    component.assign(space.locally_owned.n_elements(), dim);
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const auto &cell : space.owned_cells())
      {
        cell->get_dof_indices(indices);
        for (unsigned int c = 0; c < dim; ++c)
          for (const unsigned int k : space.displacement_dof[c])
            if (space.locally_owned.is_element(indices[k]))
              component[space.locally_owned.index_within_set(indices[k])] = c;
      }

    double volume = 0.;
    for (unsigned int i = 0; i < shapes.n_owned_cells(); ++i)
      for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
        volume += shapes.cell(i).JxW[q];
    body_volume = dealii::Utilities::MPI::sum(volume, comm);
    length      = body.anatomy.geometry().characteristic_length();

    std::vector<double> ends(2 * dim, std::numeric_limits<double>::lowest());
    for (unsigned int i = 0; i < shapes.n_owned_cells(); ++i)
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double X = shapes.node(i, n)[c];
            ends[c]        = std::max(ends[c], X);
            ends[dim + c]  = std::max(ends[dim + c], -X);
          }
    dealii::Utilities::MPI::max(ends, comm, ends);
    extent = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      extent = std::max(extent, (ends[c] + ends[dim + c]) / length);

    // Forces are small, relative to nothing else, where they are those of a
    // strain of 1e-6 in the stiffest tissue.
    least_force = 1e-6 * body.anatomy.wall_stiffness() * length * length;

    linearised.clear();
    reinit_solvers();
  }



  void
  Equilibrium::reinit_solvers()
  {
    assembler.reinit();
    linear_solver.reinit(assembler.tangent());
  }



  void
  Equilibrium::set_borders(const std::vector<BorderSource *> &new_sources)
  {
    sources = new_sources;
  }



  void
  Equilibrium::set_load_unknown(LoadUnknown *new_load)
  {
    load = new_load;
  }



  void
  Equilibrium::take_loads(const Unknowns &x)
  {
    if (load == nullptr)
      return;
    const double t = x.globals.at(LoadUnknown::name)[0];
    if (t == time.to())
      return;
    time = t;
    load->set_loads(time);
  }



  void
  Equilibrium::append_load(const Unknowns &x,
                           const bool      with_tangent,
                           Border         &all)
  {
    if (load == nullptr)
      return;
    const double       t        = time.to();
    const unsigned int n        = all.size();
    const auto         equation = load->equation(x.solution, t);
    if (with_tangent)
      {
        const auto   derivatives = load->derivatives(x.solution, t);
        const double h           = load->difference();
        Vector       column, ahead;
        assembler.residual(x.solution, time, column);
        const Border rows = border_at(x, nullptr, column);
        time              = t + h;
        load->set_loads(time);
        assembler.residual(x.solution, time, ahead);
        const Border rows_ahead = border_at(x, nullptr, ahead);
        time                    = t;
        load->set_loads(time);
        column.sadd(-1. / h, 1. / h, ahead);

        dealii::FullMatrix<double> corner(n + 1, n + 1);
        if (n > 0)
          corner.fill(all.corner);
        for (unsigned int k = 0; k < n; ++k)
          corner(k, n) = (rows_ahead.residual[k] - rows.residual[k]) / h;
        corner(n, n) = derivatives.by_t;
        all.corner   = corner;
        all.columns.emplace_back(column);
        all.rows.push_back(derivatives.by_u);
      }
    all.names.emplace_back(LoadUnknown::name, 1);
    all.residual.push_back(equation.residual);
    all.scale.push_back(1.);
    all.rounding.push_back(equation.rounding);
  }



  const std::vector<BorderSource *> &
  Equilibrium::borders() const
  {
    return sources;
  }



  Globals
  Equilibrium::globals_at_rest() const
  {
    Globals globals;
    for (const BorderSource *source : sources)
      for (const auto &of_name : source->globals_at_rest())
        {
          Assert(globals.count(of_name.first) == 0,
                 dealii::ExcMessage("Two borders have unknowns '" +
                                    of_name.first + "'."));
          globals.insert(of_name);
        }
    return globals;
  }



  void
  Equilibrium::set_time(const LoadTime &t, const Vector &solution)
  {
    time = t;
    linearised.clear();
    prescribed_is_due = supports.set_increments(solution, t) > 1e-14 * length;
  }



  void
  Equilibrium::forget_factors()
  {
    linear_solver.reinit(assembler.tangent());
  }



  void
  Equilibrium::constrain(Vector &way) const
  {
    supports.constraints().distribute(way);
  }



  void
  Equilibrium::start_from(const Vector &solution)
  {
    if (!supports.follow_the_deformation())
      return;
    start = solution;
    supports.update_interface(solution, start);
    reinit_solvers();
  }



  void
  Equilibrium::follow(const Vector &x)
  {
    if (!supports.follow_the_deformation())
      return;
    supports.update_interface(x, start);
    if (!assembler.update_constraints())
      reinit_solvers();
  }



  NonlinearProblem::Residual
  Equilibrium::residual(const Unknowns &x)
  {
    dealii::TimerOutput::Scope scope(timer, "residual");
    take_loads(x);
    follow(x.solution);
    const auto report = assembler.residual(x.solution, time, r);
    Border     rows   = border_at(x, nullptr, r);
    append_load(x, false, rows);

    double force = 0., volume = 0.;
    for (unsigned int i = 0; i < component.size(); ++i)
      {
        const double entry = r.begin()[i];
        if (component[i] == dim)
          volume += std::abs(entry);
        else
          force += entry * entry;
      }
    const MPI_Comm comm = body.space.communicator();
    Residual       residual;
    const double   level = std::max(report.force_level, least_force);
    residual.force =
      std::sqrt(dealii::Utilities::MPI::sum(force, comm)) / level;
    residual.volume = dealii::Utilities::MPI::sum(volume, comm) / body_volume;
    residual.gap    = supports.gap() / length;
    for (unsigned int k = 0; k < rows.size(); ++k)
      {
        residual.border += std::abs(rows.residual[k]) / rows.scale[k];
        residual.border_rounding += certain * rows.rounding[k] / rows.scale[k];
      }
    residual.force_rounding  = certain * report.force_rounding / level;
    residual.volume_rounding = certain * report.volume_rounding / body_volume;
    residual.valid  = report.valid() && std::isfinite(residual.merit());
    return residual;
  }



  bool
  Equilibrium::linearise(const Unknowns &x)
  {
    throw_if_interrupted(body.space.communicator());
    dealii::TimerOutput::Scope scope(timer, "assembly");
    take_loads(x);
    const bool valid = assembler.linearise(x.solution, time).valid();
    if (surface_terms.may_slide())
      {
        linearised.push_back(x.solution);
        if (linearised.size() > 2)
          linearised.pop_front();
      }
    border = Border();
    if (!is_bordered())
      return valid;
    rhs = assembler.right_hand_side();
    rhs *= -1.;
    border = border_at(x, &assembler.tangent(), rhs);
    rhs *= -1.;
    append_load(x, true, border);
    return valid;
  }



  const Vector &
  Equilibrium::right_hand_side() const
  {
    return is_bordered() ? rhs : assembler.right_hand_side();
  }



  void
  Equilibrium::solve(Unknowns &dx, const double tolerance)
  {
    dealii::TimerOutput::Scope scope(timer, "linear solver");
    const Vector &b = right_hand_side();
    dx.solution.reinit(b, true);
    std::vector<double> dg, c = border.residual;
    for (double &entry : c)
      entry *= -1.;
    linear_solver.solve(dx.solution, dg, b, c, border, tolerance);
    // Those of a state that are no unknowns do not change.
    dx.globals = border.write(dg);
    constrain(dx.solution);
  }



  Border
  Equilibrium::border_at(const Unknowns &x,
                         Tangent        *tangent,
                         Vector         &residual) const
  {
    Border all;
    for (BorderSource *source : sources)
      all.append(
        source->border(x.solution, x.globals, time, tangent, residual));
    return all;
  }



  bool
  Equilibrium::leaps(const Vector &from, const Vector &to) const
  {
    Vector way = to;
    way -= from;
    double sums[2 * dim] = {};
    for (unsigned int i = 0; i < component.size(); ++i)
      if (component[i] < dim)
        {
          sums[component[i]] += way.begin()[i];
          sums[dim + component[i]] += 1.;
        }
    dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);
    for (unsigned int i = 0; i < component.size(); ++i)
      if (component[i] < dim)
        way.begin()[i] -= sums[component[i]] / sums[dim + component[i]];
    return increment_size(way) > extent;
  }



  double
  Equilibrium::increment_size(const Vector &dx) const
  {
    double largest = 0.;
    for (unsigned int i = 0; i < component.size(); ++i)
      if (component[i] < dim)
        largest = std::max(largest, std::abs(dx.begin()[i]));
    return dealii::Utilities::MPI::max(largest, body.space.communicator()) /
           length;
  }



  double
  Equilibrium::largest_linear_tolerance() const
  {
    // Which points touch and which slide hangs on where they go, and what is left of a
    // linear system moves them at random: with 3e-3 a step of a crawling worm did not
    // converge, by the kernels that OpenBLAS took.
    return surface_terms.may_slide() ?
             1e-4 :
             NonlinearProblem::largest_linear_tolerance();
  }



  double
  Equilibrium::largest_step(const Unknowns &x, const Unknowns &dx)
  {
    if (!surface_terms.may_slide())
      return 1.;
    // What drives the step, -r_u . du.
    double drive = 0.;
    for (unsigned int i = 0; i < component.size(); ++i)
      if (component[i] < dim)
        drive -= r.begin()[i] * dx.solution.begin()[i];
    drive = dealii::Utilities::MPI::sum(drive, body.space.communicator());
    constexpr double most_pull_back = 1.1;
    return drive > 0. ? surface_terms.part_of_slide(x.solution,
                                                    dx.solution,
                                                    time,
                                                    most_pull_back * drive) :
                        1.;
  }



  bool
  Equilibrium::increments_prescribed() const
  {
    return prescribed_is_due;
  }



  void
  Equilibrium::increments_taken()
  {
    if (prescribed_is_due)
      supports.set_increments_to_zero();
    prescribed_is_due = false;
  }



  std::string
  Equilibrium::locate_trouble(const Unknowns &x)
  {
    take_loads(x);
    const MixedSpace  &space  = body.space;
    const auto         report = assembler.residual(x.solution, time, r);
    border_at(x, nullptr, r);
    std::ostringstream where;
    if (!report.valid())
      {
        where << "segment " << report.min_J_segment + 1
              << " has an inverted element (det F = " << report.min_J << ")";
        return where.str();
      }

    // The largest out-of-balance force, and a cell that has it.
    double       largest = 0.;
    unsigned int place   = 0;
    for (unsigned int i = 0; i < component.size(); ++i)
      if (component[i] < dim && std::abs(r.begin()[i]) > largest)
        {
          largest = std::abs(r.begin()[i]);
          place   = i;
        }
    unsigned int segment = 0;
    if (largest > 0.)
      {
        const auto index = space.locally_owned.nth_index_in_set(place);
        std::vector<dealii::types::global_dof_index> indices(
          space.fe.n_dofs_per_cell());
        for (const auto &cell : space.dof_handler.active_cell_iterators())
          if (!cell->is_artificial())
            {
              cell->get_dof_indices(indices);
              if (std::find(indices.begin(), indices.end(), index) !=
                  indices.end())
                {
                  segment = Region::of(cell->material_id()).segment;
                  break;
                }
            }
      }
    const MPI_Comm comm   = space.communicator();
    const auto     global = dealii::Utilities::MPI::min_max_avg(largest, comm);
    segment =
      dealii::Utilities::MPI::broadcast(comm, segment, global.max_index);
    where << "the largest out-of-balance force, " << global.max
          << ", is in segment " << segment + 1 << ", the smallest det F, "
          << report.min_J << ", in segment " << report.min_J_segment + 1;
    if (linearised.size() == 2)
      where << regime_changes(body,
                              surface_terms,
                              linearised.front(),
                              linearised.back(),
                              time);
    return where.str();
  }
} // namespace lumbricus
