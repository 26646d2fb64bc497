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
    // What is summed over the faces of a segment's sections: at most quadratic in
    // the displacements of a cell.
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



    // The faces of the mesh that lie in sections.
    class SectionFaces
    {
    public:
      explicit SectionFaces(const Body &body)
        : body(body)
        , face_values(body.space.mapping,
                      body.space.fe,
                      body.space.face_quadrature,
                      dealii::update_values | dealii::update_gradients |
                        dealii::update_quadrature_points |
                        dealii::update_normal_vectors |
                        dealii::update_JxW_values)
        , u(body.space.face_quadrature.size())
        , grad_u(body.space.face_quadrature.size())
        , indices(body.space.fe.n_dofs_per_cell())
        , cell_solution(body.space.fe.n_dofs_per_cell())
      {}

      // Call f(cell, its solution) for each, ready for add().
      template <typename Function>
      void
      for_each(const Vector &relevant_solution, const Function &f)
      {
        const Geometry &geometry   = body.anatomy.geometry();
        const auto      sections   = geometry.sections();
        const auto      tissues    = geometry.tissues();
        const double    tolerance  = plane_tolerance(geometry);
        const bool      has_liquid = body.anatomy.has_liquid();

        // Where there is no liquid that has cells, its edge says as much.
        std::vector<bool> has_cavity(sections.size(), false);
        for (const CavityWall &cavity : geometry.cavities())
          has_cavity[cavity.segment] = true;
        for (const OwnedCell cell : body.owned_cells())
          {
            const SegmentSections &section = sections[cell.region.segment];
            const bool wall       = tissues[cell.region.tissue].wall_layer;
            const bool may_middle = cell.is_liquid == has_liquid &&
                                    !has_cavity[cell.region.segment];
            for (const auto &face : cell.iterator->face_iterators())
              {
                const double     x  = face->center()[0];
                const EndSection of = end_section(section, x, tolerance);
                end    = wall ? of : EndSection::none;
                middle = may_middle &&
                         std::abs(x - section.middle) < tolerance &&
                         cell.iterator->center()[0] < section.middle;
                if (end == EndSection::none && !middle)
                  continue;

                face_values.reinit(mesh_cell(cell.iterator), face);
                cell.iterator->get_dof_indices(indices);
                for (unsigned int i = 0; i < indices.size(); ++i)
                  cell_solution[i] = relevant_solution(indices[i]);
                f(cell, cell_solution);
              }
          }
      }

      // Add what the face at hand adds where its cell has this solution.
      void
      add(const std::vector<double> &of_cell, Sums &sum)
      {
        const auto &displacement = face_values[body.space.displacement];
        displacement.get_function_values_from_local_dof_values(of_cell, u);
        displacement.get_function_gradients_from_local_dof_values(of_cell,
                                                                  grad_u);
        for (unsigned int q = 0; q < u.size(); ++q)
          {
            const double dA = face_values.JxW(q);
            if (end != EndSection::none)
              {
                const bool at_end = end == EndSection::end;
                sum.position[at_end] +=
                  (face_values.quadrature_point(q) + u[q]) * dA;
                sum.area[at_end] += dA;
              }
            if (middle)
              {
                const dealii::Tensor<2, dim> F =
                  grad_u[q] + dealii::unit_symmetric_tensor<dim, double>();
                sum.middle +=
                  determinant(F) *
                  (transpose(invert(F)) * face_values.normal_vector(q)) * dA;
              }
          }
      }

    private:
      const Body                                   body;
      dealii::FEFaceValues<dim>                    face_values;
      std::vector<dealii::Tensor<1, dim>>          u;
      std::vector<dealii::Tensor<2, dim>>          grad_u;
      std::vector<dealii::types::global_dof_index> indices;
      std::vector<double>                          cell_solution;
      EndSection                                   end = EndSection::none;
      bool                                         middle = false;
    };



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


    // What all faces and edges in the sections of each segment add up to.
    std::vector<Sums>
    section_sums(const Body &body, const Vector &relevant_solution)
    {
      const Geometry   &geometry = body.anatomy.geometry();
      std::vector<Sums> sums(geometry.sections().size());
      SectionFaces      faces(body);
      faces.for_each(relevant_solution,
                     [&](const OwnedCell           &cell,
                         const std::vector<double> &of_cell) {
                       faces.add(of_cell, sums[cell.region.segment]);
                     });
      sum_over_ranks(sums, body.space.communicator());
      const auto cavities    = geometry.cavities();
      const auto of_cavities = cavity_sections(body, relevant_solution);
      for (unsigned int k = 0; k < of_cavities.size(); ++k)
        sums[cavities[k].segment].middle = of_cavities[k];
      return sums;
    }



    // What they make of a segment. Mirror images cancel what is normal to a plane
    // of symmetry.
    class SectionsOfSegment
    {
    public:
      SectionsOfSegment(const Geometry &geometry, const Sums &sum)
        : begin(sum.position[0] / sum.area[0])
        , end(sum.position[1] / sum.area[1])
        , area{sum.area[0], sum.area[1]}
        , axis(along(geometry, end - begin))
        , middle(along(geometry, sum.middle))
      {
        for (const SymmetryPlane &plane : geometry.symmetry_planes())
          if (plane.direction != 0)
            images *= 2.;
      }

      SectionMeasures
      measures() const
      {
        return {axis.norm(), radius(), begin[0], end[0], axis};
      }

      // How much more of length, and of the middle radius, small sums add.
      double
      length_of(const Sums &more) const
      {
        return axis * (more.position[1] / area[1] - more.position[0] / area[0]) /
               axis.norm();
      }

      double
      radius_of(const Sums &more) const
      {
        return middle.norm() > 0. ? images * (middle * more.middle) /
                                      (2. * dealii::numbers::PI *
                                       middle.norm() * radius()) :
                                    0.;
      }

    private:
      static dealii::Tensor<1, dim>
      along(const Geometry &geometry, dealii::Tensor<1, dim> vector)
      {
        for (const SymmetryPlane &plane : geometry.symmetry_planes())
          if (plane.direction != 0)
            vector[plane.direction] = 0.;
        return vector;
      }

      double
      radius() const
      {
        const double section = images * middle.norm();
        return section > 0. ? std::sqrt(section / dealii::numbers::PI) :
                              std::numeric_limits<double>::quiet_NaN();
      }

      const dealii::Tensor<1, dim> begin, end;
      const double                 area[2];
      const dealii::Tensor<1, dim> axis, middle;
      double                       images = 1.;
    };
  } // namespace



  std::vector<SectionMeasures>
  section_measures(const Body &body, const Vector &relevant_solution)
  {
    std::vector<SectionMeasures> measures;
    for (const Sums &sum : section_sums(body, relevant_solution))
      measures.push_back(
        SectionsOfSegment(body.anatomy.geometry(), sum).measures());
    return measures;
  }



  Vector
  section_derivative(const Body                &body,
                     const CellUnknowns        &unknowns,
                     const std::vector<double> &of_lengths,
                     const std::vector<double> &of_radii,
                     const Vector              &relevant_solution)
  {
    const MixedSpace              &space = body.space;
    const Geometry                &geometry = body.anatomy.geometry();
    std::vector<SectionsOfSegment> segments;
    for (const Sums &sum : section_sums(body, relevant_solution))
      segments.emplace_back(geometry, sum);
    const auto more = [&](const unsigned int s, const Sums &sum) {
      return (of_lengths[s] != 0. ? of_lengths[s] * segments[s].length_of(sum) :
                                    0.) +
             (of_radii[s] != 0. ? of_radii[s] * segments[s].radius_of(sum) : 0.);
    };

    // Differences of quadratic sums are exact, whatever their size.
    const double h = 1e-3 * geometry.characteristic_length();
    Vector       derivative;
    unknowns.reinit_vector(derivative);
    SectionFaces faces(body);
    faces.for_each(
      relevant_solution,
      [&](const OwnedCell &cell, std::vector<double> &of_cell) {
        const unsigned int s = cell.region.segment;
        if (of_lengths[s] == 0. && of_radii[s] == 0.)
          return;
        std::array<double, CellUnknowns::n_per_cell> by_unknown = {};
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              double      &entry = of_cell[space.displacement_dof[c][n]];
              const double value = entry;
              Sums         ahead, behind;
              entry = value + h;
              faces.add(of_cell, ahead);
              entry = value - h;
              faces.add(of_cell, behind);
              entry = value;
              by_unknown[CellUnknowns::displacement(c, n)] =
                (more(s, ahead) - more(s, behind)) / (2. * h);
            }
        unknowns.add(cell.index, by_unknown.data(), derivative);
      });

    // Of chambers without cells: the edges of their walls.
    const auto cavities = geometry.cavities();
    for_each_section_line(
      body,
      relevant_solution,
      [&](const OwnedCell &cell, const unsigned int k, SectionLine line) {
        const unsigned int s = cavities[k].segment;
        if (of_radii[s] == 0.)
          return;
        std::array<double, CellUnknowns::n_per_cell> by_unknown = {};
        for (unsigned int i = 0; i < line.nodes.size(); ++i)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double value = line.x[i][c];
              Sums         difference;
              line.x[i][c]      = value + h;
              difference.middle = line.area();
              line.x[i][c]      = value - h;
              difference.middle -= line.area();
              line.x[i][c] = value;
              by_unknown[CellUnknowns::displacement(c, line.nodes[i])] =
                more(s, difference) / (2. * h);
            }
        unknowns.add(cell.index, by_unknown.data(), derivative);
      });
    derivative.compress(dealii::VectorOperation::add);
    return derivative;
  }
} // namespace lumbricus
