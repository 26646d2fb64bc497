// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_load_unknown_h
#define lumbricus_equilibrium_load_unknown_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/core/state.h>
#include <lumbricus/discretization/border_vector.h>

#include <string>

namespace lumbricus
{
  /**
   * The load parameter t as one more unknown of equilibrium, with one more
   * equation n, which says how far to go along the path of equilibria:
   *
   *   r(u, g, t) = 0,   n(u, t) = 0.
   *
   * The columns dr/dt and ds/dt, where s are the equations of the other global
   * unknowns, are differences of residuals, so that they hold for all that
   * depends on t, whatever it is.
   */
  class LoadUnknown
  {
  public:
    virtual ~LoadUnknown() = default;

    /** What State::globals calls t during such a solve. */
    static const std::string name;

    /** Set all loads but those that are handed t, as muscles are. Collective. */
    virtual void
    set_loads(const LoadTime &t) = 0;

    /** The difference of times from which dr/dt is computed [time]. */
    virtual double
    difference() const = 0;

    /** The equation n = 0. */
    struct Equation
    {
      double residual; ///< n [-]
      double rounding; ///< what rounding makes of n
    };

    /** Its derivatives. */
    struct Derivatives
    {
      BorderVector by_u; ///< dn/du in the free unknowns [1/mm]
      double       by_t; ///< dn/dt [1/time]
    };

    /** The equation at the displacements and pressures @p solution and the loads
     * at @p t. Collective. */
    virtual Equation
    equation(const Vector &solution, const double t) const = 0;

    /** Its derivatives there. */
    virtual Derivatives
    derivatives(const Vector &solution, const double t) const = 0;
  };
} // namespace lumbricus

#endif
