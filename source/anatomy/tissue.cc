// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/materials/flowing_liquid.h>
#include <lumbricus/parameters/patterns.h>

#include <cstddef>

namespace lumbricus
{
  Tissue::Tissue(const std::string &name)
    : tissue_name(name)
    , law_choice("Law",
                 "Neo-Hooke",
                 "The constitutive law. In a liquid with a wall around it, it "
                 "has by default a thousandth of the stiffness given here.")
    , families("Elastic fibres",
               "Names",
               "<family>",
               "Families of elastic fibres that strengthen the law in tension, "
               "each a section with direction and stiffness.")
    , couplings("Fibre couplings",
                "Names",
                "<coupling>",
                "What holds two families of elastic fibres at their angle, each a "
                "section with the names of the two.")
    , branches("Viscous branches",
               "Names",
               "<branch>",
               "Maxwell elements beside the law, springs whose stress relaxes, "
               "each a section with stiffness and time: a Prony series.")
  {}



  void
  Tissue::make_liquid()
  {
    law_choice.prepare_with(
      [](MaterialLaw &law) { law.scale_stiffness(1. / 1000.); });
  }



  void
  Tissue::declare_parameters(dealii::ParameterHandler &prm)
  {
    law_choice.declare_parameters(prm);
    prm.add_parameter("Density",
                      mass_density,
                      "[t/mm^3] Mass per volume at rest, for a body force that "
                      "is a weight. Water has 1e-9.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("Muscles",
                      names_of_muscles,
                      "The muscles whose fibres run in this tissue, each a "
                      "section in Muscles; empty for a passive tissue.",
                      NameList());
    families.declare_parameters(prm);
    couplings.declare_parameters(prm);
    branches.declare_parameters(prm);
  }



