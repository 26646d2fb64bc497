// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_round_section_h
#define lumbricus_geometry_round_section_h

#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <vector>

#include "cross_section.h"
#include "extrusion.h"

namespace lumbricus
{
  /**
   * What bodies with a round cross-section have in common: a liquid chamber
   * (or a hole), a wall of layers around it, the part of the circle that is
   * meshed, and the cells in it.
   */
  class RoundSection : public ParameterOwner
  {
  public:
    /**
     * @param path of the section the parameters are in, for messages;
     * @param reserved the names of the tissues that are not layers.
     */
    RoundSection(const std::string              &path,
                 const std::vector<std::string> &reserved);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    /**
     * Throw ExcInput if @p n_thicknesses, how many the parameter "Wall layer
     * thicknesses" of section @p where has, are not one for each layer.
     */
    void
    check_thicknesses(const std::string &where,
                      const unsigned int n_thicknesses) const;

    /** The number of cells of cross_section(). */
    double
    n_cells(const bool filled) const;

    /** The pattern of the cells, with a disk inside where @p filled, else with
     * a hole. */
    CrossSection
    cross_section(const bool filled) const;

    /** { liquid, layer 1 outside, ... } from radius and thicknesses. */
    static std::vector<double>
    ring_radii(const double radius, const std::vector<double> &thicknesses);

    /** The layers as tissues, behind those in @p tissues. */
    void
    append_layers(std::vector<TissueName> &tissues) const;

    /** The symmetry planes, with boundary ids from @p first on. */
    std::vector<SymmetryPlane>
    symmetry_planes(const unsigned int first) const;

    /** The id of a symmetry plane, where those of the names end at @p first. */
    static dealii::types::boundary_id
    symmetry_boundary(const BodySurface surface, const unsigned int first);

    /** Throw ExcInput if parameter @p name of section @p path is odd. */
    static void
    check_even(const std::string &path,
               const std::string &name,
               const unsigned int n,
               const std::string &reason);

    /** The names of the layers of the wall, from inside to outside. */
    const std::vector<std::string> &
    layer_names() const
    {
      return layers;
    }

    /** How many layers the wall has. */
    unsigned int
    n_layers() const
    {
      return layers.size();
    }

  private:
    const std::string              path;
    const std::vector<std::string> reserved;

    std::vector<std::string> layers           = {"longitudinal muscle",
                                                 "circular muscle"};
    std::string              part             = "full";
    unsigned int             n_around_quarter = 4;
    unsigned int             n_disk_rings     = 1;
    unsigned int             n_layer_cells    = 1;
  };
} // namespace lumbricus

#endif
