// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_block_patch_h
#define lumbricus_geometry_block_patch_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace lumbricus
{
  /** The names of a block's faces, in the order of deal.II's numbers. */
  extern const std::array<std::string, 6> block_face_names;



  /**
   * A rectangle on a face of a block that is a boundary of its own. Its edges
   * lie on mesh lines.
   */
  class BlockPatch : public ParameterOwner
  {
  public:
    /** The patch of the section @p name. */
    explicit BlockPatch(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /**
     * Check that the rectangle is made of whole faces of cells of a block with
     * these edges and cells. Throws ExcInput naming the parameter of
     * @p section.
     */
    void
    check(const std::string               &section,
          const std::vector<double>       &lengths,
          const std::vector<unsigned int> &n_cells) const;

    /** The number of the face it is on. */
    unsigned int
    face() const;

    /** Whether a point of its face is inside. */
    bool
    contains(const dealii::Point<dim> &X) const;

    /** Whether the two have an area in common. */
    bool
    overlaps(const BlockPatch &other) const;

    /** The name of its section, which is that of the boundary. */
    std::string name;

  private:
    /** The two axes along the face. */
    std::array<unsigned int, dim - 1>
    axes() const;

    std::string         face_name = "x max";
    std::vector<double> from      = {0., 0.};
    std::vector<double> to        = {1., 1.};
  };
} // namespace lumbricus

#endif
