// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_segment_ranges_h
#define lumbricus_geometry_segment_ranges_h

#include <string>
#include <vector>

namespace lumbricus
{
  /** The segments first, ..., last, counted from one as users do. */
  struct SegmentRange
  {
    unsigned int first; ///< the one nearest to the head
    unsigned int last;  ///< the one nearest to the tail

    /** "Segment 1" or "Segments 8-10". */
    std::string
    name() const;
  };



  /**
   * The ranges in a list like "1, 8-10". Throws ExcInput naming @p parameter
   * where an item is neither a number nor two joined by a minus.
   */
  std::vector<SegmentRange>
  parse_segment_ranges(const std::string &parameter, const std::string &list);



  /**
   * For each of @p n_segments segments the index of the range it is in, or
   * ranges.size() where it is in none. Throws ExcInput naming @p parameter
   * where a range reaches beyond the chain, or a segment is in two.
   */
  std::vector<unsigned int>
  range_of_segments(const std::string               &parameter,
                    const std::vector<SegmentRange> &ranges,
                    const unsigned int               n_segments);



  /** The segments, from zero and in their order, that are in a list like "1, 8-10".
   * Throws as the two above do. */
  std::vector<unsigned int>
  segments_in_list(const std::string &parameter,
                   const std::string &list,
                   const unsigned int n_segments);
} // namespace lumbricus

#endif
