// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/ellipsoid_shells.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "coarse_cells.h"
#include "mesh_measures.h"
#include "round_section.h"

namespace lumbricus
{
  namespace
  {
    // Coordinates of a wall of ellipsoids: rho from the apex (0) to the base (1),
    // theta = rho theta_b(t), the angle v around the axis, and the depth t.
    dealii::Point<dim>
    place_of(const EllipsoidShells &shells,
             const double           rho,
             const double           v,
             const double           t)
    {
      const double theta = rho * shells.base_angle(t);
      const double r     = shells.short_radius(t) * std::sin(theta);
      return dealii::Point<dim>(-shells.long_radius(t) * std::cos(theta),
                   r * std::cos(v),
                   r * std::sin(v));
    }



    // In a chart of (rho cos v, rho sin v, t), which is smooth at the apex.
    class ApexManifold : public dealii::ChartManifold<dim>
    {
    public:
      explicit ApexManifold(const EllipsoidShells &shells)
        : shells(shells)
      {}

      std::unique_ptr<dealii::Manifold<dim>>
      clone() const override
      {
        return std::make_unique<ApexManifold>(shells);
      }

      dealii::Point<dim>
      pull_back(const dealii::Point<dim> &X) const override
      {
        const double r     = std::hypot(X[1], X[2]);
        const auto   place = shells.at(X[0], r);
        const double rho   = place.theta / shells.base_angle(place.depth);
        const double scale = r == 0. ? 0. : rho / r;
        return dealii::Point<dim>(scale * X[1], scale * X[2], place.depth);
      }

      dealii::Point<dim>
      push_forward(const dealii::Point<dim> &c) const override
      {
        return place_of(shells,
                        std::hypot(c[0], c[1]),
                        std::atan2(c[1], c[0]),
                        c[2]);
      }

    private:
      const EllipsoidShells shells;
    };



    // In a chart of (rho, v, t), in which the base is a plane.
    class SideManifold : public dealii::ChartManifold<dim>
    {
    public:
      explicit SideManifold(const EllipsoidShells &shells)
        : dealii::ChartManifold<dim>(
            dealii::Tensor<1, dim>(
              dealii::Point<dim>(0., 2. * dealii::numbers::PI, 0.)))
        , shells(shells)
      {}

      std::unique_ptr<dealii::Manifold<dim>>
      clone() const override
      {
        return std::make_unique<SideManifold>(shells);
      }

      dealii::Point<dim>
      pull_back(const dealii::Point<dim> &X) const override
      {
        const auto place = shells.at(X[0], std::hypot(X[1], X[2]));
        double     v     = std::atan2(X[2], X[1]);
        if (v < 0.)
          v += 2. * dealii::numbers::PI;
        return dealii::Point<dim>(place.theta / shells.base_angle(place.depth),
                     v,
                     place.depth);
      }

      dealii::Point<dim>
      push_forward(const dealii::Point<dim> &c) const override
      {
        return place_of(shells, c[0], c[1], c[2]);
      }

    private:
      const EllipsoidShells shells;
    };
  } // namespace



