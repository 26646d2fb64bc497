// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/named_list.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>

#include "block_patch.h"
#include "coarse_cells.h"

namespace lumbricus
{
  /**
   * A box [0, Lx] x [0, Ly] x [0, Lz] of one tissue: one segment, for tests of
   * laws and loads. The faces at x = 0, y = 0, z = 0 can be mirror planes; the
   * names of the others are followed by those of the patches cut out of them.
   */
  class Block : public Geometry
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

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
      return {{tissue, liquid, true}};
    }

    std::vector<std::string>
    boundary_names() const override;

    std::vector<SymmetryPlane>
    symmetry_planes() const override;

    std::string
    way_without_symmetry() const override
    {
      return "Take the axis out of '" + path + "/Symmetry'.";
    }

    std::vector<SegmentSections>
    sections() const override
    {
      return {{0., lengths[0] / 2, lengths[0]}};
    }

    std::array<dealii::Point<dim>, 3>
    support_points() const override;

    double
    characteristic_length() const override
    {
      return *std::min_element(lengths.begin(), lengths.end());
    }

  private:
    inline static const std::string path = "Geometry/block";

    /** Whether the face at the lower end of axis @p d is a mirror plane. */
    bool
    mirrored(const unsigned int d) const;

    /** Whether the face of this number is a mirror plane. */
    bool
    mirror_face(const unsigned int face) const
    {
      return face % 2 == 0 && mirrored(face / 2);
    }

    std::vector<double>       lengths  = {1., 1., 1.};
    std::vector<unsigned int> n_cells  = {2, 2, 2};
    std::string               tissue   = "block";
    bool                      liquid   = false;
    std::string               symmetry = "";
    NamedList<BlockPatch>     patches  = {
      "Patches",
      "<patch>",
      "Rectangles on faces that are boundaries of their own, names of your "
      "own, each with a section of that name here. The name of the face stands "
      "for the rest of it."};
  };



  void
  Block::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Lengths",
                      lengths,
                      "[mm] Lengths of the edges along x, y, z. The block is "
                      "[0, Lx] x [0, Ly] x [0, Lz].",
                      dealii::Patterns::List(PositiveNumber(), dim, dim));
    prm.add_parameter("Cells",
                      n_cells,
                      "[numbers] Cells along x, y, z. To be measured in its "
                      "middle, the block needs an even number along x (or one "
                      "refinement).",
                      dealii::Patterns::List(dealii::Patterns::Integer(1),
                                             dim,
                                             dim));
    prm.add_parameter("Tissue name",
                      tissue,
                      "[name] What the block is made of.",
                      Name());
    prm.add_parameter("Liquid",
                      liquid,
                      "[true or false] Whether the tissue is a liquid, whose "
                      "shape is reset.");
    prm.add_parameter("Symmetry",
                      symmetry,
                      "[list of x, y, z] Axes at whose lower end the block has "
                      "a plane of mirror symmetry, instead of a boundary with "
                      "a name.",
                      dealii::Patterns::MultipleSelection("x|y|z"));
    patches.declare_parameters(prm);
  }



  bool
  Block::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    return patches.extend_parameters(prm, extent);
  }



  void
  Block::check_parameters() const
  {
    patches.check_parameters();
    check_n_coarse_cells(path, double(n_cells[0]) * n_cells[1] * n_cells[2]);

    for (unsigned int i = 0; i < patches.size(); ++i)
      {
        const BlockPatch  &patch   = patches[i];
        const std::string &face    = block_face_names[patch.face()];
        const std::string  section = path + "/" + patch.name;
        AssertThrow(std::count(block_face_names.begin(),
                               block_face_names.end(),
                               patch.name) == 0,
                    ExcInput(about_parameter(path + "/Patches",
                                             ": '" + patch.name +
                                               "' is the name of a face. "
                                               "Choose another.")));
        AssertThrow(!mirror_face(patch.face()),
                    ExcInput(about_parameter(
                      section + "/Face",
                      ": '" + face +
                        "' is a plane of symmetry. Choose another face, or "
                        "take " +
                        face[0] + " out of '" + path + "/Symmetry'.")));
        patch.check(section, lengths, n_cells);
        for (unsigned int j = 0; j < i; ++j)
          AssertThrow(!patch.overlaps(patches[j]),
                      ExcInput(about_parameter(
                        path + "/Patches",
                        ": '" + patches[j].name + "' and '" + patch.name +
                          "' overlap on '" + face +
                          "'. Make them disjoint.")));
      }
  }



  bool
  Block::mirrored(const unsigned int d) const
  {
    const auto axes = dealii::Utilities::split_string_list(symmetry);
    return std::find(axes.begin(), axes.end(), std::string(1, "xyz"[d])) !=
           axes.end();
  }



  void
  Block::create_coarse_mesh(dealii::Triangulation<dim> &triangulation) const
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation,
      n_cells,
      dealii::Point<dim>(),
      dealii::Point<dim>(lengths[0], lengths[1], lengths[2]),
      true);

    // From the number of a face of the block to its boundary id.
    const unsigned int          n_names     = boundary_names().size();
    const unsigned int          first_patch = n_names - patches.size();
    std::array<unsigned int, 6> ids;
    unsigned int                named = 0, plane = n_names;
    for (unsigned int f = 0; f < ids.size(); ++f)
      ids[f] = mirror_face(f) ? plane++ : named++;

    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        cell->set_material_id(Region{0, 0}.material_id());
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            {
              cell->face(f)->set_boundary_id(ids[f]);
              for (unsigned int i = 0; i < patches.size(); ++i)
                if (patches[i].face() == f &&
                    patches[i].contains(cell->face(f)->center()))
                  cell->face(f)->set_boundary_id(first_patch + i);
            }
      }
  }



  std::vector<std::string>
  Block::boundary_names() const
  {
    std::vector<std::string> names;
    for (unsigned int f = 0; f < block_face_names.size(); ++f)
      if (!mirror_face(f))
        names.push_back(block_face_names[f]);
    for (unsigned int i = 0; i < patches.size(); ++i)
      names.push_back(patches[i].name);
    return names;
  }



  std::vector<SymmetryPlane>
  Block::symmetry_planes() const
  {
    std::vector<SymmetryPlane> planes;
    dealii::types::boundary_id id = boundary_names().size();
    for (unsigned int d = 0; d < dim; ++d)
      if (mirrored(d))
        planes.push_back({id++, d});
    return planes;
  }



  std::array<dealii::Point<dim>, 3>
  Block::support_points() const
  {
    // A mirror plane forbids rotations about the axes in it. What B (or C)
    // would hold is then held by A already, and the points coincide.
    const double x = mirrored(0) ? 0. : lengths[0];
    const double z = mirrored(2) ? 0. : lengths[2];
    return {{dealii::Point<dim>(),
             dealii::Point<dim>(x, 0., 0.),
             dealii::Point<dim>(0., 0., z)}};
  }



  static const Register<Geometry, Block>
    block("block", "a rectangular box of one tissue.");
} // namespace lumbricus
