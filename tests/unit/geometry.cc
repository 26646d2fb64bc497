// SPDX-License-Identifier: LGPL-2.1-or-later
// The geometries: volumes, areas, ids, curved surfaces and error messages.
#include <lumbricus/geometry/geometry.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "read_plugin.h"

using namespace lumbricus;
using namespace dealii;

namespace
{
  const double pi = numbers::PI;

  // What a mesh adds up to.
  struct Totals
  {
    /** By (segment, name of the tissue). */
    std::map<std::pair<unsigned int, std::string>, double> volumes;
    /** By boundary id. */
    std::map<types::boundary_id, double> areas;
    double                               smallest_jacobian = 1e300;

    double
    volume(const std::string &tissue) const
    {
      double sum = 0.;
      for (const auto &entry : volumes)
        if (entry.first.second == tissue)
          sum += entry.second;
      return sum;
    }
  };



  Totals
  totals(const Geometry &geometry, const Triangulation<3> &mesh)
  {
    const MappingQ<3>   mapping(2);
    const FE_Nothing<3> fe;
    // With points in the corners, where a Jacobian is smallest.
    const QGaussLobatto<1> rule(4);
    FEValues<3>            cells(mapping, fe, QGauss<3>(4), update_JxW_values);
    FEValues<3>     corners(mapping, fe, Quadrature<3>(rule), update_jacobians);
    FEFaceValues<3> faces(mapping, fe, QGauss<2>(4), update_JxW_values);

    const MPI_Comm comm    = mesh.get_communicator();
    const auto     tissues = geometry.tissues();
    Totals         result;
    // The same keys on all ranks.
    for (unsigned int s = 0; s < geometry.n_segments(); ++s)
      for (const auto &tissue : tissues)
        result.volumes[{s, tissue.name}] = 0.;
    const unsigned int n_boundaries =
      geometry.boundary_names().size() + geometry.symmetry_planes().size();
    for (types::boundary_id id = 0; id < n_boundaries; ++id)
      result.areas[id] = 0.;

    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Region region = Region::of(cell->material_id());
          AssertThrow(region.segment < geometry.n_segments() &&
                        region.tissue < tissues.size(),
                      ExcInternalError());
          cells.reinit(cell);
          for (const double JxW : cells.get_JxW_values())
            result.volumes[{region.segment, tissues[region.tissue].name}] +=
              JxW;
          corners.reinit(cell);
          for (const auto &jacobian : corners.get_jacobians())
            result.smallest_jacobian =
              std::min(result.smallest_jacobian,
                       determinant(Tensor<2, 3>(jacobian)) / cell->measure());
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              {
                AssertThrow(cell->face(f)->boundary_id() < n_boundaries,
                            ExcInternalError());
                faces.reinit(cell, f);
                for (const double JxW : faces.get_JxW_values())
                  result.areas[cell->face(f)->boundary_id()] += JxW;
              }
        }
    for (auto &volume : result.volumes)
      volume.second = Utilities::MPI::sum(volume.second, comm);
    for (auto &area : result.areas)
      area.second = Utilities::MPI::sum(area.second, comm);
    result.smallest_jacobian =
      Utilities::MPI::min(result.smallest_jacobian, comm);
    return result;
  }



  void
  make_mesh(const Geometry    &geometry,
            const unsigned int n_refinements,
            Triangulation<3>  &mesh)
  {
    geometry.create_coarse_mesh(mesh);
    mesh.refine_global(n_refinements);
  }



  Totals
  totals(const Geometry &geometry, const unsigned int n_refinements)
  {
    Triangulation<3> mesh;
    make_mesh(geometry, n_refinements, mesh);
    return totals(geometry, mesh);
  }



  std::unique_ptr<Geometry>
  chain(const std::string &text)
  {
    return read_plugin<Geometry>("segment chain", text);
  }



  // Two segments of radius 1.3.
  const std::string two_segments = "set Number of segments = 2\n"
                                   "set Radius = 1.3\n"
                                   "set Segment length = 1.6\n"
                                   "set Wall layer thicknesses = 0.2, 0.3\n"
                                   "set Septum thickness = 0.25\n"
                                   "set Cap thickness = 0.4\n";

  const std::string quarter = "set Cross-section = quarter\n";
  const std::string half    = "set Cross-section = half\n";

  // Four segments, of which the first and the last two are their own.
  const std::string uneven = "set Number of segments = 4\n"
                             "set Radius = 2\n"
                             "set Segments with their own measures = 1, 3 - 4\n"
                             "subsection Segment 1\n"
                             "  set Radius = 1.23456789\n"
                             "  set Septum thickness = 0.5\n"
                             "end\n"
                             "subsection Segments 3-4\n"
                             "  set Segment length = 3\n"
                             "  set Wall layer thicknesses = 0.2, 0.3\n"
                             "end\n";

  // The outer radius of this chain: linear between the points given.
  double
  uneven_outer_radius(const double x)
  {
    const double                                 R1      = 1.23456789 + 0.3;
    const std::vector<std::pair<double, double>> corners = {
      {0., R1}, {2.3, R1}, {2.8, 2.3}, {4.8, 2.3}, {4.9, 2.5}, {11.3, 2.5}};
    for (unsigned int i = 1; i < corners.size(); ++i)
      if (x <= corners[i].first + 1e-12)
        {
          const auto  &a = corners[i - 1], &b = corners[i];
          const double f = (x - a.first) / (b.first - a.first);
          return (1 - f) * a.second + f * b.second;
        }
    ADD_FAILURE() << "x = " << x << " is outside the chain";
    return 0.;
  }



  // Area of the mesh faces in the plane; inner ones are met from both sides.
  double
  area_in_plane(const Triangulation<3> &mesh, const double x)
  {
    const MappingQ<3>   mapping(2);
    const FE_Nothing<3> fe;
    FEFaceValues<3>     values(mapping, fe, QGauss<2>(3), update_JxW_values);
    double              area = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          bool in_plane = true;
          for (unsigned int v = 0; v < 4; ++v)
            in_plane &= std::abs(cell->face(f)->vertex(v)[0] - x) < 1e-12;
          if (in_plane)
            {
              values.reinit(cell, f);
              for (const double JxW : values.get_JxW_values())
                area += cell->at_boundary(f) ? JxW : JxW / 2;
            }
        }
    return area;
  }



  // The support rule (A: x, y, z; B: y, z; C: y; not in the direction of a
  // symmetry plane, not twice) against the rigid motions that the symmetry
  // planes leave: as many constraints as motions, and they are independent.
  void
  expect_statically_determinate(const Geometry &geometry)
  {
    const auto             points = geometry.support_points();
    std::set<unsigned int> mirrored;
    for (const auto &plane : geometry.symmetry_planes())
      mirrored.insert(plane.direction);

    // u = t + w x X; a plane with normal e_d leaves t in it and w along e_d.
    std::vector<unsigned int> free;
    for (unsigned int d = 0; d < 3; ++d)
      if (mirrored.count(d) == 0)
        free.push_back(d);
    for (unsigned int d = 0; d < 3; ++d)
      if (mirrored.empty() || (mirrored.size() == 1 && mirrored.count(d) > 0))
        free.push_back(3 + d);

    const std::vector<std::pair<unsigned int, unsigned int>> candidates = {
      {0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 1}};
    std::vector<std::pair<Point<3>, unsigned int>> constraints;
    for (const auto &candidate : candidates)
      {
        const auto constraint =
          std::make_pair(points[candidate.first], candidate.second);
        if (mirrored.count(candidate.second) == 0 &&
            std::find(constraints.begin(), constraints.end(), constraint) ==
              constraints.end())
          constraints.push_back(constraint);
      }
    ASSERT_EQ(constraints.size(), free.size());

    FullMatrix<double> matrix(free.size(), free.size());
    for (unsigned int i = 0; i < free.size(); ++i)
      for (unsigned int j = 0; j < free.size(); ++j)
        {
          Tensor<1, 3> e;
          e[free[j] % 3] = 1.;
          const Tensor<1, 3> u =
            free[j] < 3 ? e : cross_product_3d(e, constraints[i].first);
          matrix(i, j) = u[constraints[i].second];
        }
    if (!free.empty())
      {
        EXPECT_GT(std::abs(matrix.determinant()), 1e-3);
      }
  }



  // A file with @p text, as long as this lives; one for each rank.
  class TextFile
  {
  public:
    explicit TextFile(const std::string &text)
      : name("measures." +
             std::to_string(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
             ".csv")
    {
      std::ofstream(name) << text;
    }

    ~TextFile()
    {
      std::remove(name.c_str());
    }

    const std::string name;
  };



  // The volume of a frustum with radii a and b, a quarter of it.
  double
  quarter_cone(const double a, const double b, const double h)
  {
    return pi * h * (a * a + a * b + b * b) / 3 / 4;
  }



  void
  expect_support_points_are_vertices(const Geometry         &geometry,
                                     const Triangulation<3> &mesh)
  {
    for (const auto &point : geometry.support_points())
      {
        double distance = 1e300;
        for (const auto &vertex : mesh.get_vertices())
          distance = std::min(distance, vertex.distance(point));
        EXPECT_LT(distance, 1e-12) << point;
      }
  }
} // namespace