  /**
   * A wall between two half ellipsoids of revolution about the x axis, cut by a
   * plane, of one tissue: an ideal ventricle of the heart, its apex at x < 0.
   * There a square patch of cells, around which four others go up to the base.
   */
  class TruncatedEllipsoid : public Geometry, public HasEllipsoidShells
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
      return {"base", "endocardium", "epicardium"};
    }

    std::vector<SymmetryPlane>
    symmetry_planes() const override
    {
      return {};
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
      const CoarseMesh mesh = coarse_mesh();
      return mesh_support_points(mesh.vertices, mesh.cells, tissues());
    }

    double
    characteristic_length() const override
    {
      return wall.short_in;
    }

    const EllipsoidShells &
    shells() const override
    {
      return wall;
    }

  private:
    inline static const std::string path = "Geometry/truncated ellipsoid";

    struct CoarseMesh
    {
      std::vector<dealii::Point<dim>>    vertices;
      std::vector<dealii::CellData<dim>> cells;
      unsigned int                       n_apex_cells;
    };

    CoarseMesh
    coarse_mesh() const;

    EllipsoidShells wall;
    unsigned int    n_around  = 4;
    unsigned int    n_up      = 7;
    unsigned int    n_through = 1;
    double          grading   = 1.;
  };



  void
  TruncatedEllipsoid::declare_parameters(dealii::ParameterHandler &prm)
  {
    const auto length = [&](const std::string &name,
                            double            &value,
                            const std::string &what) {
      prm.add_parameter(name, value, "[mm] " + what, PositiveNumber());
    };
    length("Inner short radius",
           wall.short_in,
           "Radius of the inner ellipsoid around the axis.");
    length("Inner long radius",
           wall.long_in,
           "Half of the inner ellipsoid's length along the axis.");
    length("Outer short radius",
           wall.short_out,
           "Radius of the outer ellipsoid around the axis.");
    length("Outer long radius",
           wall.long_out,
           "Half of the outer ellipsoid's length along the axis.");
    prm.add_parameter("Base",
                      wall.base,
                      "[mm] Where the plane x = const is that cuts both "
                      "ellipsoids, which have their centre in x = 0.",
                      dealii::Patterns::Double(-1e100, 1e100));
    prm.add_parameter("Cells around a quarter",
                      n_around,
                      "[number, even] Cells along a quarter of a circle.",
                      dealii::Patterns::Integer(2));
    prm.add_parameter("Cells up to the base",
                      n_up,
                      "[number] Cells from the patch at the apex to the base.",
                      dealii::Patterns::Integer(1));
    prm.add_parameter("Grading",
                      grading,
                      "[-] How many times as short as on average cells are, "
                      "from the apex to the base, where they are at the apex; "
                      "1: they are evenly long.",
                      dealii::Patterns::Double(1., 20.));
    prm.add_parameter("Cells through the wall",
                      n_through,
                      "[number] Cells through the thickness of the wall.",
                      dealii::Patterns::Integer(1));
  }



  void
  TruncatedEllipsoid::check_parameters() const
  {
    RoundSection::check_even(path,
                             "Cells around a quarter",
                             n_around,
                             "one of the vertices is the apex");
    AssertThrow(wall.short_out > wall.short_in,
                ExcParameter("Outer short radius",
                             "is not larger than 'Inner short radius'."));
    AssertThrow(wall.long_out > wall.long_in,
                ExcParameter("Outer long radius",
                             "is not larger than 'Inner long radius'."));
    AssertThrow(std::abs(wall.base) < 0.95 * wall.long_in,
                ExcParameter("Base",
                             "is a plane that does not cut the inner ellipsoid, "
                             "or does so at its very end. It has to be between "
                             "-0.95 and 0.95 times 'Inner long radius'."));
    check_n_coarse_cells(path,
                         1. * n_around * (n_around + 4. * n_up) * n_through);
  }



  TruncatedEllipsoid::CoarseMesh
  TruncatedEllipsoid::coarse_mesh() const
  {
    const double       quarter = dealii::numbers::PI / 2.;
    const unsigned int n       = n_around;
    // Half a side of the square, in rho.
    const double half = 0.5 * n / (0.5 * n + n_up) * 0.9;
    CoarseMesh   mesh;

    // rho of vertices that would be at s, evenly, in [0, 1].
    const auto graded = [&](const double s) {
      return s * (1. + (grading - 1.) * s) / grading;
    };
    const auto add_patch = [&](const unsigned int n_i,
                               const unsigned int n_j,
                               const auto        &place) {
      const unsigned int first = mesh.vertices.size();
      for (unsigned int k = 0; k <= n_through; ++k)
        for (unsigned int j = 0; j <= n_j; ++j)
          for (unsigned int i = 0; i <= n_i; ++i)
            mesh.vertices.push_back(place(i, j, 1. * k / n_through));
      const auto number = [&](const unsigned int i,
                              const unsigned int j,
                              const unsigned int k) {
        return first + (k * (n_j + 1) + j) * (n_i + 1) + i;
      };
      for (unsigned int k = 0; k < n_through; ++k)
        for (unsigned int j = 0; j < n_j; ++j)
          for (unsigned int i = 0; i < n_i; ++i)
            {
              dealii::CellData<dim> cell;
              // j before i: right-handed with the depth.
              for (unsigned int c = 0; c < cell.vertices.size(); ++c)
                cell.vertices[c] =
                  number(i + c / 2 % 2, j + c % 2, k + c / 4);
              cell.material_id = Region{0, 0}.material_id();
              mesh.cells.push_back(cell);
            }
    };

    const auto angle = [&](const unsigned int i) {
      return quarter * (1. * i / n - 0.5);
    };
    // At the apex, a square whose lines have equal angles.
    const auto at_apex =
      [&](const unsigned int i, const unsigned int j, const double t) {
        const double a = half * std::tan(angle(i));
        const double b = half * std::tan(angle(j));
        return place_of(wall, graded(std::hypot(a, b)), std::atan2(b, a), t);
      };
    add_patch(n, n, at_apex);
    mesh.n_apex_cells = mesh.cells.size();
    for (unsigned int side = 0; side < 4; ++side)
      {
        const auto at_side =
          [&](const unsigned int i, const unsigned int j, const double t) {
            const double inner = half / std::cos(angle(j));
            return place_of(wall,
                            graded(inner + (1. - inner) * i / n_up),
                            angle(j) + side * quarter,
                            t);
          };
        add_patch(n_up, n, at_side);
      }
    dealii::SubCellData       none;
    std::vector<unsigned int> all;
    dealii::GridTools::delete_duplicated_vertices(
      mesh.vertices, mesh.cells, none, all, 1e-8 * wall.short_in);
    return mesh;
  }



  void
  TruncatedEllipsoid::create_coarse_mesh(
    dealii::Triangulation<dim> &triangulation) const
  {
    const CoarseMesh mesh = coarse_mesh();
    triangulation.create_triangulation(mesh.vertices, mesh.cells, {});

    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            // All vertices are at the base, or all are of one depth.
            bool   at_base = true;
            double depth   = 0.;
            for (unsigned int v = 0; v < face->n_vertices(); ++v)
              {
                const dealii::Point<dim> &X = face->vertex(v);
                at_base        = at_base && std::abs(X[0] - wall.base) <
                                       1e-8 * wall.short_in;
                depth += wall.at(X[0], std::hypot(X[1], X[2])).depth /
                         face->n_vertices();
              }
            face->set_boundary_id(at_base ? 0 : depth < 0.5 ? 1 : 2);
          }

    constexpr dealii::types::manifold_id apex = 1, side = 2;
    triangulation.set_all_manifold_ids(side);
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (static_cast<unsigned int>(cell->index()) < mesh.n_apex_cells)
        cell->set_all_manifold_ids(apex);
    triangulation.set_manifold(apex, ApexManifold(wall));
    triangulation.set_manifold(side, SideManifold(wall));
  }



  static const Register<Geometry, TruncatedEllipsoid>
    truncated_ellipsoid("truncated ellipsoid",
                        "a wall between two ellipsoids that a plane cuts, an "
                        "ideal ventricle of the heart.");
} // namespace lumbricus
