// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_contents.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/terms/tried_expressions.h>

namespace lumbricus
{
  namespace
  {
    const std::string own_section  = "Cavities";
    const std::string content_name = "Content";
    const std::string default_name = "liquid";
    const std::string ranges_name  = "Segments with their own content";
  } // namespace



  CavityContents::Own::Own()
    : Choice(content_name,
             default_name,
             "What is in the chambers that have no cells inside.")
  {}



  CavityContents::CavityContents(const Anatomy &anatomy)
    : anatomy(anatomy)
  {}



  void
  CavityContents::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(own_section);
    common.declare_parameters(prm);
    prm.add_parameter(
      ranges_name,
      range_list,
      "[numbers] Segments whose chambers have something else inside than the "
      "others: a list of numbers and ranges like '1, 8-10'. Each item has a "
      "section ('Segment 1', 'Segments 8-10') with a Content.");
    flows.declare_parameters(prm);
    prm.leave_subsection();
  }



  bool
  CavityContents::extend_parameters(dealii::ParameterHandler &prm,
                                    const Extent              extent)
  {
    std::vector<std::string> names;
    for (const SegmentRange &range : ranges())
      names.push_back(range.name());
    prm.enter_subsection(own_section);
    bool extended = common.extend_parameters(prm, extent);
    extended |=
      own.extend_parameters(prm, extent, names, SegmentRange{8, 10}.name());
    prm.leave_subsection();
    return extended;
  }



  void
  CavityContents::check_parameters() const
  {
    within_section(own_section, [&]() {
      common.check_parameters();
      own.check_parameters();
    });
    const Geometry          &geometry = anatomy.geometry();
    const std::string        path     = own_section + "/" + ranges_name;
    const auto               all      = ranges();
    const auto               range_of =
      range_of_segments(path, all, geometry.n_segments());
    std::vector<bool> is_cavity(geometry.n_segments(), false);
    for (const CavityWall &wall : geometry.cavities())
      is_cavity[wall.segment] = true;
    for (unsigned int s = 0; s < range_of.size(); ++s)
      AssertThrow(range_of[s] == all.size() || is_cavity[s],
                  ExcParameter(path,
                               "has segment " + std::to_string(s + 1) +
                                 ", but its chamber is no cavity. Take it out "
                                 "of the list, or let it be one, as by "
                                 "'Geometry/segment chain/Liquid' = "
                                 "'cavity'."));
    if (!geometry.cavities().empty())
      return;
    const auto complain = [&](const std::string &entry,
                              const std::string &value) {
      AssertThrow(false,
                  ExcParameter(own_section + "/" + entry,
                               "is '" + value +
                                 "', but the body has no chamber without "
                                 "cells. Let a segment chain have them: "
                                 "'Geometry/segment chain/Liquid' = "
                                 "'cavity'."));
    };
    if (common.chosen_name() != default_name)
      complain(content_name, common.chosen_name());
    for (const SegmentExpression *flow : flows.expressions())
      if (flow->text() != "0")
        complain(flow->parameter(), flow->text());
  }



  void
  CavityContents::initialize()
  {
    const Geometry &geometry = anatomy.geometry();
    common.get()->initialize(common.section_in(own_section), geometry);
    for (unsigned int i = 0; i < own.size(); ++i)
      own[i].get()->initialize(own[i].section_in(own_section), geometry);
    flows.initialize(geometry);
    of_segment.assign(geometry.n_segments(), Chosen());
    for (const CavityWall &wall : geometry.cavities())
      of_segment[wall.segment] = {&common, common.section_in(own_section)};
    for (const SegmentRange &range : ranges())
      for (unsigned int s = range.first - 1; s < range.last; ++s)
        {
          const Own *choice = own.find(range.name());
          of_segment[s]     = {choice,
                               choice->section_in(own_section + "/" +
                                                  range.name())};
        }
  }



  void
  CavityContents::try_expressions(const std::vector<double> &times) const
  {
    for_each_expression([&](const SegmentExpression &expression,
                            const std::string       &section,
                            const unsigned int       segment) {
      const std::string message =
        value_that_is_not_finite(section,
                                 {expression.of(segment)},
                                 {expression.middle(segment)},
                                 times,
                                 "for all segments");
      AssertThrow(message.empty(), ExcInput(message));
    });
    for (const double t : times)
      {
        for (unsigned int s = 0; s < of_segment.size(); ++s)
          if (of_segment[s].choice != nullptr)
            within_section(of_segment[s].section,
                           [&]() { content(s).check_at(s, t); });
        if (flows.any())
          within_section(own_section, [&]() { check_flows(t); });
      }
  }



  void
  CavityContents::check_flows(const double t) const
  {
    const unsigned int n         = of_segment.size();
    const auto         can_flow = [&](const unsigned int s, const bool pore) {
      const std::string why = content(s).cannot_flow();
      AssertThrow(why.empty(),
                  ExcParameter(pore ? "Pores" : "Leak",
                               "lets something flow at segment " +
                                 std::to_string(s + 1) + ", whose '" +
                                 of_segment[s].choice->chosen_name() + "' " +
                                 why +
                                 "."));
    };
    for (unsigned int s = 0; s < n; ++s)
      {
        if (of_segment[s].choice != nullptr && flows.is_open(s, t))
          can_flow(s, false);
        if (!flows.pore_behind(s, t) || s + 1 == n)
          continue;
        for (const unsigned int side : {s, s + 1})
          {
            AssertThrow(of_segment[side].choice != nullptr,
                        ExcParameter("Pores",
                                     "is more than 0 between the segments " +
                                       std::to_string(s + 1) + " and " +
                                       std::to_string(s + 2) +
                                       ", but there is no cavity in segment " +
                                       std::to_string(side + 1) +
                                       ". Let it be 0 there, as by "
                                       "'if(s == " +
                                       std::to_string(s + 1) + ", 0, ...)'."));
            can_flow(side, true);
          }
        const std::string names[] = {of_segment[s].choice->chosen_name(),
                                     of_segment[s + 1].choice->chosen_name()};
        AssertThrow(names[0] == names[1] || !content(s).keeps_amount() ||
                      !content(s + 1).keeps_amount(),
                    ExcParameter("Pores",
                                 "is more than 0 between the segments " +
                                   std::to_string(s + 1) + ", with '" +
                                   names[0] + "', and " +
                                   std::to_string(s + 2) + ", with '" +
                                   names[1] +
                                   "'. What flows has to be the same on both "
                                   "sides."));
      }
  }



  std::vector<LoadCurve>
  CavityContents::load_curves() const
  {
    std::vector<LoadCurve> curves;
    for_each_expression([&](const SegmentExpression &expression,
                            const std::string       &section,
                            const unsigned int       segment) {
      if (expression.is_number())
        return;
      curves.push_back(curve_of(section,
                                expression.of(segment),
                                {expression.middle(segment)}));
      curves.back().where = " in segment " + std::to_string(segment + 1);
    });
    return curves;
  }



  const CavityContent &
  CavityContents::content(const unsigned int segment) const
  {
    Assert(of_segment.at(segment).choice != nullptr,
           dealii::ExcInternalError());
    return **of_segment[segment].choice;
  }



  std::vector<SegmentRange>
  CavityContents::ranges() const
  {
    return parse_segment_ranges(own_section + "/" + ranges_name, range_list);
  }



  void
  CavityContents::for_each_expression(
    const std::function<void(const SegmentExpression &,
                             const std::string &,
                             const unsigned int)> &function) const
  {
    for (unsigned int s = 0; s < of_segment.size(); ++s)
      if (of_segment[s].choice != nullptr)
        {
          for (const SegmentExpression *expression : content(s).expressions())
            function(*expression, of_segment[s].section, s);
          for (const SegmentExpression *expression : flows.expressions())
            function(*expression, own_section, s);
        }
  }
} // namespace lumbricus