TEST(SegmentChain, VolumesConvergeToTheClosedFormsUnderRefinement)
{
  const auto geometry = chain(two_segments + quarter);

  const auto ring = [](const double inside, const double outside) {
    return pi * (outside * outside - inside * inside) / 4;
  };
  const double                        length = 2 * 1.6 + 0.25;
  const std::map<std::string, double> exact  = {
     {"liquid", 2 * 1.6 * ring(0, 1.3)},
     {"longitudinal muscle", length * ring(1.3, 1.5)},
     {"circular muscle", length * ring(1.5, 1.8)},
     {"septum", 0.25 * ring(0, 1.3)},
     {"cap", 2 * 0.4 * ring(0, 1.8)}};

  std::map<std::string, double> last_error;
  for (unsigned int refinement = 0; refinement <= 2; ++refinement)
    {
      const Totals sum = totals(*geometry, refinement);
      EXPECT_GT(sum.smallest_jacobian, 0.1);
      for (const auto &entry : exact)
        {
          const double error =
            std::abs(sum.volume(entry.first) / entry.second - 1);
          // Fourth order: a factor of 16.
          if (refinement > 0)
            {
              EXPECT_LT(error, last_error[entry.first] / 12) << entry.first;
            }
          last_error[entry.first] = error;
        }
    }
  for (const auto &entry : last_error)
    EXPECT_LT(entry.second, 1e-6) << entry.first;
}



