// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/muscle_action.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/section.h>

#include "tension.h"

namespace lumbricus
{
  /**
   * The activation alpha, from 0 to 1, is the part of its Tension that a fibre
   * has. With a = F f, its stretch l = |a| and n = a/l the force along it per
   * area at rest is g(l), and
   *
   *   P = g n x f,
   *   dP_iJ/dF_kL = (g' n_i n_k + g/l (delta_ik - n_i n_k)) f_J f_L.
   *
   * F is that of the displacements, volume and all: where the volume is kept,
   * any other choice makes another pressure.
   */
  class ActiveStress : public MuscleAction
  {
  public:
    ActiveStress()
      : MuscleAction("activation",
                     0.,
                     1.,
                     "How the part of its tension that the muscle has, from 0 "
                     "to 1, changes with time.")
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      MuscleAction::declare_parameters(prm);
      tension.declare_parameters(prm);
    }

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      const bool activation = MuscleAction::extend_parameters(prm, extent);
      const bool curves     = tension.extend_parameters(prm, extent);
      return activation || curves;
    }

    void
    check_parameters() const override
    {
      MuscleAction::check_parameters();
      tension.check_parameters();
    }

    void
    initialize(const std::string &section, const Geometry &geometry) override
    {
      MuscleAction::initialize(section, geometry);
      tension.initialize(section + "/" + tension.section_name(), geometry);
    }

    std::string
    requirement(const double alpha) const override
    {
      return alpha >= 0. && alpha <= 1. ?
               "" :
               "a number from 0 (rest) to 1 (all of its strength)";
    }

    double
    strength(const double alpha, const double tension) const override
    {
      return alpha * tension;
    }

    double
    largest_tension(const unsigned int        segment,
                    const dealii::Point<dim> &X) const override
    {
      return tension.strength(segment, X);
    }

    bool
    feels_speed() const override
    {
      return tension.feels_speed();
    }

    void
    add_stress(const dealii::Tensor<2, dim> &F,
               const MuscleFibre            &fibre,
               const bool                    with_tangent,
               MaterialResponse             &response) const override
    {
      const dealii::Tensor<1, dim> a = F * fibre.f;
      const double                 l = a.norm();
      const dealii::Tensor<1, dim> n = a / l;
      const CurvePoint             g = tension.at(fibre, l);
      response.P += g.value * dealii::outer_product(n, fibre.f);
      if (!with_tangent)
        return;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          {
            const double across = (i == k ? 1. : 0.) - n[i] * n[k];
            const double both   = g.slope * n[i] * n[k] + g.value / l * across;
            for (unsigned int J = 0; J < dim; ++J)
              for (unsigned int L = 0; L < dim; ++L)
                response.A[dim * i + J][dim * k + L] +=
                  both * fibre.f[J] * fibre.f[L];
          }
    }

  private:
    Section<Tension> tension{"active stress"};
  };



  static const Register<MuscleAction, ActiveStress>
    active_stress("active stress",
                  "its fibres pull: a tension along them is added to the stress "
                  "of the tissue.");
} // namespace lumbricus
