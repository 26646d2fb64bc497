// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_cavity_measures_h
#define lumbricus_measures_cavity_measures_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What State::globals calls the pressures of the chambers without cells, in
   * the order of Geometry::cavities() [N/mm^2]. */
  extern const std::string cavity_pressure;

  /** A piece of the curve in which the section in the middle of a segment meets the
   * wall around a cavity: a line of three nodes of a cell, the second halfway. */
  struct SectionLine
  {
    /** Which of the cell's nodes. */
    std::array<unsigned int, 3> nodes;
    /** Where they are now [mm]. */
    std::array<dealii::Tensor<1, dim>, 3> x;
    /** Whether they go around the axis as a screw does that goes to the tail. */
    bool forwards;

    /** Its part of the area vector of the section, 1/2 int x X dx [mm^2]. */
    dealii::Tensor<1, dim>
    area() const;
  };



  /** What is called with an owned cell, the number of the cavity, and a line. */
  using AtSectionLine = std::function<
    void(const OwnedCell &, const unsigned int, const SectionLine &)>;

  /** Call @p f for all lines of this rank, at @p relevant_solution, a ghosted
   * vector. */
  void
  for_each_section_line(const Body          &body,
                        const Vector        &relevant_solution,
                        const AtSectionLine &f);

  /**
   * For every cavity the area vector of its section in the middle of its segment,
   * as the curve in which that meets the wall has it,
   *
   *   1/2 int x X dx  [mm^2],
   *
   * of the part that is computed and but for what lies in planes of symmetry,
   * towards the tail, at @p relevant_solution, a ghosted vector. Zero where no
   * edges of the mesh lie there. Collective.
   */
  std::vector<dealii::Tensor<1, dim>>
  cavity_sections(const Body &body, const Vector &relevant_solution);

  /** The volume of every cavity, of the part that is computed, at
   * @p relevant_solution, a ghosted vector [mm^3]. Collective. */
  std::vector<double>
  cavity_volumes(const Body &body, const Vector &relevant_solution);

  /** The derivative of the sum of the volumes of the cavities of @p segments, from
   * zero, each once, by the free unknowns [mm^2], at @p relevant_solution, a
   * ghosted vector. Collective. */
  Vector
  cavity_volume_derivative(const Body                      &body,
                           const CellUnknowns              &unknowns,
                           const std::vector<unsigned int> &segments,
                           const Vector                    &relevant_solution);
} // namespace lumbricus

#endif