TEST(SegmentChain, ConesHaveTheirVolumes)
{
  const Totals sum = totals(*chain(uneven + quarter), 1);

  const auto  &cone = quarter_cone;
  const double R1   = 1.23456789, mean = (R1 + 2) / 2;
  const auto   expect_volume =
    [&](const unsigned int s, const std::string &tissue, const double exact) {
      EXPECT_NEAR((sum.volumes.at({s - 1, tissue}) / exact), 1., 2e-5)
        << tissue << " of segment " << s;
    };
  expect_volume(1, "liquid", cone(R1, R1, 2));
  expect_volume(2, "liquid", cone(2, 2, 2));
  expect_volume(4, "liquid", cone(2, 2, 3));
  expect_volume(1, "septum", cone(R1, mean, 0.25));
  expect_volume(2, "septum", cone(mean, 2, 0.25) + cone(2, 2, 0.05));
  expect_volume(3, "septum", cone(2, 2, 0.1));
  expect_volume(1, "cap", cone(R1 + 0.3, R1 + 0.3, 0.3));
  expect_volume(4, "cap", cone(2.5, 2.5, 0.3));
  EXPECT_EQ(sum.volumes.at({1, "cap"}), 0.);
}



TEST(SegmentChain, MeasuresAreFormulasInTheSegment)
{
  const Totals sum = totals(
    *chain(quarter + "set Number of segments = 3\n"
                     "set Radius = 1 + s/n\n"
                     "set Segment length = 6/n\n"
                     "set Wall layer thicknesses = 0.1*s, max(0.2, s/10)\n"
                     "set Septum thickness = if(s < 2, 0.3, 0.1)\n"),
    1);
  for (unsigned int s = 1; s <= 3; ++s)
    {
      const double R = 1 + s / 3.;
      EXPECT_NEAR((sum.volumes.at({s - 1, "liquid"}) / quarter_cone(R, R, 2)),
                  1.,
                  2e-5);
    }
  EXPECT_NEAR((sum.volumes.at({0, "septum"}) /
               quarter_cone(4 / 3., 1.5, 0.15)),
              1.,
              2e-5);
  // That of the last segment: 0.3 thick inside and 0.3 outside.
  EXPECT_NEAR((sum.volumes.at({2, "cap"}) / quarter_cone(2.6, 2.6, 0.3)),
              1.,
              2e-5);
}



TEST(SegmentChain, MeasuresAreReadFromATable)
{
  const auto radius = [](const std::string &table,
                         const unsigned int n,
                         const std::string &more = "") {
    const TextFile file(table);
    const Totals   sum =
      totals(*chain(quarter + "set Number of segments = " + std::to_string(n) +
                    "\nset Segment length = 2\nset Table of measures = " +
                    file.name + "\n" + more),
             1);
    std::vector<double> radii;
    for (unsigned int s = 0; s < n; ++s)
      radii.push_back(
        std::sqrt(sum.volumes.at({s, "liquid"}) * 4 / pi / 2.));
    return radii;
  };
  const auto expect = [](const std::vector<double> &got,
                         const std::vector<double> &wanted) {
    ASSERT_EQ(got.size(), wanted.size());
    for (unsigned int s = 0; s < got.size(); ++s)
      EXPECT_NEAR(got[s], wanted[s], 2e-5 * wanted[s]);
  };
  // Linear between rows, the same shape for any number of segments.
  const std::string by_place = "# a shape\nplace, Radius, circular muscle\n"
                               "0, 1, 0.1\n\n0.5, 3, 0.2 # the middle\n1, 2, 0.1\n";
  expect(radius(by_place, 2), {2., 2.5});
  expect(radius(by_place, 4), {1.5, 2.5, 2.75, 2.25});
  expect(radius("s, Radius\n1, 1\n3, 2\n", 3), {1., 1.5, 2.});
  // Where a range of segments has a formula of its own, that.
  expect(radius(by_place,
                4,
                "set Segments with their own measures = 2\n"
                "subsection Segment 2\nset Radius = s\nend\n"),
         {1.5, 2., 2.75, 2.25});

  const auto message = [&](const std::string &table, const std::string &more) {
    return input_error([&]() { radius(table, 3, more); });
  };
  for (const auto &[table, part] :
       std::vector<std::pair<std::string, std::string>>{
         {"place, Radios\n0, 1\n1, 1\n", "'Radios' is no measure"},
         {"x, Radius\n0, 1\n1, 1\n", "not 'x'"},
         {"place, Radius, Radius\n0, 1, 1\n", "there twice"},
         {"place, Radius\n0, 1\n1\n", "line 3: it has 1 numbers for 2"},
         {"place, Radius\n0, one\n1, 1\n", "line 2, column 'Radius': 'one' is no number"},
         {"place, Radius\n0, nan\n1, 1\n", "'nan' is no number"},
         {"place, Radius\n1, 1\n0, 1\n", "line 3, column 'place': 0 is not greater"},
         {"place, Radius\n", "has no rows"},
         {"", "has no rows"},
         {"s, Radius\n1, 1\n2, 1\n", "segment 3 of 3 is at 3"},
         {"place, Radius\n0, 1\n1, -1\n", "'Radius' is 0 mm for segment 2"}})
    {
      const std::string got = message(table, "");
      EXPECT_TRUE(contains(got, "'Geometry/segment chain/Table of measures'") && contains(got, part))
        << table << got;
    }
  EXPECT_TRUE(contains(input_error([]() {
                         chain("set Table of measures = nowhere.csv");
                       }),
                       "'nowhere.csv' cannot be read"));
}