  bool
  Tissue::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    const bool law      = law_choice.extend_parameters(prm, extent);
    const bool coupling = couplings.extend_parameters(prm, extent);
    const bool branch   = branches.extend_parameters(prm, extent);
    return families.extend_parameters(prm, extent) || law || coupling || branch;
  }



  void
  Tissue::check_parameters() const
  {
    law_choice.check_parameters();
    check_no_name_twice("Muscles", names_of_muscles);
    families.check_parameters();
    couplings.check_parameters();
    branches.check_parameters();
  }



  void
  Tissue::initialize(const std::string &section, const Geometry &geometry)
  {
    law_choice.get()->initialize(law_choice.section_in(section), geometry);
    for (std::size_t k = 0; k < families.size(); ++k)
      families[k].initialize(section + "/" + families.section_name() + "/" +
                               families.name(k),
                             geometry);

    std::vector<std::string> names;
    for (std::size_t k = 0; k < families.size(); ++k)
      names.push_back(families.name(k));
    for (std::size_t k = 0; k < couplings.size(); ++k)
      couplings[k].find_families(section + "/" + couplings.section_name(),
                                 names);
  }



  void
  Tissue::set_muscles(const std::vector<const Muscle *> &muscles)
  {
    chosen_law  = &law();
    its_muscles = muscles;
    actions.clear();
    for (const Muscle *muscle : its_muscles)
      actions.push_back(&muscle->action());
  }



  const std::string &
  Tissue::name() const
  {
    return tissue_name;
  }



  const MaterialLaw &
  Tissue::law() const
  {
    return *law_choice;
  }



  const std::string &
  Tissue::law_name() const
  {
    return law_choice.chosen_name();
  }



  double
  Tissue::shear_modulus() const
  {
    double mu = law().shear_modulus();
    for (std::size_t k = 0; k < branches.size(); ++k)
      mu += branches[k].shear_modulus();
    return mu;
  }



  std::string
  Tissue::law_section() const
  {
    return law_choice.section_in("Tissues/" + tissue_name);
  }



  const std::vector<std::string> &
  Tissue::muscle_names() const
  {
    return names_of_muscles;
  }



  const std::vector<const Muscle *> &
  Tissue::muscles() const
  {
    return its_muscles;
  }



  bool
  Tissue::has_elastic_fibres() const
  {
    return families.size() > 0 || !law().fibre_fields().empty();
  }



  const NamedList<FibreFamily> &
  Tissue::fibre_families() const
  {
    return families;
  }



  const NamedList<FibreCoupling> &
  Tissue::fibre_couplings() const
  {
    return couplings;
  }



  const NamedList<ViscousBranch> &
  Tissue::viscous_branches() const
  {
    return branches;
  }



  std::vector<dealii::Tensor<1, dim>>
  Tissue::elastic_fibres(const dealii::Point<dim> &X) const
  {
    std::vector<dealii::Tensor<1, dim>> directions;
    try
      {
        for (const FibreField *fibres : chosen_law->fibre_fields())
          directions.push_back(fibres->direction(X));
        for (std::size_t k = 0; k < families.size(); ++k)
          directions.push_back(families[k].fibres().direction(X));
      }
    catch (const ExcInput &exception)
      {
        AssertThrow(false,
                    ExcInput("Tissue '" + tissue_name +
                             "': " + plain_message(exception)));
      }
    return directions;
  }



  ReferencePoint
  Tissue::reference_map(
    const std::vector<MuscleFibre>            &fibres,
    const std::vector<dealii::Tensor<1, dim>> &elastic) const
  {
    AssertDimension(fibres.size(), actions.size());
    std::vector<ActiveFibre> stretches;
    stretches.reserve(fibres.size());
    for (std::size_t k = 0; k < actions.size(); ++k)
      actions[k]->add_stretch(fibres[k], stretches);
    ReferencePoint reference = active_stretch_map(stretches);
    if (!elastic.empty())
      {
        const auto G = invert(reference.G_inverse);
        for (const dealii::Tensor<1, dim> &f : elastic)
          reference.fibres.push_back(G * f);
      }
    return reference;
  }



  double
  Tissue::energy(const dealii::Tensor<2, dim> &F,
                 const double                  p,
                 const ReferencePoint         &reference) const
  {
    double            psi   = chosen_law->energy(F, p, reference);
    const std::size_t first = reference.fibres.size() - families.size();
    for (std::size_t k = 0; k < families.size(); ++k)
      psi += families[k].energy(F, reference, reference.fibres[first + k]);
    for (std::size_t k = 0; k < couplings.size(); ++k)
      psi += couplings[k].energy(
        F,
        reference,
        reference.fibres[first + couplings[k].family(0)],
        reference.fibres[first + couplings[k].family(1)]);
    return psi;
  }



  double
  Tissue::viscous_energy(const dealii::Tensor<2, dim> &F,
                         const MaterialPoint          &point) const
  {
    double psi = 0.;
    for (std::size_t k = 0; k < point.viscous.size(); ++k)
      psi += branches[k].energy(F, point.viscous[k].at_end(F));
    return psi;
  }



  double
  Tissue::dissipated(const dealii::Tensor<2, dim> &F_n,
                     const dealii::Tensor<2, dim> &F,
                     const MaterialPoint          &point) const
  {
    double sum = 0.;
    for (std::size_t k = 0; k < point.viscous.size(); ++k)
      sum += branches[k].dissipated(F_n, F, point.viscous[k]);
    return sum;
  }



  void
  Tissue::evaluate(const dealii::Tensor<2, dim> &F,
                   const double                  p,
                   const MaterialPoint          &point,
                   const bool                    with_tangent,
                   MaterialResponse             &response) const
  {
    AssertDimension(point.fibres.size(), actions.size());
    response.mu_missing             = 0.;
    const ReferencePoint &reference = point.reference;
    if (reference.flows)
      flowing_response(
        *chosen_law, F, p, reference.J_v, with_tangent, response);
    else
      chosen_law->evaluate(F, p, reference, with_tangent, response);
    const std::size_t first = reference.fibres.size() - families.size();
    for (std::size_t k = 0; k < families.size(); ++k)
      families[k].add_stress(
        F, reference, reference.fibres[first + k], with_tangent, response);
    for (std::size_t k = 0; k < couplings.size(); ++k)
      couplings[k].add_stress(F,
                              reference,
                              reference.fibres[first + couplings[k].family(0)],
                              reference.fibres[first + couplings[k].family(1)],
                              with_tangent,
                              response);
    for (std::size_t k = 0; k < point.viscous.size(); ++k)
      branches[k].add_stress(F, point.viscous[k], with_tangent, response);
    for (std::size_t k = 0; k < actions.size(); ++k)
      actions[k]->add_stress(F, point.fibres[k], with_tangent, response);
  }
} // namespace lumbricus
