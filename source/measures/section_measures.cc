// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/measures/section_measures.h>

#include <deal.II/base/numbers.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace
  {
    // What is summed over the faces of a segment's sections.
    struct Sums
    {
      dealii::Tensor<1, dim> position[2]; // at its begin and end, times area
      double                 area[2] = {0., 0.};
      dealii::Tensor<1, dim> middle; // vector area
    };



    // Which end section of its segment a face of the wall is in, if it is in one.
    enum class EndSection
    {
      none,
      begin,
      end
    };



    EndSection
    end_section(const SegmentSections &section,
                const double           x,
                const double           tolerance)
    {
      return std::abs(x - section.begin) < tolerance ? EndSection::begin :
             std::abs(x - section.end) < tolerance   ? EndSection::end :
                                                       EndSection::none;
    }



    double
    plane_tolerance(const Geometry &geometry)
    {
      return 1e-9 * geometry.characteristic_length();
    }



    // Reduce over the ranks, all segments at once.
    void
    sum_over_ranks(std::vector<Sums> &sums, const MPI_Comm comm)
    {
      std::vector<double> flat;
      for (const Sums &s : sums)
        {
          flat.insert(flat.end(), {s.area[0], s.area[1]});
          for (const auto &v : {s.position[0], s.position[1], s.middle})
            for (unsigned int i = 0; i < dim; ++i)
              flat.push_back(v[i]);
        }
      dealii::Utilities::MPI::sum(flat, comm, flat);
      const double *entry = flat.data();
      for (Sums &s : sums)
        {
          s.area[0] = *entry++;
          s.area[1] = *entry++;
          for (auto *v : {&s.position[0], &s.position[1], &s.middle})
            for (unsigned int i = 0; i < dim; ++i)
              (*v)[i] = *entry++;
        }
    }
  } // namespace



  std::vector<SectionMeasures>
  section_measures(const Body &body, const Vector &relevant_solution)
  {
    const MixedSpace &space      = body.space;
    const Geometry   &geometry   = body.anatomy.geometry();
    const auto        sections   = geometry.sections();
    const auto        tissues    = geometry.tissues();
    const double      tolerance  = plane_tolerance(geometry);
    const bool        has_liquid = body.anatomy.has_liquid();

    dealii::FEFaceValues<dim> face_values(space.mapping,
                                          space.fe,
                                          space.face_quadrature,
                                          dealii::update_values |
                                            dealii::update_gradients |
                                            dealii::update_quadrature_points |
                                            dealii::update_normal_vectors |
                                            dealii::update_JxW_values);
    const unsigned int        n_dofs = space.fe.n_dofs_per_cell();
    std::vector<dealii::types::global_dof_index> indices(n_dofs);
    std::vector<double>                          cell_solution(n_dofs);
    std::vector<dealii::Tensor<1, dim>> u(space.face_quadrature.size());
    std::vector<dealii::Tensor<2, dim>> grad_u(space.face_quadrature.size());

    // Where there is no liquid that has cells, its edge says as much.
    std::vector<Sums> sums(sections.size());
    std::vector<bool> has_cavity(sections.size(), false);
    const auto cavities = geometry.cavities();
    for (const CavityWall &cavity : cavities)
      has_cavity[cavity.segment] = true;
    for (const OwnedCell cell : body.owned_cells())
      {
        const SegmentSections &section = sections[cell.region.segment];
        Sums                  &sum     = sums[cell.region.segment];
        const bool             wall    = tissues[cell.region.tissue].wall_layer;
        const bool             middle  = cell.is_liquid == has_liquid &&
                             !has_cavity[cell.region.segment];
        for (const auto &face : cell.iterator->face_iterators())
          {
            const double     x  = face->center()[0];
            const EndSection of = end_section(section, x, tolerance);
            const bool at_begin = wall && of == EndSection::begin;
            const bool at_end   = wall && of == EndSection::end;
            const bool at_middle = middle &&
                                   std::abs(x - section.middle) < tolerance &&
                                   cell.iterator->center()[0] < section.middle;
            if (!at_begin && !at_end && !at_middle)
              continue;

            face_values.reinit(mesh_cell(cell.iterator), face);
            cell.iterator->get_dof_indices(indices);
            for (unsigned int i = 0; i < n_dofs; ++i)
              cell_solution[i] = relevant_solution(indices[i]);
            const auto &displacement = face_values[space.displacement];
            displacement.get_function_values_from_local_dof_values(
              cell_solution, u);
            displacement.get_function_gradients_from_local_dof_values(
              cell_solution, grad_u);
            for (unsigned int q = 0; q < u.size(); ++q)
              {
                const double dA = face_values.JxW(q);
                if (at_begin || at_end)
                  {
                    sum.position[at_end] +=
                      (face_values.quadrature_point(q) + u[q]) * dA;
                    sum.area[at_end] += dA;
                  }
                if (at_middle)
                  {
                    const dealii::Tensor<2, dim> F =
                      grad_u[q] + dealii::unit_symmetric_tensor<dim, double>();
                    sum.middle +=
                      determinant(F) *
                      (transpose(invert(F)) * face_values.normal_vector(q)) *
                      dA;
                  }
              }
          }
      }
    sum_over_ranks(sums, space.communicator());
    const auto of_cavities = cavity_sections(body, relevant_solution);
    for (unsigned int k = 0; k < of_cavities.size(); ++k)
      sums[cavities[k].segment].middle = of_cavities[k];

    // The mirror images cancel what is normal to a plane of symmetry.
    std::vector<SectionMeasures> measures;
    for (Sums &sum : sums)
      {
        const auto             begin = sum.position[0] / sum.area[0];
        const auto             end   = sum.position[1] / sum.area[1];
        dealii::Tensor<1, dim> axis  = end - begin;
        double images = 1.;
        for (const SymmetryPlane &plane : geometry.symmetry_planes())
          if (plane.direction != 0)
            {
              axis[plane.direction]       = 0.;
              sum.middle[plane.direction] = 0.;
              images *= 2.;
            }
        const double area = images * sum.middle.norm();
        measures.push_back({axis.norm(),
                            area > 0. ?
                              std::sqrt(area / dealii::numbers::PI) :
                              std::numeric_limits<double>::quiet_NaN(),
                            begin[0],
                            end[0],
                            axis});
      }
    return measures;
  }



  Vector
  length_derivative(const Body                      &body,
                    const CellUnknowns              &unknowns,
                    const std::vector<unsigned int> &segments,
                    const Vector                    &relevant_solution)
  {
    // int N dA of a face in an end section.
    struct EndFace
    {
      unsigned int                              cell, segment;
      bool                                      at_end;
      std::array<double, MixedSpace::n_nodes> weights = {};
    };

    const MixedSpace         &space     = body.space;
    const Geometry           &geometry  = body.anatomy.geometry();
    const auto                sections  = geometry.sections();
    const auto                tissues   = geometry.tissues();
    const double              tolerance = plane_tolerance(geometry);
    dealii::FEFaceValues<dim> face_values(space.mapping,
                                          space.fe,
                                          space.face_quadrature,
                                          dealii::update_values |
                                            dealii::update_JxW_values);
    std::vector<EndFace>      faces;
    std::vector<double>       areas(2 * sections.size(), 0.);
    for (const OwnedCell cell : body.owned_cells())
      if (tissues[cell.region.tissue].wall_layer)
        for (const auto &face : cell.iterator->face_iterators())
          {
            const unsigned int s  = cell.region.segment;
            const EndSection   of = end_section(sections[s],
                                              face->center()[0],
                                              tolerance);
            if (of == EndSection::none)
              continue;
            face_values.reinit(mesh_cell(cell.iterator), face);
            EndFace at{cell.index, s, of == EndSection::end};
            for (unsigned int q = 0; q < space.face_quadrature.size(); ++q)
              {
                for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                  at.weights[n] +=
                    face_values.shape_value(space.displacement_dof[0][n], q) *
                    face_values.JxW(q);
                areas[2 * s + at.at_end] += face_values.JxW(q);
              }
            faces.push_back(at);
          }
    dealii::Utilities::MPI::sum(areas, space.communicator(), areas);

    const auto measures = section_measures(body, relevant_solution);
    Vector     derivative;
    unknowns.reinit_vector(derivative);
    for (const EndFace &face : faces)
      {
        if (std::find(segments.begin(), segments.end(), face.segment) ==
            segments.end())
          continue;
        const SectionMeasures &measure = measures[face.segment];
        const double           factor =
          (face.at_end ? 1. : -1.) /
          (measure.length * areas[2 * face.segment + face.at_end]);
        std::array<double, CellUnknowns::n_per_cell> of_cell = {};
        for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
          for (unsigned int c = 0; c < dim; ++c)
            of_cell[CellUnknowns::displacement(c, n)] =
              factor * face.weights[n] * measure.axis[c];
        unknowns.add(face.cell, of_cell.data(), derivative);
      }
    derivative.compress(dealii::VectorOperation::add);
    return derivative;
  }
} // namespace lumbricus