TEST(SegmentChain, ChambersAreConesWhereTheTaperGoesAlongThem)
{
  // Radii 1, 2, 4: the walls are at 1, 1.5 and 1.5, 2, 3 and 3, 4.
  const std::string text =
    quarter + "set Number of segments = 3\nset Radius = 2^(s - 1)\n"
              "set Segment length = 2\nset Wall layer thicknesses = 0.2, 0.3\n"
              "set Septum thickness = 0.1\nset Cap thickness = 0.4\n"
              "set Taper = along chambers\nset Tip of the caps = 0.5\n";
  const auto &cone = quarter_cone;
  for (const std::string septum : {"", "set Cells through half a septum = 0"})
    {
      const auto   body = chain(text + septum);
      const Totals sum  = totals(*body, 1);
      const auto   near = [&](const unsigned int s,
                            const std::string &tissue,
                            const double       exact) {
        EXPECT_NEAR((sum.volumes.at({s - 1, tissue}) / exact), 1., 2e-5)
          << tissue << " of segment " << s << septum;
      };
      near(1, "liquid", cone(1, 1, 1) + cone(1, 1.5, 1));
      near(2, "liquid", cone(1.5, 2, 1) + cone(2, 3, 1));
      near(3, "liquid", cone(3, 4, 1) + cone(4, 4, 1));
      // Halves belong to both, one cell to the segment in front.
      const double thickness = septum.empty() ? 0.05 : 0.1;
      near(1, "septum", cone(1.5, 1.5, thickness));
      near(1, "cap", cone(0.75, 1.5, 0.4));
      near(3, "cap", cone(4.5, 2.25, 0.4));
      if (septum.empty())
        near(3, "septum", cone(3, 3, 0.05));
      else
        EXPECT_EQ(sum.volumes.at({2, "septum"}), 0.);

      const auto sections = body->sections();
      EXPECT_NEAR(sections[0].begin, 0.4, 1e-14);
      EXPECT_NEAR(sections[0].middle, 1.4, 1e-14);
      EXPECT_NEAR(sections[0].end, 2.4 + thickness, 1e-14);
      EXPECT_EQ(sections[1].begin, sections[0].end);
      EXPECT_NEAR(sections[1].middle, 3.5, 1e-14);
      EXPECT_NEAR(sections[2].end, 6.6, 1e-14);

      Triangulation<3> mesh;
      make_mesh(*body, 0, mesh);
      expect_support_points_are_vertices(*body, mesh);
    }
}



TEST(SegmentChain, FullIsTwoHalvesAndFourQuarters)
{
  for (const std::string cells :
       {"set Cells around a quarter = 4\n", "set Cells around a quarter = 6\n"})
    {
      const auto   full    = chain(two_segments + cells);
      const Totals of_full = totals(*full, 0);
      const Totals of_half = totals(*chain(two_segments + cells + half), 0);
      const Totals of_quarter =
        totals(*chain(two_segments + cells + quarter), 0);
      EXPECT_GT(of_full.smallest_jacobian, 0.1);
      for (const auto &entry : of_full.volumes)
        {
          EXPECT_NEAR(2 * of_half.volumes.at(entry.first) / entry.second,
                      1.,
                      1e-12);
          EXPECT_NEAR(4 * of_quarter.volumes.at(entry.first) / entry.second,
                      1.,
                      1e-12);
        }
      for (types::boundary_id id = 0; id < full->boundary_names().size(); ++id)
        {
          EXPECT_NEAR(2 * of_half.areas.at(id) / of_full.areas.at(id),
                      1.,
                      1e-12);
          EXPECT_NEAR(4 * of_quarter.areas.at(id) / of_full.areas.at(id),
                      1.,
                      1e-12);
        }
    }
}



TEST(SegmentChain, QuarterVerticesAreVerticesOfTheFullMesh)
{
  Triangulation<3> full, part;
  make_mesh(*chain(two_segments), 0, full);
  make_mesh(*chain(two_segments + quarter), 0, part);
  unsigned int n_in_quarter = 0;
  for (const auto &vertex : full.get_vertices())
    n_in_quarter += vertex[1] > -1e-12 && vertex[2] > -1e-12;
  EXPECT_EQ(n_in_quarter, part.n_vertices());
  for (const auto &vertex : part.get_vertices())
    {
      double distance = 1e300;
      for (const auto &other : full.get_vertices())
        distance = std::min(distance, vertex.distance(other));
      ASSERT_LT(distance, 1e-14) << vertex;
    }
}



