// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_enrichment_h
#define lumbricus_errors_enrichment_h

#include <lumbricus/discretization/tangent.h>
#include <lumbricus/errors/cut_cells.h>
#include <lumbricus/errors/family_functions.h>
#include <lumbricus/errors/hanging_functions.h>
#include <lumbricus/linear/free_numbering.h>
#include <lumbricus/linear/mumps.h>

#include <array>
#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * Functions that small cells, eight in place of each, have beyond those of the
   * large ones. Of displacements: on each line of three nodes through a large cell,
   * in each direction, the two that are 1 at one quarter of the line and 0 at its
   * nodes and the other quarter, quadratic from line to line. Of pressures: the six
   * products of two coordinates. They are about 2.6 times as many as the functions
   * of the large cells and coupled as these are, so that their own matrix can be
   * factored, while that of the small cells could not.
   *
   * Those of cells of liquid alone are left out, since hydrostatic liquid needs none.
   * Where hanging nodes follow a node, HangingFunctions take their place.
   */
  class Enrichment
  {
  public:
    /** For the mesh of @p tangent, of small cells. All are kept by reference.
     * Collective. */
    Enrichment(const Body     &small,
               const Tangent  &tangent,
               const CutCells &cells);

    /** Compute their matrix from what the tangent is now and factor it. Throws
     * ExcNotConverged, ExcSolveFailed. Collective. */
    void
    factor();

    /** Add to @p x, in the free unknowns of the small cells, the function of these
     * whose residual is @p r, with a stiff penalty in place of the volume
     * constraint. Collective. */
    void
    correct(Vector &x, const Vector &r) const;

  private:
    /** The eight children of a large cell. */
    struct Family
    {
      /** Numbers of the owned small cells. */
      std::array<unsigned int, FamilyFunctions::n_children> children;
      /** Of each function the place of the node where it is 1; none for those that
       * are left out, and for pressures. The hanging ones come last. */
      std::vector<unsigned int> places;
      /** Those of its functions. */
      std::vector<HangingFunctions::Entry> hanging;
      /** Of the pressures from its matrix. */
      FamilyFunctions::Elimination elimination;
    };

    /** Number the displacements. Collective. */
    void
    number(const CutCells &cells);

    /** The matrix of a family. */
    dealii::FullMatrix<double>
    matrix(const Family &family) const;

    /** Add to the rows and columns of the hanging functions what the matrix @p K of
     * a child makes of them. */
    void
    add_hanging(const Family               &family,
                const unsigned int          child,
                const std::vector<double>  &K,
                dealii::FullMatrix<double> &all) const;

    const Body     body;
    const Tangent &tangent;

    const FamilyFunctions          functions;
    std::vector<Family>            families;
    Vector                         shares; ///< among solid cells
    std::vector<unsigned int>      of_hanging; ///< their places that are owned
    FreeNumbering                  numbering;
    std::unique_ptr<Mumps<double>> mumps;
  };
} // namespace lumbricus

#endif
