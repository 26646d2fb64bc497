// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_probes_h
#define lumbricus_output_probes_h

#include <lumbricus/discretization/cell_fields.h>
#include <lumbricus/output/csv_table.h>

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
    /** Find the cells; the points have to pass check(). Collective. */
    Probes(const std::vector<dealii::Point<dim>> &points,
           RunFolder                             &folder,
           const MixedSpace                      &space,
           const CellFields                      &cell_fields);

    /** Throw ExcInput for a point outside the body, on all ranks. Collective.
     */
    static void
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
    /** Where a point lies, on the rank that has it. */
    struct Place
    {
      dealii::Triangulation<dim>::active_cell_iterator cell;
      dealii::Point<dim>                               unit_point;
      bool                                             mine = false;
    };

    static Place
    find(const dealii::Point<dim> &point, const MixedSpace &space);

    const std::vector<dealii::Point<dim>> points;
    const MixedSpace                     &space;
    const CellFields                     &cell_fields;
    std::vector<Place>                    places;
    std::unique_ptr<CsvTable>             table;
  };
} // namespace lumbricus

#endif