TEST(SegmentChain, LinesAreConsistentAndInterfacesInStandardOrientation)
{
  for (const std::string part : {"full", "half", "quarter"})
    {
      Triangulation<3> mesh;
      make_mesh(*chain(two_segments + "set Cross-section = " + part), 0, mesh);
      unsigned int n_interfaces = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          EXPECT_GT(cell->measure(), 0.);
          for (const unsigned int l : cell->line_indices())
            ASSERT_TRUE(cell->line_orientation(l));
          for (const unsigned int f : cell->face_indices())
            if (!cell->at_boundary(f) &&
                cell->material_id() != cell->neighbor(f)->material_id())
              {
                ++n_interfaces;
                ASSERT_TRUE(cell->face_orientation(f));
                ASSERT_FALSE(cell->face_flip(f) || cell->face_rotation(f));
              }
        }
      EXPECT_GT(n_interfaces, 0u);
    }
}



TEST(SegmentChain, SkinStaysOnItsConesUnderRefinementAndMapping)
{
  for (const std::string &part : {quarter, half})
    {
      const auto       geometry = chain(uneven + part);
      Triangulation<3> mesh;
      make_mesh(*geometry, part == quarter ? 2 : 1, mesh);

      // The support points of the mapping are among these.
      const MappingQ<3>   mapping(2);
      const FE_Nothing<3> fe;
      FEFaceValues<3>     values(mapping,
                             fe,
                             QGaussLobatto<2>(3),
                             update_quadrature_points);
      unsigned int        n_faces = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && cell->face(f)->boundary_id() == 2)
            {
              ++n_faces;
              values.reinit(cell, f);
              for (const auto &x : values.get_quadrature_points())
                ASSERT_NEAR(std::hypot(x[1], x[2]),
                            uneven_outer_radius(x[0]),
                            1e-12)
                  << x;
            }
      EXPECT_GT(n_faces, 100u);
    }
}



TEST(SegmentChain, RegionsAreWhereTheyBelong)
{
  const auto geometry = chain(two_segments + "set Cells around a quarter = 6");
  const auto tissues  = geometry->tissues();
  const auto sections = geometry->sections();
  Triangulation<3> mesh;
  make_mesh(*geometry, 1, mesh);
  for (const auto &cell : mesh.active_cell_iterators())
    {
      const Region      region = Region::of(cell->material_id());
      const std::string tissue = tissues[region.tissue].name;
      const auto        center = cell->center();
      const double      x = center[0], r = std::hypot(center[1], center[2]);
      if (tissue != "cap")
        {
          ASSERT_GT(x, sections[region.segment].begin);
          ASSERT_LT(x, sections[region.segment].end);
        }
      const bool in_liquid = (x > 0.4 && x < 2.) || (x > 2.25 && x < 3.85);
      const std::string expected = x < 0.4 || x > 3.85 ? "cap" :
                                   r > 1.495           ? "circular muscle" :
                                   r > 1.295           ? "longitudinal muscle" :
                                   in_liquid           ? "liquid" :
                                                         "septum";
      ASSERT_EQ(tissue, expected) << center;
    }
  EXPECT_TRUE(tissues[0].liquid);
  EXPECT_FALSE(tissues[1].liquid);
  for (const auto &tissue : chain("set Number of segments = 1")->tissues())
    EXPECT_NE(tissue.name, "septum");
  // A chain of one has the cap where the septum would have been.
  const auto one = chain("set Number of segments = 1");
  EXPECT_NEAR(totals(*one, 0).volume("cap"), 2 * 0.3 * 2.3 * 2.3 * pi, 1e-2);
}



TEST(SegmentChain, BoundariesAreWhereTheirNamesSay)
{
  const auto   geometry = chain(two_segments + quarter);
  const Totals sum      = totals(*geometry, 1);
  const double length   = 2 * 0.4 + 2 * 1.6 + 0.25;
  EXPECT_EQ(geometry->boundary_names(),
            (std::vector<std::string>{"head", "tail", "skin"}));
  EXPECT_EQ(geometry->symmetry_factor(), 4u);
  EXPECT_NEAR(sum.areas.at(0), pi * 1.8 * 1.8 / 4, 1e-4);
  EXPECT_NEAR(sum.areas.at(1), pi * 1.8 * 1.8 / 4, 1e-4);
  EXPECT_NEAR(sum.areas.at(2), pi * 1.8 / 2 * length, 1e-3);
  EXPECT_NEAR(sum.areas.at(3), 1.8 * length, 1e-10);
  EXPECT_NEAR(sum.areas.at(4), 1.8 * length, 1e-10);

  Triangulation<3> mesh;
  make_mesh(*geometry, 1, mesh);
  const auto planes = geometry->symmetry_planes();
  ASSERT_EQ(planes.size(), 2u);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
        {
          const auto         face = cell->face(f);
          const unsigned int id   = face->boundary_id();
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Point<3> x = face->vertex(v);
              if (id == 0)
                {
                  EXPECT_EQ(x[0], 0.);
                }
              if (id == 1)
                {
                  EXPECT_NEAR(x[0], length, 1e-12);
                }
              for (const auto &plane : planes)
                if (id == plane.boundary)
                  {
                    ASSERT_NEAR(x[plane.direction], 0., 1e-14);
                  }
            }
        }
  EXPECT_EQ(chain(half)->symmetry_factor(), 2u);
  EXPECT_EQ(chain("")->symmetry_factor(), 1u);
}



