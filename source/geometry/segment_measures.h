// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_segment_measures_h
#define lumbricus_geometry_segment_measures_h

#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <vector>

#include "measure_table.h"

namespace lumbricus
{
  /** The measures of one segment of a chain. */
  struct SegmentMeasures
  {
    /** Inner radius of the wall [mm]. */
    double radius;
    /** Length of the liquid chamber, between septa or caps [mm]. */
    double length;
    /** Thickness of the septum towards the tail [mm], half of which belongs to
     * the next segment. */
    double septum_thickness;
    /** Of the layers of the wall, from inside to outside [mm]. */
    std::vector<double> layer_thicknesses;
    /** What is in the chamber: "meshed", or "cavity" where no cells are. */
    std::string liquid;
  };



  /**
   * The measures along a chain: formulas in the number s of the segment, from 1
   * at the head, and the number n of segments. Declared once for the whole
   * chain, and once for every range of segments that has its own.
   */
  class MeasureFormulas : public ParameterOwner
  {
  public:
    /** Declare with the present formulas as defaults. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Throws ExcParameter where a formula has a place or a time in it. */
    void
    check_parameters() const override;

    /** The columns that a table of measures may have: those of the entries, and
     * @p layer_names. */
    std::vector<std::string>
    names(const std::vector<std::string> &layer_names) const;

    /** How many layers have a thickness. */
    unsigned int
    n_layers() const
    {
      return layers.size();
    }

    /**
     * The measures of segment @p s, from 1, of @p n. Where a formula is that of
     * @p chain too, those of the chain, @p in_chain, are taken. Throws
     * ExcParameter where one is not a number greater than zero.
     */
    SegmentMeasures
    of(const unsigned int     s,
       const unsigned int     n,
       const MeasureFormulas &chain,
       const SegmentMeasures &in_chain) const;

    /**
     * The same for the chain itself, where the columns of @p table, if they are
     * there, stand in place of the formulas; those of layers have the names
     * @p layer_names.
     */
    SegmentMeasures
    of(const unsigned int              s,
       const unsigned int              n,
       const MeasureTable             &table,
       const std::vector<std::string> &layer_names) const;

  private:
    /** Formulas separated by commas that are not inside of parentheses. */
    static std::vector<Expression>
    parse_layers(const std::string &text);

    Expression              radius           = {"Radius", "2", {{"s", 1.}, {"n", 1.}}};
    Expression              length           = {"Segment length", "2", {{"s", 1.}, {"n", 1.}}};
    Expression              septum_thickness = {"Septum thickness", "0.1", {{"s", 1.}, {"n", 1.}}};
    std::string             layers_text      = "0.15, 0.15";
    std::vector<Expression> layers           = parse_layers(layers_text);
    std::string             liquid           = "meshed";
  };
} // namespace lumbricus

#endif
