// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes of Gmsh: they are what the geometry they were written from is, and
// what deal.II's own reader makes of them.
#include <lumbricus/geometry/geometry.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_in.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>

#include "../write_msh.h"
#include "read_plugin.h"

using namespace lumbricus;
using namespace dealii;

namespace
{
  // A file of its own for every rank and test, removed at the end.
  class MshFile
  {
  public:
    MshFile()
      : name(std::string("mesh_file_test_") +
             ::testing::UnitTest::GetInstance()->current_test_info()->name() +
             "_" + std::to_string(getpid()) + ".msh")
    {}

    ~MshFile()
    {
      std::remove(name.c_str());
    }

    const std::string name;
  };



  std::unique_ptr<Geometry>
  mesh_file(const std::string &name, const std::string &text)
  {
    return read_plugin<Geometry>("mesh file",
                                 "set File = " + name + "\n" + text);
  }



  // Volumes by tissue and segment, areas by name of the boundary.
  std::map<std::string, double>
  measures(const Geometry &geometry, const Triangulation<3> &mesh)
  {
    const MappingQ<3>   mapping(2);
    const FE_Nothing<3> fe;
    FEValues<3>         cells(mapping, fe, QGauss<3>(3), update_JxW_values);
    FEFaceValues<3>     faces(mapping, fe, QGauss<2>(3), update_JxW_values);
    const auto          tissues = geometry.tissues();
    auto                names   = geometry.boundary_names();
    for (const auto &plane : geometry.symmetry_planes())
      names.push_back(std::string("symmetry ") + "xyz"[plane.direction]);

    std::map<std::string, double> result;
    for (const TissueName &tissue : tissues)
      for (unsigned int s = 1; s <= geometry.n_segments(); ++s)
        result[tissue.name + " " + std::to_string(s)] = 0.;
    for (const std::string &name : names)
      result[name] = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Region region = Region::of(cell->material_id());
          cells.reinit(cell);
          for (const double JxW : cells.get_JxW_values())
            result[tissues.at(region.tissue).name + " " +
                   std::to_string(region.segment + 1)] += JxW;
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              {
                faces.reinit(cell, f);
                for (const double JxW : faces.get_JxW_values())
                  result[names.at(cell->face(f)->boundary_id())] += JxW;
              }
        }
    for (auto &entry : result)
      entry.second = Utilities::MPI::sum(entry.second, mesh.get_communicator());
    return result;
  }



  std::map<std::string, double>
  measures(const Geometry &geometry, const unsigned int n_refinements = 0)
  {
    Triangulation<3> mesh;
    geometry.create_coarse_mesh(mesh);
    mesh.refine_global(n_refinements);
    return measures(geometry, mesh);
  }



  void
  expect_same(const std::map<std::string, double> &a,
              const std::map<std::string, double> &b,
              const double                         factor = 1.)
  {
    ASSERT_EQ(a.size(), b.size());
    for (const auto &[name, value] : a)
      {
        ASSERT_EQ(b.count(name), 1u) << name;
        EXPECT_NEAR(b.at(name) * factor, value, 1e-10 * (1. + value)) << name;
      }
  }



  const std::string quarter_of_two = "set Number of segments = 2\n"
                                     "set Cross-section = quarter\n"
                                     "set Cells around a quarter = 2\n";
  const std::string choices_of_chain =
    "set Wall layers = longitudinal muscle, circular muscle\n"
    "set Round surfaces = skin, inner circles\n";

  // Cubes of unit edge along x, each a physical volume of this name.
  std::vector<MshGroup>
  cubes(const std::vector<std::string> &names, std::vector<Point<3>> &nodes)
  {
    std::vector<MshGroup> groups;
    for (unsigned int i = 0; i <= names.size(); ++i)
      for (const double z : {0., 1.})
        for (const double y : {0., 1.})
          nodes.emplace_back(i, y, z);
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        const unsigned int v = 4 * i;
        groups.push_back(
          {3,
           names[i],
           {{v, v + 1, v + 3, v + 2, v + 4, v + 5, v + 7, v + 6}}});
      }
    return groups;
  }
} // namespace



