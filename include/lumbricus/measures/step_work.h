// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_step_work_h
#define lumbricus_measures_step_work_h

#include <lumbricus/core/state.h>
#include <lumbricus/discretization/reference_field.h>
#include <lumbricus/discretization/surface_terms.h>
#include <lumbricus/measures/external_forces.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Where the energy of the part of the body that is computed comes from and
   * where it goes in a load step from u_a at t_a to u_b at t_b, by the trapezoidal
   * rule:
   *
   *   int psi_b dV - int psi_a dV = sum W_muscle + sum W_load - sum D,
   *   W_load   = 1/2 (f_a + f_b) . (u_b - u_a),
   *   W_muscle = 1/2 int psi(F_a, alpha_b) - psi(F_a, alpha_a)
   *                    + psi(F_b, alpha_b) - psi(F_b, alpha_a) dV,
   *
   * where alpha is the activation of that muscle, and that of the others is the
   * one of the state. From W_muscle goes, where a muscle adds P_m to the stress,
   *
   *   1/2 int (P_m,a + P_m,b) : (F_b - F_a) dV.
   *
   * D is what the viscous branches of a tissue dissipate, int of
   * ViscousBranch::dissipated(). In equilibrium the balance holds up to the error of the rule, of third order
   * in the length of the step, and in friction of second order where points begin
   * to slide. Where P_m hangs on the speed of fibres, which nothing knows at the
   * beginning of a step, f_b and P_m,b stand for the means of both ends: the error
   * is of second order then.
   */
  struct StepWork
  {
    /** Work that has a name [N mm]. */
    struct Entry
    {
      std::string name;       ///< of a muscle, a tissue or a contact
      double      work = 0.;  ///< [N mm]
    };

    /** int psi_b dV of all tissues [N mm]. */
    double stored = 0.;
    /** By how much that has grown [N mm]. */
    double stored_more = 0.;
    /** By how much it has grown by an adaptation of the mesh after the step
     * [N mm]. */
    double remeshed = 0.;
    /** W_muscle of every muscle. */
    std::vector<Entry> muscles;
    /** D of every tissue that has viscous branches. */
    std::vector<Entry> viscosity;
    /** W_load of every load and support, as ExternalForce::work. */
    std::vector<ExternalForce> loads;
    /** What friction in every contact takes away, -1/2 int (T_a + T_b) . w dA with
     * the friction's traction alone and the way w along the obstacle; part of
     * what the load of that name does. */
    std::vector<Entry> friction;

    /** What has been done on the body more than it has stored and dissipated: the
     * error of the rule [N mm]. */
    double
    imbalance() const;
  };

  /** int psi dV of all tissues at @p state, whose reference maps are those of
   * @p references [N mm]. Collective. */
  double
  stored_energy(const Body           &body,
                const ReferenceField &references,
                const State          &state);

  /** A state and what is evaluated at it. */
  struct StateWithMaps
  {
    const State          &state;      ///< in equilibrium
    const ReferenceField &references; ///< those of its time and histories
  };

  /** StepWork::muscles from @p a to @p b. Collective. */
  std::vector<StepWork::Entry>
  work_of_muscles(const Body          &body,
                  const StateWithMaps &a,
                  const StateWithMaps &b);

  /** StepWork::viscosity from @p a to @p b. Collective. */
  std::vector<StepWork::Entry>
  work_of_viscosity(const Body &body, const State &a, const StateWithMaps &b);

  /** StepWork::friction from @p a to @p b, to each of which @p terms are set in
   * turn. Collective. */
  std::vector<StepWork::Entry>
  work_of_friction(const Body               &body,
                   const BoundaryConditions &conditions,
                   SurfaceTerms             &terms,
                   const State              &a,
                   const State              &b);
} // namespace lumbricus

#endif
