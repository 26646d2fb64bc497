// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/patterns.h>
#include <lumbricus/core/registry.h>
#include <lumbricus/geometry/named_mesh.h>

#include <deal.II/grid/manifold_lib.h>

#include <memory>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int               x_axis                  = 0;
    constexpr dealii::types::manifold_id cylindrical_manifold_id = 1;
  } // namespace



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

    std::vector<SymmetryPlane>
    symmetry_planes() const override
    {
      return mesh().symmetry_planes;
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
    /** The mesh, which is read when first asked for. */
    const NamedMesh &
    mesh() const;

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
                      "or 4.1, with hexahedra of eight nodes. A relative path "
                      "starts at the working directory. A physical volume is "
                      "named by its tissue and the number of its segment, as "
                      "in 'wall 2' (1 if there is no number), a physical "
                      "surface by what loads call it; the names 'symmetry x', "
                      "'symmetry y' and 'symmetry z' make it a plane of mirror "
                      "symmetry. What is in no physical surface is the "
                      "boundary 'free'. The axis of the body has to be the x "
                      "axis.");
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
                      "[names] Physical surfaces that are round about the x "
                      "axis, separated by commas. Their faces follow the "
                      "circle; all others are spanned by the vertices. They "
                      "may be inside the body, as that between liquid and "
                      "wall.",
                      names);
  }



  const NamedMesh &
  MeshFromFile::mesh() const
  {
    if (read_mesh == nullptr || !(read_for == choices))
      {
        read_mesh = std::make_unique<NamedMesh>(
          read_named_mesh("Geometry/mesh file", choices));
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
    if (!from.round_faces.empty())
      triangulation.set_manifold(cylindrical_manifold_id,
                                 dealii::CylindricalManifold<dim>(x_axis));
  }



  static const Register<Geometry, MeshFromFile>
    mesh_file("mesh file",
              "a mesh made with Gmsh, whose physical names say what is what.");
} // namespace lumbricus