TEST(MeshFile, IsTheChainItWasWrittenFrom)
{
  const auto chain = read_plugin<Geometry>("segment chain", quarter_of_two);
  for (const std::string version : {"2.2", "4.1"})
    {
      const MshFile file;
      write_msh(file.name, version, *chain);
      const auto read = mesh_file(file.name, choices_of_chain);
      EXPECT_EQ(read->n_segments(), 2u);
      EXPECT_EQ(read->symmetry_factor(), 4u);
      expect_same(measures(*chain), measures(*read));
      expect_same(measures(*chain, 1), measures(*read, 1));

      for (const TissueName &tissue : chain->tissues())
        {
          const auto tissues = read->tissues();
          const auto same    = std::find_if(tissues.begin(),
                                         tissues.end(),
                                         [&](const TissueName &other) {
                                           return other.name == tissue.name;
                                         });
          ASSERT_NE(same, tissues.end()) << tissue.name;
          EXPECT_EQ(same->liquid, tissue.liquid) << tissue.name;
          EXPECT_EQ(same->wall_layer, tissue.wall_layer) << tissue.name;
        }
    }
}



TEST(MeshFile, IsTheSameOnAParallelMesh)
{
  const auto chain = read_plugin<Geometry>("segment chain", quarter_of_two);
  const MshFile file;
  write_msh(file.name, "4.1", *chain);
  const auto read = mesh_file(file.name, choices_of_chain);
  parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  read->create_coarse_mesh(mesh);
  mesh.refine_global(1);
  expect_same(measures(*chain, 1), measures(*read, mesh));
}



TEST(MeshFile, IsWhatTheReaderOfDealIIMakesOfIt)
{
  // Without the cells that are turned around, of which it takes none.
  std::vector<Point<3>> nodes;
  auto                  groups = cubes({"wall", "wall 2", "cap"}, nodes);
  // The face x = 0.
  groups.push_back({2, "head", {{0, 1, 3, 2}}});
  for (const std::string version : {"2.2", "4.1"})
    {
      const MshFile file;
      write_msh(file.name, version, nodes, groups);

      Triangulation<3> reference;
      GridIn<3>        grid_in;
      grid_in.attach_triangulation(reference);
      std::ifstream in(file.name);
      grid_in.read_msh(in);

      Triangulation<3> mesh;
      mesh_file(file.name, "set Liquid tissues =")->create_coarse_mesh(mesh);
      ASSERT_EQ(mesh.n_active_cells(), reference.n_active_cells());
      ASSERT_EQ(mesh.n_vertices(), reference.n_vertices());
      for (const auto &cell : mesh.active_cell_iterators())
        {
          bool found = false;
          for (const auto &other : reference.active_cell_iterators())
            if (cell->center().distance(other->center()) < 1e-12)
              {
                found = true;
                EXPECT_NEAR(cell->measure(), other->measure(), 1e-12);
              }
          EXPECT_TRUE(found);
        }
    }
}



TEST(MeshFile, NamesAreTissuesAndSegments)
{
  std::vector<Point<3>> nodes;
  const auto            groups =
    cubes({"circular layer 1", "circular layer 2", "cap"}, nodes);
  const MshFile file;
  write_msh(file.name, "4.1", nodes, groups);
  const auto read = mesh_file(file.name,
                              "set Liquid tissues =\n"
                              "set Wall layers = circular layer\n"
                              "set Scale = 0.5\n");
  EXPECT_EQ(read->n_segments(), 2u);
  ASSERT_EQ(read->tissues().size(), 2u);
  EXPECT_EQ(read->tissues()[0].name, "circular layer");
  EXPECT_TRUE(read->tissues()[0].wall_layer);
  EXPECT_EQ(read->tissues()[1].name, "cap");
  EXPECT_EQ(read->boundary_names(), std::vector<std::string>{"free"});
  EXPECT_TRUE(read->symmetry_planes().empty());
  expect_same({{"circular layer 1", 0.125},
               {"circular layer 2", 0.125},
               {"cap 1", 0.125},
               {"cap 2", 0.},
               {"free", 14 * 0.25}},
              measures(*read));
}



