// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/program/chain_model.h>

#include <algorithm>

#include "measure_control.h"

namespace lumbricus
{
  /** The volume of chambers without cells is given, whatever is in them, unless
   * that sets the volume itself. */
  class ChamberVolumeControl : public MeasureControl
  {
  public:
    ChamberVolumeControl()
      : MeasureControl("volume of a chamber", "volume")
    {}

    double
    value(const ChainModel &model, const Vector &relevant_solution) const override
    {
      const auto walls   = model.body.anatomy.geometry().cavities();
      const auto volumes = cavity_volumes(model.body, relevant_solution);
      double     sum     = 0.;
      for (unsigned int k = 0; k < walls.size(); ++k)
        if (std::count(segments().begin(), segments().end(), walls[k].segment))
          sum += volumes[k];
      return sum;
    }

    Vector
    derivative(const ChainModel &model,
               const Vector     &relevant_solution) const override
    {
      return cavity_volume_derivative(model.body,
                                      model.assembler.tangent().unknowns,
                                      segments(),
                                      relevant_solution);
    }

  protected:
    void
    check(const ChainModel &model) const override
    {
      const auto walls = model.body.anatomy.geometry().cavities();
      for (const unsigned int s : segments())
        {
          if (std::none_of(walls.begin(), walls.end(), [&](const CavityWall &w) {
                return w.segment == s;
              }))
            refuse(s,
                   "has no chamber without cells; a liquid with cells has the "
                   "volume that it has");
          // Where it hangs on nothing else any pressure goes with it.
          const auto equation =
            model.parameters.cavity_contents.content(s).equation(
              {s, 1., 1., 1., 0., model.body.anatomy.wall_stiffness(), 0.});
          if (equation.ds_dP == 0.)
            refuse(s,
                   "has a chamber whose content sets the volume. Set "
                   "'Cavities/Content' to 'pressure' or 'gas'");
        }
    }
  };



  static const Register<Continuation, ChamberVolumeControl>
    chamber_volume("volume of a chamber",
                   "steps at whose ends the volume of chambers without cells is "
                   "given: the load parameter, and with it a pressure, is what "
                   "it takes.");
} // namespace lumbricus
