// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_path_direction_h
#define lumbricus_continuation_path_direction_h

#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/border_vector.h>
#include <lumbricus/discretization/cell_unknowns.h>

namespace lumbricus
{
  /** A way along a path of equilibria: changes of displacements and of the load
   * parameter. */
  struct PathDirection
  {
    Vector u; ///< change of displacements and pressures [mm, N/mm^2]
    double t; ///< change of the load parameter [time]
  };



  /**
   * The length of ways along a path of equilibria,
   *
   *   |(u, t)|^2 = 1/2 (T/U)^2 1/V int |u|^2 dV + 1/2 t^2,
   *
   * [time] over the solid at rest, whose volume is V. With U the mean displacement
   * over a first step of the time T it is T long, half of it by each. The liquid
   * does not count: its nodes may be anywhere.
   */
  class PathMetric
  {
  public:
    /** Of the body at rest; @p displacement is T/U [time/mm]. Collective. */
    PathMetric(const Body         &body,
               const CellUnknowns &unknowns,
               const double        displacement);

    /** The row w of the free unknowns with w . du = 1/2 (T/U)^2 1/V int u . du dV
     * for the u of @p direction. Collective. */
    Vector
    row(const Vector &u) const;

    /** The scalar product of two ways, the first by its row(). Collective. */
    double
    product(const Vector &row, const double t, const PathDirection &way) const;

    /** |(u, t)|. Collective. */
    double
    length(const PathDirection &way) const;

    /** (1/V int |u|^2 dV)^(1/2) over the solid of @p body, for the T/U of the
     * others [mm]. Collective. */
    static double
    mean_displacement(const Body         &body,
                      const CellUnknowns &unknowns,
                      const Vector       &u);

  private:
    const Body          body;
    const CellUnknowns &unknowns;
    double              factor; // 1/2 (T/U)^2 1/V
  };
} // namespace lumbricus

#endif
