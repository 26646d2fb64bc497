// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace
{
  using dealii::Point;
  using lumbricus::dim;

  /** A bar of square section around the x axis that gets thinner along it, as
   * an arm of an octopus does: one segment of one tissue, 'flesh'. The planes
   * y = 0 and z = 0 cut it into four parts that are alike, of which one is
   * enough. */
  class TaperedBar : public lumbricus::Geometry
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Length",
                        length,
                        "[mm] Along the axis.",
                        lumbricus::PositiveNumber());
      prm.add_parameter("Width at the head",
                        head_width,
                        "[mm] Edge of the section at x = 0.",
                        lumbricus::PositiveNumber());
      prm.add_parameter("Width at the tail",
                        tail_width,
                        "[mm] Edge of the section at the other end.",
                        lumbricus::PositiveNumber());
      prm.add_parameter("Quarter",
                        quarter,
                        "Whether to compute the part y > 0, z > 0 only.");
    }

    void
    create_coarse_mesh(dealii::Triangulation<dim> &triangulation) const override
    {
      const double       half   = head_width / 2.;
      const double       inside = quarter ? 0. : -half;
      const unsigned int n      = quarter ? 1 : 2;
      const Point<dim>   low(0., inside, inside), high(length, half, half);
      dealii::GridGenerator::subdivided_hyper_rectangle(triangulation,
                                                        {8, n, n},
                                                        low,
                                                        high);
      // Names by which loads find the boundaries: head, tail, skin; then the
      // planes of symmetry. The faces of a cell are those at the lower and the
      // higher end of x, y, z.
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          cell->set_material_id(lumbricus::Region{0, 0}.material_id());
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              cell->face(f)->set_boundary_id(f < 2             ? f :
                                             quarter && f == 2 ? 3 :
                                             quarter && f == 4 ? 4 :
                                                                 2);
        }
      dealii::GridTools::transform(
        [&](const Point<dim> &X) {
          const double width =
            1. + (tail_width / head_width - 1.) * X[0] / length;
          return Point<dim>(X[0], width * X[1], width * X[2]);
        },
        triangulation);
    }

    unsigned int
    n_segments() const override
    {
      return 1;
    }

    std::vector<lumbricus::TissueName>
    tissues() const override
    {
      return {{"flesh", false, true}};
    }

    std::vector<std::string>
    boundary_names() const override
    {
      return {"head", "tail", "skin"};
    }

    std::vector<lumbricus::SymmetryPlane>
    symmetry_planes() const override
    {
      if (!quarter)
        return {};
      return {{3, 1}, {4, 2}};
    }

    std::vector<lumbricus::SegmentSections>
    sections() const override
    {
      return {{0., length / 2., length}};
    }

    std::array<Point<dim>, 3>
    support_points() const override
    {
      // The planes of symmetry hold what the third is for.
      const double z = quarter ? 0. : head_width / 2.;
      return {
        {Point<dim>(), Point<dim>(length, 0., 0.), Point<dim>(0., 0., z)}};
    }

    double
    characteristic_length() const override
    {
      return head_width;
    }

  private:
    double length     = 10.;
    double head_width = 2.;
    double tail_width = 1.;
    bool   quarter    = false;
  };

  const lumbricus::Register<lumbricus::Geometry, TaperedBar>
    tapered_bar("tapered bar", "a bar that gets thinner towards the tail.");
} // namespace