TEST(MeshFile, SectionsArePlanesOfTheMesh)
{
  const auto chain = read_plugin<Geometry>("segment chain", quarter_of_two);
  const MshFile file;
  write_msh(file.name, "2.2", *chain);
  const auto sections = mesh_file(file.name, choices_of_chain)->sections();
  ASSERT_EQ(sections.size(), 2u);
  // Between the ends of the liquid: here the septum is no part of it.
  EXPECT_NEAR(sections[0].begin, 0.3, 1e-12);
  EXPECT_NEAR(sections[0].middle, 1.3, 1e-12);
  EXPECT_NEAR(sections[0].end, 2.3, 1e-12);
  EXPECT_NEAR(sections[1].begin, 2.4, 1e-12);
  EXPECT_NEAR(sections[1].middle, 3.4, 1e-12);
  EXPECT_NEAR(sections[1].end, 4.4, 1e-12);
}



TEST(MeshFile, SectionsOfABodyWithoutLiquidAreItsEndsAndAPlaneNearItsMiddle)
{
  // The middle of three cubes is no plane of the mesh.
  std::vector<Point<3>> nodes;
  const auto            groups = cubes({"wall", "wall", "wall"}, nodes);
  const MshFile         file;
  write_msh(file.name, "2.2", nodes, groups);
  const auto sections =
    mesh_file(file.name, "set Liquid tissues =")->sections();
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_NEAR(sections[0].begin, 0., 1e-12);
  EXPECT_NEAR(std::abs(sections[0].middle - 1.5), 0.5, 1e-12);
  EXPECT_NEAR(sections[0].end, 3., 1e-12);
}



TEST(MeshFile, SupportPointsAreVerticesOfTheWall)
{
  for (const std::string part : {"full", "half", "quarter"})
    {
      const auto chain =
        read_plugin<Geometry>("segment chain",
                              "set Cells around a quarter = 2\n"
                              "set Cross-section = " +
                                part);
      const MshFile file;
      write_msh(file.name, "4.1", *chain);
      const auto read   = mesh_file(file.name, choices_of_chain);
      const auto points = read->support_points();

      Triangulation<3> mesh;
      read->create_coarse_mesh(mesh);
      for (const auto &point : points)
        {
          bool in_wall = false;
          for (const auto &cell : mesh.active_cell_iterators())
            if (!read->tissues()[Region::of(cell->material_id()).tissue].liquid)
              for (const unsigned int v : cell->vertex_indices())
                in_wall |= cell->vertex(v).distance(point) < 1e-10;
          EXPECT_TRUE(in_wall) << point;
        }
      // A long lever for each of the three rotations.
      const Tensor<1, 3> B = points[1] - points[0], C = points[2] - points[0];
      EXPECT_GT(std::abs(B[0]), 6.);
      EXPECT_GT(std::abs(B[0] * C[2] - B[2] * C[0]), 6. * 2.);
    }
}



TEST(MeshFile, CellsThatAreOnlyTouchingAreAnError)
{
  // Two cubes side by side, each with nodes of its own.
  std::vector<Point<3>> nodes;
  auto                  groups = cubes({"wall"}, nodes);
  const auto            more   = cubes({"wall"}, nodes);
  for (unsigned int v = 8; v < 16; ++v)
    nodes[v][0] += 1.;
  auto element = more[0].elements[0];
  for (unsigned int &v : element)
    v += 8;
  groups[0].elements.push_back(element);
  const MshFile file;
  write_msh(file.name, "4.1", nodes, groups);
  const std::string message =
    input_error([&]() { mesh_file(file.name, "set Liquid tissues ="); });
  for (const std::string part : {"'Geometry/mesh file/File'",
                                 "two nodes at the same place",
                                 "(1, ",
                                 "'Coherence;'"})
    EXPECT_TRUE(contains(message, part)) << message;
}