TEST(SegmentChain, SectionsHaveMeshFacesInThem)
{
  const auto       geometry = chain(uneven + quarter);
  Triangulation<3> mesh;
  make_mesh(*geometry, 1, mesh);
  const auto sections = geometry->sections();
  ASSERT_EQ(sections.size(), 4u);
  for (unsigned int s = 0; s < 4; ++s)
    for (const double x :
         {sections[s].begin, sections[s].middle, sections[s].end})
      {
        const double R = uneven_outer_radius(x);
        EXPECT_NEAR(area_in_plane(mesh, x) / (pi * R * R / 4), 1., 1e-4)
          << "segment " << s + 1 << ", x = " << x;
      }
  EXPECT_EQ(sections[0].begin, 0.3);
  EXPECT_NEAR(sections[0].middle, 1.3, 1e-14);
  EXPECT_NEAR(sections[0].end, 2.55, 1e-14);
  EXPECT_EQ(sections[0].end, sections[1].begin);
  EXPECT_NEAR(sections[3].end, 11., 1e-12);
  EXPECT_NEAR(geometry->characteristic_length(), 2., 1e-14);
}



TEST(SegmentChain, DistributedMeshHasTheSameTotals)
{
  const auto   geometry = chain(two_segments + half);
  const Totals serial   = totals(*geometry, 1);

  parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  make_mesh(*geometry, 1, mesh);
  const Totals distributed = totals(*geometry, mesh);
  for (const auto &entry : serial.volumes)
    EXPECT_NEAR(distributed.volumes.at(entry.first), entry.second, 1e-11);
  for (const auto &entry : serial.areas)
    EXPECT_NEAR(distributed.areas.at(entry.first), entry.second, 1e-11);
  EXPECT_NEAR(distributed.smallest_jacobian, serial.smallest_jacobian, 1e-10);
}



TEST(SegmentChain, WrongParametersAreErrorsThatNameThem)
{
  const auto message = [](const std::string &text) {
    return input_error([&]() { chain(text); });
  };
  const auto expect = [&](const std::string &text,
                          const std::string &part,
                          const std::string &other_part) {
    const std::string got = message(text);
    EXPECT_TRUE(contains(got, part) && contains(got, other_part)) << got;
  };
  const std::string ten  = "set Number of segments = 10\n";
  const std::string name = "set Segments with their own measures = ";
  expect(ten + name + "8-10, 9", "two rules for segment 9", "'Segments 8-10'");
  expect(ten + name + "8-10, 9", "'Segment 9'", "their own measures'");
  expect(ten + name + "1, 1", "two rules for segment 1", "'Segment 1'");
  expect(ten + name + "8-11", "'Segments 8-11'", "10 (tail)");
  expect(ten + name + "0", "'Segment 0'", "1 (head)");
  expect(ten + name + "5-3", "'Segments 5-3'", "their own measures'");
  expect(ten + name + "1, two", "'two'", "their own measures'");
  expect(ten + name + "1-2-3", "'1-2-3'", "their own measures'");
  expect("set Cells along a segment = 3", "Cells along a segment", "even");
  EXPECT_EQ(message("set Cells along a segment = 3\nset Liquid = cavity"), "");
  expect("set Radius = 2 - s", "'Geometry/segment chain/Radius'", "is 0 mm for segment 2");
  expect("set Radius = 1/0", "Radius'", "segment 1");
  expect("set Radius = 2 + x", "Radius'", "Use s and n");
  expect("set Segment length = 1 + t", "Segment length'", "Use s and n");
  expect("set Septum thickness = max(s", "Septum thickness", "cannot be read");
  expect("set Wall layer thicknesses = 0.1, max(0.1",
         "Wall layer thicknesses",
         "cannot be read");
  expect("set Wall layer thicknesses = 0.1, 0.1, 0.1",
         "Wall layer thicknesses",
         "3 entries");
  expect("set Wall layer thicknesses = 0.1, 0.1 - s/10",
         "Wall layer thicknesses",
         "is 0 mm for segment 1");
  expect("set Segments with their own measures = 2\n"
         "subsection Segment 2\nset Radius = s - n\nend",
         "Segment 2/Radius",
         "is -1 mm for segment 2");
  expect("set Cells around a quarter = 3", "Cells around a quarter", "even");
  expect("set Wall layers = a, a",
         "'Geometry/segment chain/Wall layers'",
         "'a'");
  expect("set Wall layers = a, cap", "Wall layers", "'cap'");
  expect("set Wall layers = a", "Wall layer thicknesses", "Wall layers");
  expect(ten + name +
           "2\nsubsection Segment 2\nset Wall layer thicknesses = 1\nend",
         "'Geometry/segment chain/Segment 2/Wall layer thicknesses'",
         "1 entries");
}



