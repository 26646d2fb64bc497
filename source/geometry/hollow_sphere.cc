// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "coarse_cells.h"
#include "mesh_measures.h"
#include "round_section.h"

namespace lumbricus
{
  /**
   * An eighth of a hollow sphere about the origin, of one tissue: one segment
   * between planes of symmetry, with a cavity inside or a surface there for loads.
   * The three quarters of the coordinate planes meet in three patches of cells.
   */
  class HollowSphere : public Geometry
  {
  public:
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
    tissues() const override
    {
      return {{"wall", false, true}};
    }

    std::vector<std::string>
    boundary_names() const override
    {
      return has_cavity() ? std::vector<std::string>{"outside"} :
                            std::vector<std::string>{"outside", "inside"};
    }

    std::vector<SymmetryPlane>
    symmetry_planes() const override
    {
      const dealii::types::boundary_id first = boundary_names().size();
      return {{first, 0}, {first + 1, 1}, {first + 2, 2}};
    }

    std::vector<CavityWall>
    cavities() const override
    {
      const dealii::types::boundary_id id = boundary_names().size() + dim;
      return has_cavity() ? std::vector<CavityWall>{{id, 0}} :
                            std::vector<CavityWall>();
    }

    std::vector<SegmentSections>
    sections() const override
    {
      const CoarseMesh mesh = coarse_mesh();
      return mesh_sections(mesh.vertices, mesh.cells, tissues(), 1);
    }

    std::array<dealii::Point<dim>, 3>
    support_points() const override
    {
      // The planes of symmetry hold it.
      return {{dealii::Point<dim>(radius, 0., 0.),
               dealii::Point<dim>(radius, 0., 0.),
               dealii::Point<dim>(radius, 0., 0.)}};
    }

    double
    characteristic_length() const override
    {
      return radius;
    }

  private:
    inline static const std::string path = "Geometry/hollow sphere";

    struct CoarseMesh
    {
      std::vector<dealii::Point<dim>>    vertices;
      std::vector<dealii::CellData<dim>> cells;
    };

    bool
    has_cavity() const
    {
      return inside == "cavity";
    }

    CoarseMesh
    coarse_mesh() const;

    double       radius    = 1.;
    double       thickness = 0.1;
    std::string  inside    = "cavity";
    unsigned int n_around  = 4;
    unsigned int n_through = 1;
  };



  void
  HollowSphere::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Radius",
                      radius,
                      "[mm] Inner radius of the sphere.",
                      PositiveNumber());
    prm.add_parameter("Wall thickness",
                      thickness,
                      "[mm] Outer minus inner radius.",
                      PositiveNumber());
    prm.add_parameter("Inside",
                      inside,
                      "What is inside. 'cavity': one pressure, see Cavities. "
                      "'surface': nothing; it is the boundary 'inside'.",
                      dealii::Patterns::Selection("cavity|surface"));
    prm.add_parameter("Cells around a quarter",
                      n_around,
                      "[number, even] Cells along a quarter of a circle.",
                      dealii::Patterns::Integer(2));
    prm.add_parameter("Cells through the wall",
                      n_through,
                      "[number] Cells through the thickness of the wall, all of "
                      "one shape.",
                      dealii::Patterns::Integer(1));
  }



  void
  HollowSphere::check_parameters() const
  {
    RoundSection::check_even(path,
                             "Cells around a quarter",
                             n_around,
                             "the patches of cells of an eighth of a sphere "
                             "meet in the middle of its edges");
    check_n_coarse_cells(path, 0.75 * n_around * n_around * n_through);
  }



  HollowSphere::CoarseMesh
  HollowSphere::coarse_mesh() const
  {
    using Point          = dealii::Point<dim>;
    const unsigned int n = n_around / 2;
    const double       growth =
      std::pow(1. + thickness / radius, 1. / n_through);
    CoarseMesh mesh;
    for (unsigned int axis = 0; axis < dim; ++axis)
      {
        // From the axis to the middles of the edges beside it, and to that of
        // the octant: right-handed with the radius.
        Point towards[2];
        for (unsigned int d = 0; d < 2; ++d)
          towards[d][(axis + 1 + d) % dim] = 1.;
        Point at_axis;
        at_axis[axis]            = 1.;
        const unsigned int first = mesh.vertices.size();
        for (unsigned int k = 0; k <= n_through; ++k)
          for (unsigned int j = 0; j <= n; ++j)
            for (unsigned int i = 0; i <= n; ++i)
              {
                // Equal angles along the edges.
                const double quarter = dealii::numbers::PI / 4.;
                const Point  x =
                  at_axis + std::tan(quarter * i / n) * towards[0] +
                  std::tan(quarter * j / n) * towards[1];
                mesh.vertices.push_back(
                  Point(radius * std::pow(growth, k) / x.norm() * x));
              }
        const auto number = [&](const unsigned int i,
                                const unsigned int j,
                                const unsigned int k) {
          return first + (k * (n + 1) + j) * (n + 1) + i;
        };
        for (unsigned int k = 0; k < n_through; ++k)
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              {
                dealii::CellData<dim> cell;
                for (unsigned int v = 0; v < cell.vertices.size(); ++v)
                  cell.vertices[v] =
                    number(i + v % 2, j + v / 2 % 2, k + v / 4);
                cell.material_id = Region{0, 0}.material_id();
                mesh.cells.push_back(cell);
              }
      }
    dealii::SubCellData       none;
    std::vector<unsigned int> all;
    dealii::GridTools::delete_duplicated_vertices(
      mesh.vertices, mesh.cells, none, all, 1e-8 * radius);
    return mesh;
  }



  void
  HollowSphere::create_coarse_mesh(
    dealii::Triangulation<dim> &triangulation) const
  {
    const CoarseMesh mesh = coarse_mesh();
    triangulation.create_triangulation(mesh.vertices, mesh.cells, {});

    const auto planes    = symmetry_planes();
    const auto is_inside = [&](const dealii::Point<dim> &x) {
      return x.norm() < radius * (1. + 1e-8);
    };
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            dealii::types::boundary_id id =
              !is_inside(face->vertex(0)) ? 0 :
              has_cavity()                ? cavities()[0].boundary :
                                            1;
            for (const SymmetryPlane &plane : planes)
              {
                bool lies_in_it = true;
                for (unsigned int v = 0; v < face->n_vertices(); ++v)
                  lies_in_it = lies_in_it &&
                               std::abs(face->vertex(v)[plane.direction]) <
                                 1e-8 * radius;
                if (lies_in_it)
                  id = plane.boundary;
              }
            face->set_boundary_id(id);
          }
    constexpr dealii::types::manifold_id round = 1;
    triangulation.set_all_manifold_ids(round);
    triangulation.set_manifold(round, dealii::SphericalManifold<dim>());
  }



  static const Register<Geometry, HollowSphere>
    hollow_sphere("hollow sphere",
                  "an eighth of a hollow sphere between planes of symmetry.");
} // namespace lumbricus
