// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavity_content_h
#define lumbricus_cavities_cavity_content_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/geometry/segment_expression.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What a CavityContent is asked about. */
  struct CavityPoint
  {
    unsigned int segment;        ///< from zero
    double       volume;         ///< V, of the part that is computed [mm^3]
    double       volume_at_rest; ///< V_0, of the same part [mm^3]
    /** M, how much is inside: the volume that this takes at rest, which is V_0
     * until something has flowed in or out [mm^3]. */
    double   amount;
    double   pressure;  ///< P, above that outside [N/mm^2]
    double   stiffness; ///< a pressure to measure by, of the wall [N/mm^2]
    LoadTime t;         ///< when
  };



  /** The equation s(V, P, M, t) = 0 of a cavity's pressure, and the derivatives
   * of s by each at fixed others. */
  struct CavityEquation
  {
    double s;     ///< in any unit, that of scale
    double ds_dV; ///< ds/dV
    double ds_dP; ///< ds/dP
    double ds_dM; ///< ds/dM; 0 where it does not matter how much there is
    double scale; ///< the s that is as bad as a volume that is wrong by V_0
  };



  /** What is in a cavity: how its volume and its pressure hang together. */
  class CavityContent : public PartOfBody
  {
  public:
    /** The equation at @p point. */
    virtual CavityEquation
    equation(const CavityPoint &point) const = 0;

    /** The pressure of segment @p segment, from zero, at @p t where it is known
     * beforehand, as a load is: what it does is there from the first iteration
     * on. */
    virtual std::optional<double>
    given_pressure(const unsigned int /*segment*/, const LoadTime & /*t*/) const
    {
      return {};
    }

    /** Mass per volume at rest [t/mm^3]. */
    virtual double
    density() const = 0;

    /** Whether it is a given amount that pores and leaks change; else it is
     * whatever there is to flow, of a volume or a pressure that is given. */
    virtual bool
    keeps_amount() const = 0;

    /** Why nothing can flow into it or out of it, as the end of a sentence about
     * the content; empty where it can. */
    virtual std::string
    cannot_flow() const
    {
      return "";
    }

    /** What it does over time; loads are followed by load steps, and tried
     * before a run. */
    virtual std::vector<const SegmentExpression *>
    expressions() const
    {
      return {};
    }

    /** Throws ExcParameter where segment @p segment, from zero, cannot have this
     * at time @p t, as with a volume below zero. */
    virtual void
    check_at(const unsigned int /*segment*/, const double /*t*/) const
    {}
  };
} // namespace lumbricus

#endif
