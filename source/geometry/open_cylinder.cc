// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <string>
#include <vector>

#include "coarse_cells.h"
#include "extrusion.h"
#include "round_section.h"

namespace lumbricus
{
  /**
   * A tube along the x axis from 0 to its length, open at both ends, with or
   * without a liquid in it: one segment without septa and caps. A liquid that
   * has no cells is closed in by pistons, planes that cover its ends.
   */
  class OpenCylinder : public Geometry
  {
  public:
    OpenCylinder()
      : section(path, {"liquid"})
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    void
    create_coarse_mesh(
      dealii::Triangulation<dim> &triangulation) const override;

    unsigned int
    n_segments() const override
    {
      return 1;
    }

    std::vector<TissueName>
    tissues() const override;

    std::vector<std::string>
    boundary_names() const override;

    std::vector<CavityWall>
    cavities() const override;

    std::vector<SymmetryPlane>
    symmetry_planes() const override
    {
      return section.symmetry_planes(boundary_names().size());
    }

    std::string
    way_without_symmetry() const override
    {
      return "Set 'Geometry/open cylinder/Cross-section' to 'full'.";
    }

    std::vector<SegmentSections>
    sections() const override
    {
      return {{0., length / 2, length}};
    }

    std::array<dealii::Point<dim>, 3>
    support_points() const override;

    double
    characteristic_length() const override
    {
      return radius;
    }

  private:
    inline static const std::string path = "Geometry/open cylinder";

    // The boundary ids; those of the symmetry planes follow, and then that of a
    // cavity. What comes after the skin depends on whether there is a liquid.
    enum Boundary : unsigned int
    {
      head           = 0,
      tail           = 1,
      skin           = 2,
      inside         = 3,
      head_of_liquid = 3,
      tail_of_liquid = 4
    };

    bool
    has_cavity() const
    {
      return filled && liquid == "cavity";
    }

    /** Whether there are cells inside the wall. */
    bool
    is_solid() const
    {
      return filled && !has_cavity();
    }

    std::vector<double>
    radii() const
    {
      return RoundSection::ring_radii(radius, layer_thicknesses);
    }

    RoundSection        section;
    double              radius            = 2.;
    double              length            = 4.;
    std::vector<double> layer_thicknesses = {0.15, 0.15};
    bool                filled            = true;
    std::string         liquid            = "meshed";
    unsigned int        n_along           = 4;
  };



  void
  OpenCylinder::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Radius",
                      radius,
                      "[mm] Inner radius of the tube.",
                      PositiveNumber());
    prm.add_parameter("Length",
                      length,
                      "[mm] Length of the tube along the axis.",
                      PositiveNumber());
    prm.add_parameter("Wall layer thicknesses",
                      layer_thicknesses,
                      "[mm] Thickness of each layer of the wall, from inside "
                      "to outside, separated by commas.",
                      dealii::Patterns::List(PositiveNumber(), 1, 64));
    prm.add_parameter("Filled",
                      filled,
                      "[true or false] Whether the tube is filled with liquid. "
                      "If so, the ends of the liquid are the boundaries 'head "
                      "of the liquid' and 'tail of the liquid', where it is "
                      "meshed; if not, the inner surface is the boundary "
                      "'inside'.");
    prm.add_parameter("Liquid",
                      liquid,
                      "What is in a tube that is filled. 'meshed': cells of "
                      "the tissue 'liquid', a soft rubber that is reset. "
                      "'cavity': no cells, but one pressure, see Cavities; it "
                      "acts on pistons over the whole of both ends, so that "
                      "displacements of 'head' and 'tail' have to be "
                      "prescribed along x, the same all over an end.",
                      dealii::Patterns::Selection("meshed|cavity"));
    section.declare_parameters(prm);
    prm.add_parameter("Cells along the cylinder",
                      n_along,
                      "[number, even] Cells along the axis.",
                      dealii::Patterns::Integer(2));
  }



  void
  OpenCylinder::check_parameters() const
  {
    section.check_parameters();
    section.check_thicknesses(path, layer_thicknesses.size());
    RoundSection::check_even(path,
                             "Cells along the cylinder",
                             n_along,
                             "faces of the mesh have to lie in the middle, "
                             "where the cylinder is measured");
    check_n_coarse_cells(path, section.n_cells(is_solid()) * n_along);
    AssertThrow(filled || liquid == "meshed",
                ExcParameter("Liquid",
                             "is 'cavity', but the tube is empty. Set "
                             "'Filled' to true, or remove 'Liquid'."));
  }



  void
  OpenCylinder::create_coarse_mesh(
    dealii::Triangulation<dim> &triangulation) const
  {
    std::vector<AxialStation> stations;
    for (unsigned int i = 0; i <= n_along; ++i)
      stations.push_back({length * i / n_along, radii()});

    // Without a liquid there is no ring 0, and the first layer is tissue 0.
    const auto region = [&](const unsigned int /*slab*/,
                            const unsigned int ring) {
      return Region{0, is_solid() ? ring : ring - 1};
    };

    const unsigned int n_names  = boundary_names().size();
    const auto         walls    = cavities();
    const auto         boundary = [&](const BodySurface  surface,
                              const unsigned int ring,
                              const unsigned int /*slab*/)
      -> dealii::types::boundary_id {
      switch (surface)
        {
          case BodySurface::head:
            return ring == 0 ? head_of_liquid : head;
          case BodySurface::tail:
            return ring == 0 ? tail_of_liquid : tail;
          case BodySurface::outer:
            return skin;
          case BodySurface::inner:
            return walls.empty() ? inside : walls[0].boundary;
          default:
            return RoundSection::symmetry_boundary(surface, n_names);
        }
    };

    extrude(section.cross_section(is_solid()),
            stations,
            region,
            boundary,
            triangulation);
  }



  std::vector<TissueName>
  OpenCylinder::tissues() const
  {
    std::vector<TissueName> all;
    if (is_solid())
      all.push_back({"liquid", true});
    section.append_layers(all);
    return all;
  }



  std::vector<std::string>
  OpenCylinder::boundary_names() const
  {
    std::vector<std::string> names = {"head", "tail", "skin"};
    if (is_solid())
      names.insert(names.end(), {"head of the liquid", "tail of the liquid"});
    else if (!has_cavity())
      names.emplace_back("inside");
    return names;
  }



  std::vector<CavityWall>
  OpenCylinder::cavities() const
  {
    if (!has_cavity())
      return {};
    const unsigned int first = boundary_names().size();
    return {{first + unsigned(symmetry_planes().size()), 0, {head, tail}}};
  }



  std::array<dealii::Point<dim>, 3>
  OpenCylinder::support_points() const
  {
    // On the axis if there is material; else on the inner rim, where z > 0.
    const double z = is_solid() ? 0. : radius;
    return {{dealii::Point<dim>(0., 0., z),
             dealii::Point<dim>(length, 0., z),
             dealii::Point<dim>(0., 0., radii().back())}};
  }



  static const Register<Geometry, OpenCylinder>
    open_cylinder("open cylinder",
                  "a tube with a wall of layers, open at both ends, with or "
                  "without a liquid in it.");
} // namespace lumbricus