TEST(OpenCylinder, VolumesAndAreas)
{
  const std::string text = "set Radius = 2\nset Length = 5\n"
                           "set Wall layers = membrane\n"
                           "set Wall layer thicknesses = 0.5\n";
  for (const std::string part : {"full", "half", "quarter"})
    {
      const std::string cut = "set Cross-section = " + part + "\n";
      {
        const auto geometry =
          read_plugin<Geometry>("open cylinder", text + cut);
        const double     whole = geometry->symmetry_factor();
        Triangulation<3> mesh;
        make_mesh(*geometry, 1, mesh);
        const Totals sum = totals(*geometry, mesh);
        EXPECT_GT(sum.smallest_jacobian, 0.1);
        EXPECT_NEAR(whole * sum.volume("liquid") / (pi * 4 * 5), 1., 2e-5);
        EXPECT_NEAR(whole * sum.volume("membrane") / (pi * 2.25 * 5), 1., 2e-5);
        EXPECT_NEAR(whole * sum.areas.at(0) / (pi * 2.25), 1., 2e-5);
        EXPECT_NEAR(whole * sum.areas.at(1) / (pi * 2.25), 1., 2e-5);
        EXPECT_NEAR(whole * sum.areas.at(2) / (2 * pi * 2.5 * 5), 1., 2e-5);
        EXPECT_NEAR(whole * sum.areas.at(3) / (pi * 4), 1., 2e-5);
        EXPECT_NEAR(whole * sum.areas.at(4) / (pi * 4), 1., 2e-5);
        for (const auto &plane : geometry->symmetry_planes())
          EXPECT_NEAR(sum.areas.at(plane.boundary),
                      2.5 * 5 * (part == "half" ? 2 : 1),
                      1e-10);
        expect_support_points_are_vertices(*geometry, mesh);
        expect_statically_determinate(*geometry);
      }
      {
        const auto geometry =
          read_plugin<Geometry>("open cylinder",
                                text + cut + "set Filled = false");
        const double     whole = geometry->symmetry_factor();
        Triangulation<3> mesh;
        make_mesh(*geometry, 1, mesh);
        const Totals sum = totals(*geometry, mesh);
        EXPECT_EQ(geometry->tissues().size(), 1u);
        EXPECT_EQ(geometry->boundary_names().at(3), "inside");
        EXPECT_NEAR(whole * sum.volume("membrane") / (pi * 2.25 * 5), 1., 2e-5);
        EXPECT_NEAR(whole * sum.areas.at(3) / (2 * pi * 2 * 5), 1., 2e-5);
        for (const auto &plane : geometry->symmetry_planes())
          EXPECT_NEAR(sum.areas.at(plane.boundary),
                      0.5 * 5 * (part == "half" ? 2 : 1),
                      1e-10);
        expect_support_points_are_vertices(*geometry, mesh);
        expect_statically_determinate(*geometry);
      }
    }
  EXPECT_TRUE(
    contains(input_error([]() {
               read_plugin<Geometry>("open cylinder",
                                     "set Cells along the cylinder = 3");
             }),
             "'Geometry/open cylinder/Cells along the cylinder'"));
}



TEST(SegmentChain, SupportIsStaticallyDeterminate)
{
  for (const std::string part : {"full", "half", "quarter"})
    {
      const auto       geometry = chain(uneven + "set Cross-section = " + part);
      Triangulation<3> mesh;
      make_mesh(*geometry, 0, mesh);
      expect_support_points_are_vertices(*geometry, mesh);
      expect_statically_determinate(*geometry);
    }
}



TEST(Block, BoundaryIdsIndexNamesAndSymmetryPlanesFollow)
{
  const std::string text = "set Lengths = 2, 3, 5\nset Cells = 2, 1, 3\n";
  const std::map<std::string, double> areas = {{"x min", 15.},
                                               {"x max", 15.},
                                               {"y min", 10.},
                                               {"y max", 10.},
                                               {"z min", 6.},
                                               {"z max", 6.}};
  for (const std::string symmetry :
       {"", "x", "y", "z", "x, y", "z, x", "y, z", "x, y, z"})
    {
      const auto geometry =
        read_plugin<Geometry>("block", text + "set Symmetry = " + symmetry);
      Triangulation<3> mesh;
      make_mesh(*geometry, 1, mesh);
      const Totals sum   = totals(*geometry, mesh);
      const auto   names = geometry->boundary_names();
      EXPECT_NEAR(sum.volume("block"), 30., 1e-10);
      EXPECT_EQ(names.size() + geometry->symmetry_planes().size(), 6u);
      for (unsigned int id = 0; id < names.size(); ++id)
        EXPECT_NEAR(sum.areas.at(id), areas.at(names[id]), 1e-12) << names[id];
      for (const auto &plane : geometry->symmetry_planes())
        {
          const std::string name = std::string(1, "xyz"[plane.direction]);
          EXPECT_NEAR(sum.areas.at(plane.boundary),
                      areas.at(name + " min"),
                      1e-12);
          EXPECT_TRUE(contains(symmetry, name));
          EXPECT_EQ(std::count(names.begin(), names.end(), name + " min"), 0);
        }
      EXPECT_EQ(geometry->symmetry_factor(), 1u << ((symmetry.size() + 2) / 3));
      expect_support_points_are_vertices(*geometry, mesh);
      expect_statically_determinate(*geometry);
      EXPECT_NEAR(area_in_plane(mesh, geometry->sections()[0].middle),
                  15.,
                  1e-12);
    }
}



