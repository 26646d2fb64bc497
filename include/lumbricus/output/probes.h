// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_probes_h
#define lumbricus_output_probes_h

#include <lumbricus/discretization/cell_fields.h>
#include <lumbricus/output/csv_table.h>
#include <lumbricus/output/nearest_point.h>

#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /** Material points whose displacement and stress are written to a table. */
  class ProbePoints : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** The reference positions [mm]. Throws ExcInput. */
    std::vector<dealii::Point<dim>>
    points() const;

  private:
    std::string list;
  };



  /** The table points.csv. */
  class Probes
  {
  public:
    /** Find the cells; the points have to pass check() on the first mesh.
     * Collective. */
    Probes(const std::vector<dealii::Point<dim>> &points,
           RunFolder                             &folder,
           const MixedSpace                      &space,
           const CellFields                      &cell_fields);

    /**
     * A point that is not in the body stands for the nearest point of the body
     * if that is no further than a tenth of the longest edge of the cell it is
     * in: curved surfaces are not where formulas say. Throws ExcInput for
     * others, on all ranks.
     * @return what to tell the user about those that are not in the body, in
     * lines. Collective.
     */
    static std::string
    check(const std::vector<dealii::Point<dim>> &points,
          const MixedSpace                      &space);

    /** Find the cells anew, after every change of the mesh. Collective. */
    void
    reinit();

    /** Whether there are any. */
    bool
    empty() const;

    /** Null where there are no points. */
    const CsvTable *
    csv_table() const;

    /** Write a row per point. The fields must be those of @p state.
     * Collective. */
    void
    write(const State &state);

  private:
    const std::vector<dealii::Point<dim>> points;
    const MixedSpace                     &space;
    const CellFields                     &cell_fields;
    std::vector<NearestPoint>             places;
    std::unique_ptr<CsvTable>             table;
  };
} // namespace lumbricus

#endif
