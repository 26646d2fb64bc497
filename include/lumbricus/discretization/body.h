// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_body_h
#define lumbricus_discretization_body_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/discretization/shape_cache.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/filtered_iterator.h>

namespace lumbricus
{
  /** A cell of a Body that this rank owns, and what it is made of. */
  struct OwnedCell
  {
    /** Which of the owned cells, from zero in the order of iteration: what
     * ShapeCache, CellUnknowns and ReferenceField number them by. */
    unsigned int index;
    /** The cell with the unknowns of MixedSpace::dof_handler. */
    dealii::DoFHandler<dim>::active_cell_iterator iterator;
    Region                                        region;    ///< where it is
    const Tissue                                 &tissue;    ///< what it is of
    bool                                          is_liquid; ///< that tissue
  };



  /** The cells of a Body that this rank owns, for a loop over all of them. */
  class OwnedCells
  {
  public:
    /** One of deal.II's, that leaves out the cells of other ranks. */
    using Filtered =
      dealii::FilteredIterator<dealii::DoFHandler<dim>::active_cell_iterator>;

    /** What a loop advances. */
    class Iterator
    {
    public:
      /** At @p cell, the first one or the end; @p anatomy is kept by
       * reference. */
      Iterator(const Filtered &cell, const Anatomy &anatomy)
        : cell(cell)
        , anatomy(anatomy)
      {}

      /** The cell. */
      OwnedCell
      operator*() const
      {
        const Region region = Region::of(cell->material_id());
        return {index,
                cell,
                region,
                anatomy.tissue(region.tissue),
                anatomy.is_liquid(region.tissue)};
      }

      /** Go on to the next one. */
      Iterator &
      operator++()
      {
        ++cell;
        ++index;
        return *this;
      }

      /** Whether they are at different cells. */
      bool
      operator!=(const Iterator &other) const
      {
        return cell != other.cell;
      }

    private:
      Filtered       cell;
      const Anatomy &anatomy;
      unsigned int   index = 0;
    };

    /** The owned cells of @p space; both arguments are kept by reference. */
    OwnedCells(const MixedSpace &space, const Anatomy &anatomy)
      : space(space)
      , anatomy(anatomy)
    {}

    /** At the first one. */
    Iterator
    begin() const
    {
      return {*space.owned_cells().begin(), anatomy};
    }

    /** Behind the last one. */
    Iterator
    end() const
    {
      return {*space.owned_cells().end(), anatomy};
    }

  private:
    const MixedSpace &space;
    const Anatomy    &anatomy;
  };



  /**
   * The body on its mesh, as a value that is handed on: the unknowns, the shape
   * functions of the cells, and what the cells are made of. All that goes
   * through its cells does so by
   *
   *   for (const OwnedCell cell : body.owned_cells())
   */
  class Body
  {
  public:
    /** All of these are kept by reference. */
    Body(const MixedSpace &space,
         const ShapeCache &shapes,
         const Anatomy    &anatomy)
      : space(space)
      , shapes(shapes)
      , anatomy(anatomy)
    {}

    /** The cells that this rank owns. */
    OwnedCells
    owned_cells() const
    {
      return {space, anatomy};
    }

    const MixedSpace &space;   ///< the mesh at rest and the unknowns
    const ShapeCache &shapes;  ///< the shape functions on its cells
    const Anatomy    &anatomy; ///< the tissues and muscles, and the geometry
  };
} // namespace lumbricus

#endif