TEST(Block, PatchesAreCutOutOfTheirFaces)
{
  const std::string text = "set Lengths = 2, 3, 5\nset Cells = 4, 3, 5\n";
  const std::string patches =
    "set Patches = punch, left, right\n"
    "subsection punch\nset Face = z max\nset From = 0.5, 1\n"
    "set To = 1.5, 3\nend\n"
    "subsection left\nset Face = y min\nset From = 0, 0\nset To = 1, 5\nend\n"
    "subsection right\nset Face = y min\nset From = 1, 0\nset To = 2, 5\nend\n";
  const std::map<std::string, double> areas = {{"x max", 15.},
                                               {"y min", 0.},
                                               {"y max", 10.},
                                               {"z min", 6.},
                                               {"z max", 4.},
                                               {"punch", 2.},
                                               {"left", 5.},
                                               {"right", 5.}};

  const auto geometry =
    read_plugin<Geometry>("block", text + patches + "set Symmetry = x");
  const Totals sum   = totals(*geometry, 1);
  const auto   names = geometry->boundary_names();
  EXPECT_EQ(names.size(), areas.size());
  for (unsigned int id = 0; id < names.size(); ++id)
    EXPECT_NEAR(sum.areas.at(id), areas.at(names[id]), 1e-12) << names[id];
  EXPECT_NEAR(sum.areas.at(geometry->symmetry_planes()[0].boundary),
              15.,
              1e-12);

  const auto expect = [&](const std::string &mistake,
                          const std::string &part,
                          const std::string &other_part) {
    const std::string got = input_error(
      [&]() { read_plugin<Geometry>("block", text + patches + mistake); });
    EXPECT_TRUE(contains(got, part) && contains(got, other_part)) << got;
  };
  const auto punch = [](const std::string &line) {
    return "subsection punch\n" + line + "\nend";
  };
  const std::string section = "'Geometry/block/punch";
  expect(punch("set From = 0.6, 1"), section + "/From'", "Move it to 0.5");
  expect(punch("set To = 1.5, 2.4"), section + "/To'", "y = 2.4");
  expect(punch("set To = 1.5, 4"), section + "/To'", "ends at 3");
  expect(punch("set To = 1.5, 1"), section + "/To'", "no width");
  expect("set Symmetry = y", "'Geometry/block/left/Face'", "Symmetry'");
  expect("subsection left\nset To = 1.5, 5\nend",
         "'Geometry/block/Patches'",
         "'left' and 'right' overlap on 'y min'");
  expect("set Patches = punch, left, right, x max",
         "'Geometry/block/Patches'",
         "'x max' is the name of a face");
}



TEST(TruncatedEllipsoid, VolumesAndAreasConvergeUnderRefinement)
{
  const auto geometry =
    read_plugin<Geometry>("truncated ellipsoid", "set Cells up to the base = 3");
  const auto cap = [](const double s, const double l) {
    return pi * s * s * (5. + 2. / 3. * l - 125. / (3. * l * l));
  };
  const double volume = cap(10., 20.) - cap(7., 17.);
  const double base =
    pi * (100. * (1. - 25. / 400.) - 49. * (1. - 25. / 289.));
  double last_volume = 0., last_base = 0.;
  for (unsigned int refinement = 0; refinement <= 2; ++refinement)
    {
      const Totals sum = totals(*geometry, refinement);
      EXPECT_GT(sum.smallest_jacobian, 0.1);
      const double volume_error = std::abs(sum.volume("wall") / volume - 1);
      const double base_error   = std::abs(sum.areas.at(0) / base - 1);
      if (refinement > 0)
        {
          EXPECT_LT(volume_error, last_volume / 12);
          EXPECT_LT(base_error, last_base / 12);
        }
      last_volume = volume_error;
      last_base   = base_error;
      EXPECT_GT(sum.areas.at(2), sum.areas.at(1));
    }
  EXPECT_LT(last_volume, 1e-5);
  EXPECT_LT(last_base, 1e-5);
}



TEST(TruncatedEllipsoid, WrongParametersAreErrorsThatNameThem)
{
  const auto message = [](const std::string &text) {
    return input_error(
      [&]() { read_plugin<Geometry>("truncated ellipsoid", text); });
  };
  EXPECT_TRUE(contains(message("set Outer short radius = 7"),
                       "'Outer short radius' is not larger"));
  EXPECT_TRUE(contains(message("set Outer long radius = 16"),
                       "'Outer long radius' is not larger"));
  EXPECT_TRUE(contains(message("set Base = -17"), "'Base' is a plane"));
  EXPECT_TRUE(contains(message("set Cells around a quarter = 3"),
                       "Cells around a quarter"));
}
