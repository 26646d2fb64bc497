// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** The pressure p of obstacles on the skin, per area at rest [N/mm^2]. */
  class ContactPressure : public SurfaceScalarField
  {
  public:
    bool
    applies_to(const BoundaryConditions &conditions) const override
    {
      return has_contact(conditions);
    }

    double
    value(const SurfaceTerm &term, const SurfacePoint &point) const override
    {
      const auto *contact = dynamic_cast<const Contact *>(&term);
      return contact == nullptr ? 0. : contact->standing(point).p;
    }
  };

  static const Register<Field, ContactPressure>
    contact_pressure("contact_pressure",
                     "of obstacles on the skin [N/mm^2], where there are any.");



  /** The slip s of the skin from where it is anchored, in the surface of the
   * obstacle [mm]. */
  class Slip : public SurfaceVectorField
  {
  public:
    bool
    applies_to(const BoundaryConditions &conditions) const override
    {
      return has_contact(conditions);
    }

    dealii::Tensor<1, dim>
    value(const SurfaceTerm &term, const SurfacePoint &point) const override
    {
      const auto *contact = dynamic_cast<const Contact *>(&term);
      if (contact == nullptr)
        return {};
      const Contact::Standing standing = contact->standing(point);
      return standing.touches || contact->friction().mucus(standing.gap) > 0. ?
               standing.friction.s :
               dealii::Tensor<1, dim>();
    }
  };

  static const Register<Field, Slip>
    slip("slip",
         "of the skin from where it is anchored in an obstacle [mm], where "
         "there are any.");
} // namespace lumbricus
