// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_chain_layout_h
#define lumbricus_geometry_chain_layout_h

#include <lumbricus/geometry/geometry.h>

#include <vector>

#include "extrusion.h"

namespace lumbricus
{
  /** The cells between two stations of a chain, as extrude() takes them. */
  struct ChainSlab
  {
    /** What fills the disk inside the wall. */
    enum class Filling
    {
      liquid, ///< of a chamber, with cells or without
      septum, ///< half of one
      cap     ///< over the whole section
    };

    unsigned int segment; ///< from zero
    Filling      filling; ///< there
  };



  /** A chain of segments along its axis, built from head to tail. */
  class ChainLayout
  {
  public:
    /** With nothing but its beginning at x = 0, where rings have these radii. */
    explicit ChainLayout(const std::vector<double> &radii_at_head)
      : stations({{0., radii_at_head}})
    {}

    /** Where it ends so far [mm]. */
    double
    end() const
    {
      return stations.back().x;
    }

    /** Append @p n slabs of the same kind, @p length long together, at whose end
     * the rings have the radii @p radii. */
    void
    append(const double               length,
           const unsigned int         n,
           const std::vector<double> &radii,
           const ChainSlab           &slab)
    {
      const AxialStation begin = stations.back();
      for (unsigned int i = 1; i <= n; ++i)
        {
          const double f = double(i) / n;
          stations.push_back(
            {begin.x + f * length, mean(begin.radii, radii, f)});
          slabs.push_back(slab);
        }
    }

    /** (1-f) a + f b */
    static std::vector<double>
    mean(const std::vector<double> &a,
         const std::vector<double> &b,
         const double               f)
    {
      std::vector<double> result(a.size());
      for (unsigned int i = 0; i < a.size(); ++i)
        result[i] = a[i] == b[i] ? a[i] : (1 - f) * a[i] + f * b[i];
      return result;
    }

    std::vector<AxialStation>    stations; ///< one more than slabs
    std::vector<ChainSlab>       slabs;    ///< between them
    std::vector<SegmentSections> sections; ///< one for each segment
  };
} // namespace lumbricus

#endif
