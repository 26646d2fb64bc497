// SPDX-License-Identifier: LGPL-2.1-or-later
#include "piston_check.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/mpi.h>

#include <limits>
#include <map>
#include <sstream>
#include <string>

namespace lumbricus
{
  namespace
  {
    // What holds the nodes of the rim of one piston along x, on this rank.
    struct Rim
    {
      std::string                               loose; // a message, if one is
      std::vector<const Supports::Prescribed *> nodes;
    };



    Rim
    rim_of(const dealii::types::boundary_id piston,
           const unsigned int               cavity,
           const Body                      &body,
           const Supports                  &supports)
    {
      std::map<dealii::types::global_dof_index, const Supports::Prescribed *>
        held;
      for (const Supports::Prescribed &entry : supports.prescribed_unknowns())
        if (entry.by == Supports::By::condition)
          held[entry.index] = &entry;
      const auto links = supports.links();

      const MixedSpace  &space = body.space;
      const CavityFaces  cavities(body.anatomy.geometry());
      Rim                rim;
      const auto         names = body.anatomy.geometry().boundary_names();
      std::vector<dealii::types::global_dof_index> indices(
        space.fe.n_dofs_per_cell());
      cavities.for_each(body, [&](const OwnedCell   &cell,
                                  const unsigned int face,
                                  const unsigned int k) {
        if (k != cavity)
          return;
        cell.iterator->get_dof_indices(indices);
        for (const unsigned int f : cell.iterator->face_indices())
          {
            if (!cell.iterator->face(f)->at_boundary() ||
                cell.iterator->face(f)->boundary_id() != piston)
              continue;
            for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
              {
                const unsigned int i     = space.displacement_dof[0][n];
                const auto         found = held.find(indices[i]);
                if (!space.fe.has_support_on_face(i, face) ||
                    !space.fe.has_support_on_face(i, f))
                  continue;
                if (found != held.end())
                  rim.nodes.push_back(found->second);
                // What hangs on others of the rim is as they are.
                else if (!links.is_constrained(indices[i]))
                  rim.loose =
                    "The liquid of the segment " +
                    std::to_string(cell.region.segment + 1) +
                    " has no cells, and a piston over the boundary '" + names[piston] +
                    "' closes it in, but the displacement along x is not "
                    "prescribed there, as at " +
                    point_text(body.shapes.node(cell.index, n)) +
                    ". Give '" + names[piston] +
                    "' a boundary condition of the type 'displacement' whose "
                    "'Components' have x.";
              }
          }
      });
      return rim;
    }
  } // namespace



  void
  check_pistons(const Body                &body,
                const Supports            &supports,
                const std::vector<double> &times)
  {
    const Geometry &geometry = body.anatomy.geometry();
    const MPI_Comm  comm     = body.space.communicator();
    const auto      walls    = geometry.cavities();
    for (unsigned int k = 0; k < walls.size(); ++k)
      for (const auto piston : walls[k].pistons)
        {
          const Rim rim = rim_of(piston, k, body, supports);
          throw_on_all_ranks<ExcInput>(rim.loose, comm);

          // The largest of u_x and of -u_x, at all times.
          std::vector<double> largest(2 * times.size(),
                                      -std::numeric_limits<double>::max());
          for (const Supports::Prescribed *node : rim.nodes)
            for (unsigned int i = 0; i < times.size(); ++i)
              {
                const double u = node->condition->value(0, node->X, times[i]);
                largest[2 * i]     = std::max(largest[2 * i], u);
                largest[2 * i + 1] = std::max(largest[2 * i + 1], -u);
              }
          dealii::Utilities::MPI::max(largest, comm, largest);
          for (unsigned int i = 0; i < times.size(); ++i)
            if (largest[2 * i] + largest[2 * i + 1] >
                1e-9 * geometry.characteristic_length())
              {
                std::ostringstream message;
                message << "The displacements along x that are prescribed at "
                           "the boundary '"
                        << geometry.boundary_names()[piston]
                        << "' are not the same all over it: at time "
                        << times[i] << " they reach from "
                        << -largest[2 * i + 1] << " to " << largest[2 * i]
                        << " mm, but the piston that closes in the liquid of "
                           "the segment "
                        << walls[k].segment + 1
                        << " stays plane. Let them depend on t only, or mesh "
                           "the liquid.";
                AssertThrow(false, ExcInput(message.str()));
              }
        }
  }
} // namespace lumbricus
