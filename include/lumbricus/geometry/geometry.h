// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_geometry_h
#define lumbricus_geometry_geometry_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Where a cell belongs: its segment and its tissue, both counted from zero.
   * Set on all coarse cells and inherited by their children, as material id.
   */
  struct Region
  {
    /** From the head. */
    unsigned int segment;
    /** The index in Geometry::tissues(). */
    unsigned int tissue;

    /** More tissues do not fit into a material id. */
    static constexpr unsigned int max_n_tissues = 256;

    /** The material id of its cells: 256 segment + tissue. */
    dealii::types::material_id
    material_id() const
    {
      return segment * max_n_tissues + tissue;
    }

    /** The region whose cells have the material id @p id. */
    static Region
    of(const dealii::types::material_id id)
    {
      return {id / max_n_tissues, id % max_n_tissues};
    }
  };



  /** A kind of material the geometry has cells of. */
  struct TissueName
  {
    /** The name of its section in Tissues. */
    std::string name;
    /** A liquid is reset; everything else is the wall, which keeps its stress.
     */
    bool liquid;
    /** Whether it is a layer of the wall around the chamber, on whose sections
     * the length of a segment is measured; septa and caps are not. */
    bool wall_layer = false;
  };



  /** A plane of mirror symmetry: the displacement along @p direction is zero.
   */
  struct SymmetryPlane
  {
    /** The id of its faces. */
    dealii::types::boundary_id boundary;
    /** The axis it is normal to: 0, 1, 2 for x, y, z. */
    unsigned int direction;

    /** Where it is along its normal, in @p mesh, that of the body [mm]. */
    double
    position(const dealii::Triangulation<dim> &mesh) const
    {
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary)
            return face->center()[direction];
      return 0.;
    }
  };



  /** The wall around a chamber whose liquid has no cells. */
  struct CavityWall
  {
    /** The id of its faces, which close it together with planes of symmetry and
     * with pistons. */
    dealii::types::boundary_id boundary;
    /** Which segment's chamber it is, from zero; each has at most one. */
    unsigned int segment;
    /** The ids of the ends of a tube that pistons close: planes x = const, which
     * stay such planes. Empty for a chamber with a wall all around. */
    std::vector<dealii::types::boundary_id> pistons = {};
    /** A point in all planes of symmetry [mm]. */
    dealii::Point<dim> origin = dealii::Point<dim>();
  };



  /**
   * The cross-sections x = const (reference configuration) between which a
   * segment is measured; mesh faces lie in all of them, at every refinement.
   */
  struct SegmentSections
  {
    double begin;  ///< towards the head [mm]
    double middle; ///< [mm]
    double end;    ///< towards the tail [mm]
  };



  /**
   * A body: its mesh in the reference configuration, made of hexahedra, and
   * the names of its parts. The axis of the body is the x axis.
   */
  class Geometry : public ParameterOwner
  {
  public:
    /**
     * Make the coarse mesh: cells with the material id of their Region,
     * boundary ids that index boundary_names(), manifolds that keep curved
     * surfaces curved under refinement. The same on every rank.
     */
    virtual void
    create_coarse_mesh(dealii::Triangulation<dim> &triangulation) const = 0;

    /** How many segments the body has; at least one. */
    virtual unsigned int
    n_segments() const = 0;

    /** The index of a tissue here is Region::tissue. */
    virtual std::vector<TissueName>
    tissues() const = 0;

    /** The names loads refer to; the index of a name is the boundary id. */
    virtual std::vector<std::string>
    boundary_names() const = 0;

    /**
     * Why no load can act on what is called @p name, as the end of a sentence
     * about it, where it is a surface inside the body, or partly so; empty for
     * all other names.
     */
    virtual std::string
    inside_of_body(const std::string & /*name*/) const
    {
      return "";
    }

    /** Empty for a full cross-section. Their ids follow those of the names. */
    virtual std::vector<SymmetryPlane>
    symmetry_planes() const = 0;

    /** The chambers without cells inside, in the order of their segments. Their
     * ids follow those of the planes of symmetry, so that no load can act on
     * them. */
    virtual std::vector<CavityWall>
    cavities() const
    {
      return {};
    }

    /** What to set so that the body has no planes of symmetry, a sentence for
     * messages. */
    virtual std::string
    way_without_symmetry() const
    {
      return "Compute the whole body, without this plane.";
    }

    /**
     * How many times the mesh fits into the whole body: 1 for a full, 2 for
     * a half, 4 for a quarter cross-section.
     */
    unsigned int
    symmetry_factor() const
    {
      return 1u << symmetry_planes().size();
    }

    /** One entry per segment. */
    virtual std::vector<SegmentSections>
    sections() const = 0;

    /** From the first section to the last at rest [mm]. */
    double
    length() const
    {
      const auto all = sections();
      return std::abs(all.back().end - all.front().begin);
    }

    /**
     * Three mesh vertices A, B, C for the statically determinate support:
     * B is apart from A along x, C is apart from A along z.
     */
    virtual std::array<dealii::Point<dim>, 3>
    support_points() const = 0;

    /** A length typical of the body (radius, edge), for relative tolerances. */
    virtual double
    characteristic_length() const = 0;
  };
} // namespace lumbricus

#endif
