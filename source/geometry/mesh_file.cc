// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>

#include "named_mesh.h"
#include "round_axis.h"

namespace lumbricus
{
  /**
   * A body meshed with Gmsh. Its physical volumes are named by tissue and
   * segment, its physical surfaces by boundary; see NamedMesh.
   */
  class MeshFromFile : public Geometry
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override
    {
      mesh();
    }

    void
    create_coarse_mesh(
      dealii::Triangulation<dim> &triangulation) const override;

    unsigned int
    n_segments() const override
    {
      return mesh().sections.size();
    }

    std::vector<TissueName>
    tissues() const override
    {
      return mesh().tissues;
    }

    std::vector<std::string>
    boundary_names() const override
    {
      return mesh().boundary_names;
    }

    std::string
    inside_of_body(const std::string &name) const override
    {
      const auto found = mesh().inner_surfaces.find(name);
      return found == mesh().inner_surfaces.end() ? "" : found->second;
    }

    std::vector<SymmetryPlane>
    symmetry_planes() const override
    {
      return mesh().symmetry_planes;
    }

    std::vector<CavityWall>
    cavities() const override
    {
      return mesh().cavities;
    }

    std::string
    way_without_symmetry() const override
    {
      return "Give a mesh of the whole body, without the physical surface of "
             "the plane.";
    }

    std::vector<SegmentSections>
    sections() const override
    {
      return mesh().sections;
    }

    std::array<dealii::Point<dim>, 3>
    support_points() const override
    {
      return mesh().support_points;
    }

    double
    characteristic_length() const override
    {
      return mesh().characteristic_length;
    }

  private:
    inline static const std::string path = "Geometry/mesh file";

    /** The mesh, which is read when first asked for. */
    const NamedMesh &
    mesh() const;

    /** Throw where cells are folded between round and flat faces. */
    void
    check_curved_cells(const dealii::Triangulation<dim> &triangulation) const;

    NamedMeshChoices choices;

