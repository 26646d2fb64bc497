// SPDX-License-Identifier: LGPL-2.1-or-later
#include "named_boundaries.h"

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/bounding_box.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>

#include "mesh_cavities.h"
#include "round_axis.h"

namespace lumbricus
{
  namespace
  {
    const std::string free_boundary = "free";

    const std::array<std::string, dim> symmetry_names = {
      {"symmetry x", "symmetry y", "symmetry z"}};



    void
    name_faces(const MshFile                             &file,
               const NameOfFace                          &name_of_face,
               const FaceCounts                          &n_cells,
               const std::map<unsigned int, std::string> &cavities,
               const MeshMessages                        &messages,
               NamedMesh                                 &mesh)
    {
      // The names of the boundary in the order of their tags, then the planes,
      // then the cavities.
      std::set<std::string> used;
      for (const auto &[key, n] : n_cells)
        if (n == 1)
          {
            const auto name = name_of_face.find(key);
            used.insert(name == name_of_face.end() ? free_boundary :
                                                     name->second);
          }
      std::map<std::string, dealii::types::boundary_id> ids;
      std::set<std::string>                             walls;
      for (const auto &entry : cavities)
        walls.insert(entry.second);
      const auto add = [&](const std::string &name) {
        const bool plane =
          std::find(symmetry_names.begin(), symmetry_names.end(), name) !=
          symmetry_names.end();
        if (!plane && walls.count(name) == 0 && used.count(name) > 0 &&
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
      for (const auto &[segment, name] : cavities)
        {
          const dealii::types::boundary_id id =
            mesh.boundary_names.size() + mesh.symmetry_planes.size() +
            mesh.cavities.size();
          ids[name] = id;
          mesh.cavities.push_back({id, segment});
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
          const auto         include = [&](const dealii::Point<dim> &X) {
            least = std::min(least, X[d]);
            most  = std::max(most, X[d]);
          };
          for (const auto &[key, id] : mesh.boundary_ids)
            if (id == plane.boundary)
              for (const unsigned int v : key)
                include(mesh.vertices[v]);
          for (std::size_t c = 0; c < mesh.curved_cells.size(); ++c)
            for (unsigned int f = 0; f < 6; ++f)
              {
                const FaceKey key = face_key(mesh.cells[c], f);
                const auto    id  = mesh.boundary_ids.find(key);
                if (id != mesh.boundary_ids.end() &&
                    id->second == plane.boundary)
                  for (const auto &X : mesh.curved_cells[c].face_nodes(key))
                    include(X);
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



    // A surface of the body of which not all is boundary.
    void
    find_inner_surfaces(const NameOfFace &name_of_face,
                        const FaceCounts &n_cells,
                        NamedMesh        &mesh)
    {
      std::map<std::string, std::array<unsigned int, 3>> n_faces;
      std::map<std::string, dealii::Point<dim>>          first;
      for (const auto &[key, name] : name_of_face)
        {
          const unsigned int n = n_cells.at(key);
          ++n_faces[name][n];
          if (n == 2 && n_faces[name][2] == 1)
            for (const unsigned int v : key)
              first[name] += mesh.vertices[v] / 4.;
        }
      for (const auto &[name, n] : n_faces)
        if (n[2] > 0)
          mesh.inner_surfaces[name] =
            "is a physical surface inside the body: " +
            (n[1] == 0 ? "all" :
                         std::to_string(n[2]) + " of its " +
                           std::to_string(n[1] + n[2])) +
            " faces have cells on both sides, as that at " +
            point_text(first[name]);
    }



    // Throw where a surface would be lost in silence, or a part of it.
    void
    check_faces(const MshFile      &file,
                const FaceCounts   &n_cells,
                const MeshMessages &messages,
                const NamedMesh    &mesh)
    {
      const auto name_of = [&](const unsigned int tag) {
        const auto name = file.surface_names.find(tag);
        return name == file.surface_names.end() ? std::to_string(tag) :
                                                  name->second;
      };
      const auto of_body = [](const auto &corners) {
        return std::find(corners.begin(),
                         corners.end(),
                         dealii::numbers::invalid_unsigned_int) ==
               corners.end();
      };
      const std::string n_nodes = file.shapes.empty() ? "four" :
                                  file.complete     ? "nine" :
                                                      "eight";
      for (const auto &face : file.other_faces)
        if (of_body(face.corners))
          messages.fail(" has " + face.kind + " in its physical surface '" +
                        name_of(face.tag) + "', as at " +
                        point_text(mesh.vertices[face.corners[0]]) +
                        ", but faces of its hexahedra are quadrilaterals of " +
                        n_nodes +
                        " nodes. Mesh the surface with 'Recombine', together "
                        "with the volume.");

      std::set<std::string> names, with_faces;
      for (const auto &face : file.faces)
        {
          names.insert(name_of(face.tag));
          if (n_cells.count(face.vertices) > 0)
            with_faces.insert(name_of(face.tag));
          else if (of_body(face.vertices))
            messages.fail(" has a quadrilateral in its physical surface '" +
                          name_of(face.tag) + "' that is no face of a cell, "
                          "between " +
                          point_text(mesh.vertices[face.vertices[0]]) +
                          " and " +
                          point_text(mesh.vertices[face.vertices[3]]) +
                          ". Mesh surfaces and volumes together.");
        }
      for (const std::string &plane : symmetry_names)
        if (names.count(plane) > 0 && with_faces.count(plane) == 0)
          messages.fail(" has the plane of mirror symmetry '" + plane +
                        "', but no cell has a face in it. Mesh it together "
                        "with the volume it bounds, or remove its name.");
    }



    // Throw where a face is not round about the axis, as the circle about it
    // would bend the body.
    void
    check_round_face(const FaceKey      &key,
                     const std::string  &surface,
                     const RoundAxis    &axis,
                     const MeshMessages &messages,
                     const NamedMesh    &mesh)
    {
      std::array<dealii::Point<dim>, 4> corners;
      double                            size = 0., least = 0., most = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        {
          corners[i] = mesh.vertices[key[i]];
          for (unsigned int j = 0; j < i; ++j)
            size = std::max(size, corners[i].distance(corners[j]));
        }
      for (unsigned int i = 0; i < 4; ++i)
        {
          const double r = axis.radius(corners[i]);
          least          = i == 0 ? r : std::min(least, r);
          most           = std::max(most, r);
          if (r < 1e-6 * size)
            messages.fail("Round surfaces",
                          " has the physical surface '" + surface + "' on " +
                            axis.name + ", at " + point_text(corners[i]) +
                            ", and so it cannot be round about it. Remove it "
                            "from the list, or set 'Round axis'.");
        }

      // Of coordinates with few digits, and of an irregular mesh on a ball.
      constexpr double tolerance_of_radius = 1e-3, tolerance_of_profile = 0.05;
      const auto       deviation = axis.deviation(corners);
      if (deviation.of_radius < tolerance_of_radius &&
          deviation.of_profile < tolerance_of_profile)
        return;
      std::ostringstream message;
      message << " has the physical surface '" << surface
              << "', which is not round about " << axis.name
              << ": the corners of its face at " << point_text(corners[0])
              << " have distances from the axis of " << least << " to " << most
              << " mm, and are "
              << size * std::max(deviation.of_radius, deviation.of_profile)
              << " mm off a surface of revolution. Set 'Round axis' to the "
                 "axis it is round about, or remove the surface from the list.";
      messages.fail("Round surfaces", message.str());
    }



    void
    find_round_faces(const NameOfFace       &name_of_face,
                     const NamedMeshChoices &choices,
                     const MeshMessages     &messages,
                     NamedMesh              &mesh)
    {
      std::set<std::string> names;
      for (const auto &entry : name_of_face)
        names.insert(entry.second);
      messages.check_list("Round surfaces",
                          "physical surface",
                          choices.round_surfaces,
                          names);

      if (!choices.round_surfaces.empty() && !mesh.curved_cells.empty())
        messages.fail("Round surfaces",
                      " has hexahedra of second order, whose nodes say how "
                      "round surfaces are. Leave the list empty.");
      const RoundAxis             axis(messages.section + "/Round axis",
                           choices.round_axis);
      const std::set<std::string> round(choices.round_surfaces.begin(),
                                        choices.round_surfaces.end());
      for (const auto &[key, name] : name_of_face)
        if (round.count(name) > 0)
          {
            check_round_face(key, name, axis, messages, mesh);
            mesh.round_faces.insert(key);
          }
    }
  } // namespace



  void
  name_boundaries(const MshFile          &file,
                  const NamedMeshChoices &choices,
                  const MeshMessages     &messages,
                  NamedMesh              &mesh)
  {
    FaceCounts n_cells;
    for (const auto &cell : mesh.cells)
      for (unsigned int f = 0; f < 6; ++f)
        ++n_cells[face_key(cell, f)];

    check_faces(file, n_cells, messages, mesh);
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

    const auto cavities =
      cavity_names(file, name_of_face, n_cells, messages, mesh);
    name_faces(file, name_of_face, n_cells, cavities, messages, mesh);
    check_symmetry_planes(mesh, messages);
    close_cavities(cavities, messages, mesh);
    find_inner_surfaces(name_of_face, n_cells, mesh);
    find_round_faces(name_of_face, choices, messages, mesh);
  }
} // namespace lumbricus