namespace
{
  // A tube about a line, of this length, radius 1 to 1.3, with eight cells
  // around and two along it.
  void
  write_tube(const std::string  &file_name,
             const Point<3>     &begin,
             const Tensor<1, 3> &direction,
             const double        length)
  {
    const unsigned int n_around = 8, n_along = 2;
    Tensor<1, 3>       other;
    other[std::abs(direction[0]) < 0.5 ? 0 : 1] = 1.;
    const Tensor<1, 3> d  = direction / direction.norm();
    const Tensor<1, 3> a  = cross_product_3d(d, other);
    const Tensor<1, 3> e1 = a / a.norm(), e2 = cross_product_3d(d, e1);

    std::vector<Point<3>> nodes;
    for (unsigned int k = 0; k <= n_along; ++k)
      for (unsigned int j = 0; j < n_around; ++j)
        for (const double r : {1., 1.3})
          {
            const double phi = 2. * numbers::PI * j / n_around;
            nodes.push_back(begin + length * k / n_along * d +
                            r * (std::cos(phi) * e1 + std::sin(phi) * e2));
          }
    const auto node = [&](const unsigned int k,
                          const unsigned int j,
                          const unsigned int i) {
      return 2 * (n_around * k + j % n_around) + i;
    };
    std::vector<MshGroup> groups = {{3, "wall"}, {2, "inside"}, {2, "outside"}};
    for (unsigned int k = 0; k < n_along; ++k)
      for (unsigned int j = 0; j < n_around; ++j)
        {
          std::vector<unsigned int> cell;
          for (const unsigned int level : {k, k + 1})
            for (const auto &[around, i] :
                 {std::pair<unsigned int, unsigned int>{j, 0},
                  {j, 1},
                  {j + 1, 1},
                  {j + 1, 0}})
              cell.push_back(node(level, around, i));
          groups[0].elements.push_back(cell);
          for (const unsigned int i : {0, 1})
            groups[1 + i].elements.push_back({node(k, j, i),
                                              node(k, j + 1, i),
                                              node(k + 1, j + 1, i),
                                              node(k + 1, j, i)});
        }
    write_msh(file_name, "4.1", nodes, groups);
  }
} // namespace



// Surfaces that are round about another axis than x were bent about x, in
// silence: a quarter of a tube along z had the volume 3.862 where its facets
// have 3.903 and the tube has 4.335.
TEST(MeshFile, RoundSurfacesAreRoundAboutTheirAxis)
{
  struct
  {
    Point<3>     begin;
    Tensor<1, 3> direction;
    std::string  parameter;
  } const tubes[] = {
    {{0., 0., 0.}, Tensor<1, 3>({1., 0., 0.}), "x"},
    {{0., -1., 0.}, Tensor<1, 3>({0., 1., 0.}), "y"},
    {{0., 0., 1.}, Tensor<1, 3>({0., 0., 1.}), "z"},
    {{0.5, -2., 3.}, Tensor<1, 3>({0., 0., 1.}), "0.5, -2, 0; 0, 0, -2"},
    {{3., 1., -2.}, Tensor<1, 3>({1., 2., -2.}), "4, 3, -4; 1, 2, -2"}};
  const double volume = numbers::PI * (1.3 * 1.3 - 1.) * 2.;
  const double area   = 2. * numbers::PI * 1.3 * 2.;
  for (const auto &tube : tubes)
    {
      const MshFile file;
      write_tube(file.name, tube.begin, tube.direction, 2.);
      const auto read = mesh_file(file.name,
                                  "set Liquid tissues =\n"
                                  "set Round surfaces = inside, outside\n"
                                  "set Round axis = " +
                                    tube.parameter);
      // Of quadratic faces the error is of fourth order.
      const auto coarse = measures(*read), fine = measures(*read, 1);
      const auto error = [&](const auto &from) {
        return std::abs(from.at("wall 1") / volume - 1.) +
               std::abs(from.at("outside") / area - 1.);
      };
      EXPECT_LT(error(coarse), 5e-3) << tube.parameter;
      EXPECT_LT(error(fine), error(coarse) / 10.) << tube.parameter;
    }
}



