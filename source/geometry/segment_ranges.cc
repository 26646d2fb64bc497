// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/segment_ranges.h>

#include <deal.II/base/utilities.h>

#include <regex>

namespace lumbricus
{
  std::string
  SegmentRange::name() const
  {
    return first == last ?
             "Segment " + std::to_string(first) :
             "Segments " + std::to_string(first) + "-" + std::to_string(last);
  }



  std::vector<SegmentRange>
  parse_segment_ranges(const std::string &parameter, const std::string &list)
  {
    // Six digits are more segments than any chain has, and no overflow.
    static const std::regex format("([0-9]{1,6})( *- *([0-9]{1,6}))?");

    std::vector<SegmentRange> ranges;
    for (const std::string &item : dealii::Utilities::split_string_list(list))
      {
        std::smatch parts;
        AssertThrow(std::regex_match(item, parts, format),
                    ExcInput(about_parameter(
                      parameter,
                      ": '" + item +
                        "' is neither the number of a segment nor a range of "
                        "segments. Write a list like '1, 8-10'.")));
        const unsigned int first = std::stoul(parts[1]);
        ranges.push_back(
          {first, parts[3].matched ? unsigned(std::stoul(parts[3])) : first});
      }
    return ranges;
  }



  std::vector<unsigned int>
  range_of_segments(const std::string               &parameter,
                    const std::vector<SegmentRange> &ranges,
                    const unsigned int               n_segments)
  {
    const unsigned int        none = ranges.size();
    std::vector<unsigned int> range_of(n_segments, none);
    for (unsigned int r = 0; r < ranges.size(); ++r)
      {
        const SegmentRange &range = ranges[r];
        AssertThrow(1 <= range.first && range.first <= range.last &&
                      range.last <= n_segments,
                    ExcInput(about_parameter(
                      parameter,
                      ": '" + range.name() +
                        "' is not within the chain. Its segments are numbered "
                        "from 1 (head) to " +
                        std::to_string(n_segments) +
                        " (tail), and a range starts with the smaller "
                        "number.")));
        for (unsigned int s = range.first; s <= range.last; ++s)
          {
            unsigned int &owner = range_of[s - 1];
            AssertThrow(owner == none,
                        ExcInput(about_parameter(
                          parameter,
                          ": two rules for segment " + std::to_string(s) +
                            ": '" + ranges[owner].name() + "' and '" +
                            range.name() + "'. Make the ranges disjoint.")));
            owner = r;
          }
      }
    return range_of;
  }



  std::vector<unsigned int>
  segments_in_list(const std::string &parameter,
                   const std::string &list,
                   const unsigned int n_segments)
  {
    const auto ranges   = parse_segment_ranges(parameter, list);
    const auto range_of = range_of_segments(parameter, ranges, n_segments);
    std::vector<unsigned int> segments;
    for (unsigned int s = 0; s < n_segments; ++s)
      if (range_of[s] < ranges.size())
        segments.push_back(s);
    return segments;
  }
} // namespace lumbricus