    /** What was read, and for which parameters. */
    mutable std::unique_ptr<const NamedMesh> read_mesh;
    mutable NamedMeshChoices                 read_for;
  };



  void
  MeshFromFile::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("File",
                      choices.file_name,
                      "[path] A .msh file of Gmsh, as text in the format 2.2 "
                      "or 4.1, with hexahedra of first or of second order: of "
                      "eight nodes, whose faces are spanned by their vertices, "
                      "or of 20 or 27, whose faces are curved. A relative path "
                      "starts at the working directory. A physical volume is "
                      "named by its tissue and the number of its segment, as "
                      "in 'wall 2' (1 if there is no number), a physical "
                      "surface by what loads call it; the names 'symmetry x', "
                      "'symmetry y' and 'symmetry z' make it a plane of mirror "
                      "symmetry, 'cavity 1', 'cavity 2', ... the wall around the "
                      "chamber of that segment, which then has no cells but one "
                      "pressure, see Cavities. What is in no physical surface is the "
                      "boundary 'free'. The axis of the body has to be the x "
                      "axis.",
                      dealii::Patterns::FileName());
    const dealii::Patterns::Anything anything;
    const dealii::Patterns::List     names(anything);
    prm.add_parameter("Liquid tissues",
                      choices.liquids,
                      "[names] The tissues that are liquid, whose shape is "
                      "reset, separated by commas.",
                      names);
    prm.add_parameter(
      "Wall layers",
      choices.wall_layers,
      "[names] The tissues that are layers of the wall around the chamber, on "
      "whose sections the length of a segment is measured, separated by "
      "commas: not septa or caps. The sections are the planes of mesh faces "
      "(x the same everywhere in a face) nearest to both ends of the "
      "segment's liquid, or of all of the segment where it has no liquid; the "
      "radius is measured in the plane nearest to the middle. Where there is "
      "none within a quarter of the liquid's length, the table says 'nan'.",
      names);
    prm.add_parameter("Scale",
                      choices.scale,
                      "[mm] How long a unit of the file is.",
                      PositiveNumber());
    prm.add_parameter("Round surfaces",
                      choices.round_surfaces,
                      "[names] Physical surfaces that are round about the "
                      "'Round axis', separated by commas. Their faces follow "
                      "the circle; all others are spanned by the vertices. "
                      "They may be inside the body, as that between liquid and "
                      "wall.",
                      names);
    prm.add_parameter("Round axis",
                      choices.round_axis,
                      "[axis] What 'Round surfaces' are round about: 'x', 'y' "
                      "or 'z', or a point in mm and a direction, as '0, 1.5, "
                      "0; 0, 0, 1'. Fibres and lengths refer to the x axis "
                      "whatever it is.",
                      dealii::Patterns::Anything());
  }



  const NamedMesh &
  MeshFromFile::mesh() const
  {
    if (read_mesh == nullptr || !(read_for == choices))
      {
        read_mesh = std::make_unique<NamedMesh>(
          read_named_mesh(path, choices));
        read_for = choices;
      }
    return *read_mesh;
  }



  void
  MeshFromFile::create_coarse_mesh(
    dealii::Triangulation<dim> &triangulation) const
  {
    const NamedMesh &from = mesh();
    triangulation.create_triangulation(from.vertices,
                                       from.cells,
                                       dealii::SubCellData());
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        {
          FaceKey key;
          for (unsigned int v = 0; v < key.size(); ++v)
            key[v] = face->vertex_index(v);
          std::sort(key.begin(), key.end());
          if (face->at_boundary())
            {
              const auto id = from.boundary_ids.find(key);
              Assert(id != from.boundary_ids.end(), dealii::ExcInternalError());
              face->set_boundary_id(id->second);
            }
          if (from.round_faces.count(key) > 0)
            face->set_all_manifold_ids(cylindrical_manifold_id);
        }
    for (std::size_t c = 0; c < from.curved_cells.size(); ++c)
      {
        // Cells are numbered as they were given; a face has the shape of either.
        const dealii::Triangulation<dim>::cell_iterator cell(&triangulation,
                                                             0,
                                                             c);
        const dealii::types::manifold_id id = cylindrical_manifold_id + 1 + c;
        Assert(from.curved_cells[c].shape.corner(0).distance(
                 cell->center()) < cell->diameter(),
               dealii::ExcInternalError());
        cell->set_all_manifold_ids(id);
        triangulation.set_manifold(
          id, QuadraticManifold(from.curved_cells[c].shape));
      }
    if (from.round_faces.empty())
      return;
    const RoundAxis axis(path + "/Round axis", choices.round_axis);
      triangulation.set_manifold(cylindrical_manifold_id,
                                 dealii::CylindricalManifold<dim>(
                                   axis.direction, axis.point));
    check_curved_cells(triangulation);
  }



  void
  MeshFromFile::check_curved_cells(
    const dealii::Triangulation<dim> &triangulation) const
  {
    // Where a cell of quadratic faces is folded most, if it is.
    dealii::QGaussLobatto<dim>    points(3);
    const dealii::MappingQ<dim>   mapping(2);
    const dealii::FE_Nothing<dim> fe;
    dealii::FEValues<dim>         values(mapping,
                                 fe,
                                 points,
                                 dealii::update_jacobians);
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        const auto faces = cell->face_iterators();
        if (std::none_of(faces.begin(), faces.end(), [](const auto &face) {
              return face->manifold_id() == cylindrical_manifold_id;
            }))
          continue;
        values.reinit(cell);
        double least = std::numeric_limits<double>::max(), most = 0.;
        for (const auto &J : values.get_jacobians())
          {
            const double det = determinant(dealii::Tensor<2, dim>(J));
            least            = std::min(least, det);
            most             = std::max(most, std::abs(det));
          }
        AssertThrow(least > 1e-3 * most,
                    ExcInput(about_parameter(
                      path + "/Round surfaces",
                      ": the cell of the mesh file '" + choices.file_name +
                        "' at " + point_text(cell->center()) +
                        " becomes folded where its faces follow the circle. "
                        "Name the surface on the other side of the wall too, "
                        "or mesh it with more cells around the axis.")));
      }
  }



  static const Register<Geometry, MeshFromFile>
    mesh_file("mesh file",
              "a mesh made with Gmsh, whose physical names say what is what.");
} // namespace lumbricus
