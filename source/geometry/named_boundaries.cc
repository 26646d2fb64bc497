// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/expression.h>
#include <lumbricus/geometry/named_boundaries.h>

#include <deal.II/base/bounding_box.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    using NameOfFace = std::map<FaceKey, std::string>;
    using FaceCounts = std::map<FaceKey, unsigned int>;

    const std::string free_boundary = "free";

    const std::array<std::string, dim> symmetry_names = {
      {"symmetry x", "symmetry y", "symmetry z"}};



    void
    name_faces(const MshFile      &file,
               const NameOfFace   &name_of_face,
               const FaceCounts   &n_cells,
               const MeshMessages &messages,
               NamedMesh          &mesh)
    {
      // The names of the boundary in the order of their tags, then the planes.
      std::set<std::string> used;
      for (const auto &[key, n] : n_cells)
        if (n == 1)
          {
            const auto name = name_of_face.find(key);
            used.insert(name == name_of_face.end() ? free_boundary :
                                                     name->second);
          }
      std::map<std::string, dealii::types::boundary_id> ids;
      const auto add = [&](const std::string &name) {
        const bool plane =
          std::find(symmetry_names.begin(), symmetry_names.end(), name) !=
          symmetry_names.end();
        if (!plane && used.count(name) > 0 &&
            ids.insert({name, mesh.boundary_names.size()}).second)
          mesh.boundary_names.push_back(name);
        if (!plane && name.compare(0, 8, "symmetry") == 0)
          messages.fail(
            " has a physical surface '" + name +
            "'. Name a plane of mirror symmetry 'symmetry x', 'symmetry y' "
            "or 'symmetry z', by the direction of its normal; other "
            "surfaces must not begin with 'symmetry'.");
      };
      for (const auto &entry : file.surface_names)
        add(entry.second);
      add(free_boundary);
      for (unsigned int d = 0; d < dim; ++d)
        if (used.count(symmetry_names[d]) > 0)
          {
            const dealii::types::boundary_id id =
              mesh.boundary_names.size() + mesh.symmetry_planes.size();
            ids[symmetry_names[d]] = id;
            mesh.symmetry_planes.push_back({id, d});
          }

      for (const auto &[key, n] : n_cells)
        if (n == 1)
          {
            const auto name = name_of_face.find(key);
            mesh.boundary_ids[key] =
              ids.at(name == name_of_face.end() ? free_boundary : name->second);
          }
    }



    void
    check_symmetry_planes(const NamedMesh &mesh, const MeshMessages &messages)
    {
      const dealii::BoundingBox<dim> box(mesh.vertices);
      for (const SymmetryPlane &plane : mesh.symmetry_planes)
        {
          const unsigned int d     = plane.direction;
          double             least = std::numeric_limits<double>::max();
          double             most  = -least;
          for (const auto &[key, id] : mesh.boundary_ids)
            if (id == plane.boundary)
              for (const unsigned int v : key)
                {
                  least = std::min(least, mesh.vertices[v][d]);
                  most  = std::max(most, mesh.vertices[v][d]);
                }
          const double lower = box.lower_bound(d), upper = box.upper_bound(d);
          const double tolerance = 1e-6 * (upper - lower);
          const std::string axis(1, "xyz"[d]);
          const auto        complain = [&](const std::string &what) {
            std::ostringstream range;
            range << " has the plane of mirror symmetry '" << symmetry_names[d]
                  << "' " << what << ": it reaches from " << axis << " = "
                  << least << " to " << most;
            if (least - lower > tolerance && upper - most > tolerance)
              range << ", and the body from " << lower << " to " << upper;
            range << ". All of its faces have to be in one plane " << axis
                  << " = const at one end of the body.";
            messages.fail(range.str());
          };
          if (most - least > tolerance)
            complain("that is not flat");
          if (least - lower > tolerance && upper - most > tolerance)
            complain("inside the body");
        }
    }



    void
    find_round_faces(const NameOfFace               &name_of_face,
                     const std::vector<std::string> &round_surfaces,
                     const MeshMessages             &messages,
                     NamedMesh                      &mesh)
    {
      std::set<std::string> names;
      for (const auto &entry : name_of_face)
        names.insert(entry.second);
      messages.check_list("Round surfaces",
                          "physical surface",
                          round_surfaces,
                          names);

      const double tolerance =
        1e-6 * dealii::BoundingBox<dim>(mesh.vertices).side_length(0);
      const std::set<std::string> round(round_surfaces.begin(),
                                        round_surfaces.end());
      for (const auto &[key, name] : name_of_face)
        if (round.count(name) > 0)
          {
            for (const unsigned int v : key)
              {
                const auto &X = mesh.vertices[v];
                if (std::hypot(X[1], X[2]) < tolerance)
                  messages.fail(
                    "Round surfaces",
                    " has the physical surface '" + name +
                      "' on the x axis, at " + point_text(X) +
                      ", and so it cannot be round about it. Remove it "
                      "from the list.");
              }
            mesh.round_faces.insert(key);
          }
    }
  } // namespace



  void
  name_boundaries(const MshFile                  &file,
                  const std::vector<std::string> &round_surfaces,
                  const MeshMessages             &messages,
                  NamedMesh                      &mesh)
  {
    FaceCounts n_cells;
    for (const auto &cell : mesh.cells)
      for (unsigned int f = 0; f < 6; ++f)
        ++n_cells[face_key(cell, f)];

    NameOfFace name_of_face;
    for (const auto &face : file.faces)
      {
        const auto name = file.surface_names.find(face.tag);
        if (name == file.surface_names.end() ||
            n_cells.count(face.vertices) == 0)
          continue;
        const auto &known =
          name_of_face.insert({face.vertices, name->second}).first->second;
        if (known != name->second)
          messages.fail(" has a face in two physical surfaces, '" + known +
                        "' and '" + name->second + "'. Put it into one.");
      }

    name_faces(file, name_of_face, n_cells, messages, mesh);
    check_symmetry_planes(mesh, messages);
    find_round_faces(name_of_face, round_surfaces, messages, mesh);
  }
} // namespace lumbricus
