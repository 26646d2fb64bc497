// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_stability_h
#define lumbricus_equilibrium_stability_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/linear/linear_solver.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * How stiff a body is in equilibrium against small motions v of its wall that
   * keep all volumes,
   *
   *   k(v) = (v . K v) / int_wall |v|^2 dV   [N/mm per mm^3],
   *
   * where K is the tangent. Where the least k is zero equilibrium is not
   * unique: a limit point if the loads drive the motion, else a bifurcation
   * (Wriggers 2008, Nonlinear Finite Element Methods, chapter 7). The liquid
   * moves with the wall and does not count: inside it next to no stiffness is
   * no instability.
   */
  class Stability
  {
  public:
    /** Of the linearisation @p tangent with @p border around it, with which
     * @p linear_solver solves. All of these are kept by reference. */
    Stability(const Body    &body,
              const Tangent &tangent,
              const Border  &border,
              LinearSolver  &linear_solver);

    /** A motion and its stiffness. */
    struct Motion
    {
      Vector     v;              ///< |v| = 1
      double     stiffness = 0.; ///< k(v) [N/mm^4]
    };

    /** The motion of least |k|, by inverse iteration. Throws ExcNotConverged
     * where the tangent is singular. Collective. */
    Motion
    softest_motion() const;

    /** The ends of the spectrum of k. */
    struct Ends
    {
      double softest = 0.;          ///< the least positive k; 0 if there is none
      std::vector<Motion> unstable; ///< those of negative k, of least |k| first
    };

    /** Find them by Lanczos's method for the inverse of the tangent, of which they
     * are the two ends, in as many solves as it takes. Motions whose |k| is a
     * thousand times the least are not among them. Throws ExcNotConverged where
     * the tangent is singular. Collective. */
    Ends
    ends() const;

    /** What has become of @p before, which was one of the softest motions for
     * another tangent like this, apart from its part in @p other. Throws
     * ExcNotConverged. Collective. */
    Motion
    follow(const Motion &before, const Motion &other) const;

    /** The motion by which the body answers to a small force @p f. Throws
     * ExcNotConverged. Collective. */
    Motion
    response(const Vector &f) const;

    /** int_wall v . w dV, between 0 and 1: how much alike two motions are.
     * Collective. */
    double
    likeness(const Motion &one, const Motion &other) const;

    /** In words, where the motion is largest: "segment 2, septum".
     * Collective. */
    std::string
    place(const Motion &motion) const;

  private:
    /** Some force that has no symmetry. */
    Vector
    any_force() const;

    /** K^-1 f with the border. */
    Vector
    solve(const Vector &f) const;

    /** M v, where v . M v = int_wall |v|^2 dV. */
    Vector
    mass(const Vector &v) const;

    const Body     body;
    const Tangent &tangent;
    const Border  &border;
    LinearSolver  &linear_solver;
  };
} // namespace lumbricus

#endif