TEST(MeshFile, SurfacesThatAreNotRoundAboutTheAxisAreAnError)
{
  const MshFile file;
  write_tube(file.name, Point<3>(0., 0., 1.), Tensor<1, 3>({0., 0., 1.}), 2.);
  const std::string choices = "set Liquid tissues =\n"
                              "set Round surfaces = outside\n"
                              "set Round axis = ";
  EXPECT_EQ(input_error([&]() { mesh_file(file.name, choices + "z"); }), "");
  for (const std::string axis :
       {"x", "y", "0.01, 0, 0; 0, 0, 1", "0, 0, 0; 0, 0.1, 1"})
    {
      const std::string message =
        input_error([&]() { mesh_file(file.name, choices + axis); });
      for (const std::string part : {"'Geometry/mesh file/Round surfaces'",
                                     "'outside', which is not round about ",
                                     axis.c_str(),
                                     " mm off a surface of revolution",
                                     "Set 'Round axis'"})
        EXPECT_TRUE(contains(message, part)) << message;
    }
}



// A ball that is meshed irregularly, as by cutting tetrahedra, has no rings; a
// row of cones is exact.
TEST(MeshFile, BallsAndConesAreRound)
{
  for (const bool irregular : {false, true})
    for (const unsigned int n_rings : {4u, 8u})
      {
        std::vector<Point<3>> nodes;
        std::vector<MshGroup> groups = {{3, "wall"}, {2, "skin"}};
        const unsigned int    n      = n_rings;
        const auto            node   = [n](const unsigned int i,
                              const unsigned int j,
                              const unsigned int k) {
          return (i * (n + 1) + j) * (n + 1) + k;
        };
        // A shell over a patch of the ball away from the axis, which in the
        // irregular mesh is turned by 45 degrees.
        for (const double r : {1., 1.2})
          for (unsigned int j = 0; j <= n; ++j)
            for (unsigned int k = 0; k <= n; ++k)
              {
                const double u = 0.8 * (j / double(n) - 0.5);
                const double v = 0.8 * (k / double(n) - 0.5);
                const double a = (u + v) / std::sqrt(2.);
                const double b = (u - v) / std::sqrt(2.);
                const double latitude  = irregular ? a : u;
                const double longitude = irregular ? b : v;
                nodes.emplace_back(r * std::sin(latitude),
                                   r * std::cos(latitude) * std::cos(longitude),
                                   r * std::cos(latitude) *
                                     std::sin(longitude));
              }
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < n; ++k)
            {
              std::vector<unsigned int> cell;
              for (const unsigned int i : {0, 1})
                for (const auto &[a, b] :
                     {std::pair<unsigned int, unsigned int>{0, 0},
                      {1, 0},
                      {1, 1},
                      {0, 1}})
                  cell.push_back(node(i, j + a, k + b));
              groups[0].elements.push_back(cell);
              groups[1].elements.push_back({cell.begin() + 4, cell.end()});
            }
        const MshFile file;
        write_msh(file.name, "2.2", nodes, groups);
        EXPECT_EQ(input_error([&]() {
                    mesh_file(file.name,
                              "set Liquid tissues =\n"
                              "set Round surfaces = skin\n");
                  }),
                  "")
          << irregular << " " << n_rings;
      }
}



// The check of what touches looks at pairs of neighbours only: it took minutes
// for a mesh of this size if it compared all with all.
TEST(MeshFile, LargeMeshesAreCheckedFast)
{
  std::vector<Point<3>> nodes;
  std::vector<MshGroup> groups = {{3, "wall"}};
#ifdef DEBUG
  const unsigned int n = 16;
#else
  const unsigned int n = 40;
#endif
  const auto node = [n](const unsigned int i,
                        const unsigned int j,
                        const unsigned int k) {
    return (i * (n + 1) + j) * (n + 1) + k;
  };
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int k = 0; k <= n; ++k)
        nodes.emplace_back(i, j, k);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int k = 0; k < n; ++k)
        groups[0].elements.push_back({node(i, j, k),
                                      node(i + 1, j, k),
                                      node(i + 1, j + 1, k),
                                      node(i, j + 1, k),
                                      node(i, j, k + 1),
                                      node(i + 1, j, k + 1),
                                      node(i + 1, j + 1, k + 1),
                                      node(i, j + 1, k + 1)});
  const MshFile file;
  write_msh(file.name, "2.2", nodes, groups);
  const std::clock_t begin = std::clock();
  EXPECT_EQ(input_error(
              [&]() { mesh_file(file.name, "set Liquid tissues =\n"); }),
            "");
  EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, 30.);
}
