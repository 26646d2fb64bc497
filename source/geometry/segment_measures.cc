// SPDX-License-Identifier: LGPL-2.1-or-later
#include "segment_measures.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <optional>

namespace lumbricus
{
  namespace
  {
    const std::string layers_entry = "Wall layer thicknesses";

    const std::string in_segments =
      " A formula in the number s of the segment, from 1 at the head, and the "
      "number n of segments.";



    // That of segment s, which has to be a length; of a column of a table.
    double
    positive(const double       value,
             const std::string &entry,
             const unsigned int s,
             const std::string &column = "")
    {
      AssertThrow(value >= 1e-100 && value <= 1e100,
                  ExcParameter(entry,
                               (column.empty() ? "is " :
                                                 ": '" + column + "' is ") + dealii::Utilities::to_string(value) +
                                 " mm for segment " + std::to_string(s) +
                                 ", but has to be a number > 0."));
      return value;
    }



    // That of a formula.
    double
    evaluate(const Expression  &formula,
             const unsigned int s,
             const unsigned int n)
    {
      return positive(formula.with({{"s", double(s)}, {"n", double(n)}})
                        .value(dealii::Point<dim>(), 0.),
                      formula.parameter(),
                      s);
    }
  } // namespace



  void
  MeasureFormulas::declare_parameters(dealii::ParameterHandler &prm)
  {
    radius.declare_parameter(prm,
                             "[mm] Radius of the liquid chamber, which is the "
                             "inner radius of the wall." +
                               in_segments);
    length.declare_parameter(prm,
                             "[mm] Length of the liquid chamber along the axis, "
                             "between the septa or caps that close it." +
                               in_segments);
    prm.declare_entry(layers_entry,
                      layers_text,
                      dealii::Patterns::Anything(),
                      "[mm] Thickness of each layer of the wall, from inside "
                      "to outside, separated by commas. Formulas in s and n.");
    prm.add_action(layers_entry, [this](const std::string &text) {
      layers_text = text;
      layers      = parse_layers(text);
    });
    septum_thickness.declare_parameter(
      prm,
      "[mm] Thickness of the septum behind the segment, towards "
      "the tail. Its front half belongs to this segment, its "
      "rear half to the next. Where neighbours differ in radius "
      "or wall, the septum is where one changes into the other." +
        in_segments);
    prm.add_parameter("Liquid",
                      liquid,
                      "What is in the chamber. 'meshed': cells of the tissue "
                      "'liquid', a soft rubber that is reset. 'cavity': no "
                      "cells, but one pressure, see Cavities.",
                      dealii::Patterns::Selection("meshed|cavity"));
  }



  void
  MeasureFormulas::check_parameters() const
  {
    std::vector<const Expression *> all = {&radius, &length, &septum_thickness};
    for (const Expression &layer : layers)
      all.push_back(&layer);
    for (const Expression *formula : all)
      AssertThrow(!formula->depends_on_place() && !formula->depends_on_time(),
                  ExcParameter(formula->parameter(),
                               "is '" + formula->formula() +
                                 "', but a segment has one measure, at rest. "
                                 "Use s and n."));
  }



  std::vector<Expression>
  MeasureFormulas::parse_layers(const std::string &text)
  {
    std::vector<Expression> result;
    std::string             formula;
    int                     depth = 0;
    for (const char c : text + ',')
      {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth <= 0)
          {
            result.emplace_back(layers_entry,
                                dealii::Utilities::trim(formula),
                                Expression::Constants{{"s", 1.}, {"n", 1.}});
            formula.clear();
          }
        else
          formula += c;
      }
    // A parenthesis that is not closed.
    if (!formula.empty())
      result.emplace_back(layers_entry,
                          formula,
                          Expression::Constants{{"s", 1.}, {"n", 1.}});
    return result;
  }



  std::vector<std::string>
  MeasureFormulas::names(const std::vector<std::string> &layer_names) const
  {
    std::vector<std::string> all = {radius.parameter(),
                                    length.parameter(),
                                    septum_thickness.parameter()};
    all.insert(all.end(), layer_names.begin(), layer_names.end());
    return all;
  }



  SegmentMeasures
  MeasureFormulas::of(const unsigned int     s,
                      const unsigned int     n,
                      const MeasureFormulas &chain,
                      const SegmentMeasures &in_chain) const
  {
    const auto value = [&](const Expression &own,
                           const Expression &common,
                           const double      in_common) {
      return own.formula() == common.formula() ? in_common :
                                                 evaluate(own, s, n);
    };
    SegmentMeasures result  = in_chain;
    result.radius           = value(radius, chain.radius, in_chain.radius);
    result.length           = value(length, chain.length, in_chain.length);
    result.septum_thickness = value(septum_thickness,
                                    chain.septum_thickness,
                                    in_chain.septum_thickness);
    for (unsigned int i = 0; i < layers.size(); ++i)
      result.layer_thicknesses[i] = value(layers[i],
                                          chain.layers[i],
                                          in_chain.layer_thicknesses[i]);
    result.liquid = liquid;
    return result;
  }



  SegmentMeasures
  MeasureFormulas::of(const unsigned int              s,
                      const unsigned int              n,
                      const MeasureTable             &table,
                      const std::vector<std::string> &layer_names) const
  {
    const auto value = [&](const Expression &formula, const std::string &column) {
      const std::optional<double> in_table = table.value(column, s, n);
      return in_table ? positive(*in_table, MeasureTable::entry, s, column) :
                        evaluate(formula, s, n);
    };
    SegmentMeasures result{value(radius, radius.parameter()),
                           value(length, length.parameter()),
                           value(septum_thickness,
                                 septum_thickness.parameter()),
                           {},
                           liquid};
    for (unsigned int i = 0; i < layers.size(); ++i)
      result.layer_thicknesses.push_back(value(layers[i], layer_names[i]));
    return result;
  }
} // namespace lumbricus
