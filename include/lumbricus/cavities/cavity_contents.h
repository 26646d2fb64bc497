// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavity_contents_h
#define lumbricus_cavities_cavity_contents_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/cavities/cavity_exchange.h>
#include <lumbricus/core/load_curve.h>
#include <lumbricus/geometry/segment_ranges.h>
#include <lumbricus/parameters/named_sections.h>
#include <lumbricus/parameters/registry.h>

#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What is in the chambers without cells, and what flows between them: the
   * section Cavities. */
  class CavityContents : public ParameterOwner
  {
  public:
    /** Of the body @p anatomy, which is kept by reference. */
    explicit CavityContents(const Anatomy &anatomy);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    /** Also that there are such chambers, where anything else was chosen for
     * them than what they have anyway. */
    void
    check_parameters() const override;

    /** When all has been read. Throws ExcInput. */
    void
    initialize();

    /** Try all expressions at @p times, and that a pore has a cavity on either
     * side, and contents that can flow. Throws ExcInput. */
    void
    try_expressions(const std::vector<double> &times) const;

    /** All expressions over time. */
    std::vector<LoadCurve>
    load_curves() const;

    /** What is in the cavity of segment @p segment, from zero. */
    const CavityContent &
    content(const unsigned int segment) const;

    /** What flows. */
    const CavityExchange &
    exchange() const
    {
      return flows;
    }

  private:
    /** Of some segments; made with the name of the section. */
    struct Own : public Choice<CavityContent>
    {
      explicit Own(const std::string & /*name*/)
        : Own()
      {}

      Own();
    };

    std::vector<SegmentRange>
    ranges() const;

    /** The choice for a segment, and the section of what was chosen. */
    struct Chosen
    {
      const Own  *choice = nullptr;
      std::string section;
    };

    /** Throws ExcParameter where something flows at time @p t that cannot. */
    void
    check_flows(const double t) const;

    /** Call @p function(expression, section, segment) for all that is there. */
    void
    for_each_expression(
      const std::function<void(const SegmentExpression &,
                               const std::string &,
                               const unsigned int)> &function) const;

    const Anatomy     &anatomy;
    Own                common;
    std::string        range_list;
    NamedSections<Own> own;
    CavityExchange     flows;

    /** By segment; without a choice where it has no cavity. */
    std::vector<Chosen> of_segment;
  };
} // namespace lumbricus

#endif
