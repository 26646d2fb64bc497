// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_newton_h
#define lumbricus_equilibrium_newton_h

#include <lumbricus/equilibrium/unknowns.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** All that Newton's method knows of a problem. */
  class NonlinearProblem
  {
  public:
    /** A residual, in parts that are each small in equilibrium. */
    struct Residual
    {
      /** Out-of-balance force relative to the level of the forces. */
      double force = 0.;
      /** Violated volume constraint relative to the volume of the body. */
      double volume = 0.;
      /** What constraints that change with x are violated by, relative to the
       * size of the body. */
      double gap = 0.;
      /** What the equations of global unknowns are violated by, relative to
       * Border::scale: the sum over all of them. */
      double border = 0.;
      /** The force that rounding makes of a solution, in the same measure:
       * nothing less can be asked for. */
      double force_rounding = 0.;
      /** The same of the volume. */
      double volume_rounding = 0.;
      /** The same of the equations of global unknowns. */
      double border_rounding = 0.;
      /** False where the residual does not exist (an inverted element). */
      bool valid = true;

      /** What the line search watches. */
      double
      merit() const
      {
        return force + volume + gap + border;
      }
    };

    virtual ~NonlinearProblem() = default;

    /** How far @p x is from a solution. Collective. */
    virtual Residual
    residual(const Unknowns &x) = 0;

    /** Compute the tangent and the right-hand side at x.
     * @return whether they exist there, as Residual::valid. */
    virtual bool
    linearise(const Unknowns &x) = 0;

    /** Compute the increment dx at which the linearised residual is
     * @p tolerance times what it is without one. */
    virtual void
    solve(Unknowns &dx, const double tolerance) = 0;

    /** No linear system is solved less accurately than to this part of its
     * residual. */
    virtual double
    largest_linear_tolerance() const
    {
      return 3e-3;
    }

    /** The size of an increment of u relative to the size of the body. */
    virtual double
    increment_size(const Vector &dx) const = 0;

    /** The part of @p dx up to which a step from @p x, whose residual was the
     * last to be computed, can go before bounded forces, as of friction, that give
     * way to it push back by more than drives it; 1 where they do not. The residual
     * cannot tell: it hardly grows, however far the step goes. Collective. */
    virtual double
    largest_step(const Unknowns & /*x*/, const Unknowns & /*dx*/)
    {
      return 1.;
    }

    /** Whether dx carries prescribed displacements that x still lacks: then
     * it has to be taken whole. */
    virtual bool
    increments_prescribed() const = 0;

    /** dx with what is prescribed has been added to x. */
    virtual void
    increments_taken() = 0;

    /** Where the trouble is at x, in words: "segment 3, ...". */
    virtual std::string
    locate_trouble(const Unknowns &x) = 0;
  };



  /** One iteration, for logs and for tests of the order of convergence. */
  struct NewtonIteration
  {
    NonlinearProblem::Residual residual;  ///< after it
    double                     increment; ///< size of dx, see increment_size()
    double                     step_length; ///< part of dx that was taken
  };



  /**
   * Newton's method with a backtracking line search. A step is taken whole
   * unless an element inverts or the residual grows beyond what a saddle
   * point may show on its way, and goes no farther than to where friction pushes
   * back.
   */
  class Newton : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /**
     * Solve, starting at @p x, which is changed only by success.
     * Throws ExcNotConverged with where and how.
     */
    std::vector<NewtonIteration>
    solve(NonlinearProblem &problem, Unknowns &x) const;

    /** Call @p new_listener with every iteration, as it ends. */
    void
    report_to(const std::function<void(const NewtonIteration &)> &new_listener);

  private:
    /** The tolerance of the force, or what rounding leaves where that is
     * more. */
    double
    least_force(const NonlinearProblem::Residual &residual) const;

    /** The same of the volume. */
    double
    least_volume(const NonlinearProblem::Residual &residual) const;

    /** The same of the equations of global unknowns. */
    double
    least_border(const NonlinearProblem::Residual &residual) const;

    /** How accurately to solve the linear system at a residual, when it was
     * @p last_merit one iteration earlier (0: there was none); at least to
     * @p most. */
    double
    linear_tolerance(const NonlinearProblem::Residual &residual,
                     const double                      last_merit,
                     const double                      most) const;

    double       force_tolerance     = 1e-9;
    double       volume_tolerance    = 1e-11;
    double       increment_tolerance = 1e-10;
    unsigned int most_iterations     = 20;
    unsigned int most_halvings       = 6;
    double       growth_allowed      = 10.;

    std::function<void(const NewtonIteration &)> listener;
  };
} // namespace lumbricus

#endif
