// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_border_h
#define lumbricus_discretization_border_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/core/state.h>
#include <lumbricus/discretization/border_vector.h>
#include <lumbricus/discretization/tangent.h>

#include <deal.II/lac/full_matrix.h>

#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * What a few global unknowns g, of which all ranks know all, add to
   * equilibrium: each is one more row s_k = 0 and one more column,
   *
   *   r(u, g) = 0,     [ K  B ] [du]     [r]
   *   s(u, g) = 0,     [ C  D ] [dg] = - [s].
   *
   * C need not be B^T. A value; all of it but the entries of vectors is the
   * same on all ranks.
   */
  struct Border
  {
    /** What State::globals calls the unknowns, and how many of that name there
     * are, in the order of rows and columns. */
    std::vector<std::pair<std::string, unsigned int>> names;
    /** s [any unit, the one of scale]. */
    std::vector<double> residual;
    /** The size of s that is as bad as a volume that is wrong by the volume of
     * the body; more than 0, in the unit of s. */
    std::vector<double> scale;
    /** What rounding makes of s where it is 0, in the unit of s. */
    std::vector<double> rounding;
    /** B_k = dr/dg_k in the free unknowns (CellUnknowns::add()). */
    std::vector<BorderVector> columns;
    /** C_k = ds_k/du in the free unknowns. */
    std::vector<BorderVector> rows;
    /** D = ds/dg. */
    dealii::FullMatrix<double> corner;

    /** The number of global unknowns. */
    unsigned int
    size() const
    {
      return residual.size();
    }

    /** Let the unknowns of another border, with other names, follow. */
    void
    append(const Border &other);

    /** The unknowns in their order. */
    std::vector<double>
    read(const Globals &globals) const;

    /** The opposite of read(). */
    Globals
    write(const std::vector<double> &values) const;
  };



  /** [K B; C D] with C^T in place of B, B^T of C and D^T of D; nothing else that a
   * border has changes. */
  Border
  transposed(const Border &border);



  /** Whoever borders equilibrium. All functions are collective. */
  class BorderSource
  {
  public:
    virtual ~BorderSource() = default;

    /** The unknowns, with their values at rest. */
    virtual Globals
    globals_at_rest() const = 0;

    /**
     * The border at the displacements and pressures @p solution, at @p globals
     * and the loads at @p t; what the global unknowns add to r is added to
     * @p r, in the free unknowns this rank owns. Columns, rows and corner are
     * there only where @p tangent is not null; then what the global unknowns
     * add to K is added to it, and what the constraints still prescribe of du
     * is brought to @p r and to the residual.
     */
    virtual Border
    border(const Vector   &solution,
           const Globals  &globals,
           const LoadTime &t,
           Tangent        *tangent,
           Vector         &r) = 0;
  };
} // namespace lumbricus

#endif
