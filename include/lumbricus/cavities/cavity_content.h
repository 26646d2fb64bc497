// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavity_content_h
#define lumbricus_cavities_cavity_content_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/parameters/parameter_owner.h>

namespace lumbricus
{
  /** What a CavityContent is asked about. */
  struct CavityPoint
  {
    unsigned int segment;        ///< from zero
    double       volume;         ///< V, of the part that is computed [mm^3]
    double       volume_at_rest; ///< V_0, of the same part [mm^3]
    double       pressure;       ///< P, above that outside [N/mm^2]
    LoadTime     t;              ///< when
  };



  /** The equation s(V, P, t) = 0 of a cavity's pressure. */
  struct CavityEquation
  {
    double s;     ///< in any unit, that of scale
    double ds_dV; ///< its derivative at fixed P
    double ds_dP; ///< its derivative at fixed V
    double scale; ///< the s that is as bad as a volume that is wrong by V_0
  };



  /** What is in a cavity: how its volume and its pressure hang together. */
  class CavityContent : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** The equation at @p point. Throws ExcInput where there is none, as for a
     * gas below vacuum. */
    virtual CavityEquation
    equation(const CavityPoint &point) const = 0;
  };
} // namespace lumbricus

#endif
