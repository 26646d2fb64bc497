// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/measures/contact_state.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    // The skin that a contact has in a segment.
    struct Skin
    {
      ContactState state;
      double       area = 0.;
    };



    void
    add_point(const Contact       &contact,
              const SurfacePoint  &at,
              const double         JxW,
              Skin                &skin)
    {
      const Contact::Standing standing = contact.standing(at);
      ContactState &state = skin.state;
      skin.area += JxW;
      state.normal_force += JxW * standing.p;
      state.force += JxW * standing.traction();
      state.friction += JxW * standing.friction.T;
      if (standing.touches)
        {
          state.area += JxW;
          state.penetration = std::max(state.penetration, -standing.gap);
        }
      if (!standing.touches && contact.friction().mucus(standing.gap) == 0.)
        return;
      state.area_in_touch += JxW;
      if (!standing.friction.holds || standing.friction.slides)
        state.sliding_area += JxW;
    }



    void
    sum_over_ranks(std::vector<Skin> &skins, const MPI_Comm comm)
    {
      std::vector<double> sums, largest;
      for (const Skin &skin : skins)
        {
          const ContactState &state = skin.state;
          sums.insert(sums.end(),
                      {skin.area,
                       state.normal_force,
                       state.area,
                       state.area_in_touch,
                       state.sliding_area});
          for (unsigned int c = 0; c < dim; ++c)
            sums.insert(sums.end(), {state.force[c], state.friction[c]});
          largest.push_back(state.penetration);
        }
      dealii::Utilities::MPI::sum(sums, comm, sums);
      dealii::Utilities::MPI::max(largest, comm, largest);
      const double *sum     = sums.data();
      const double *deepest = largest.data();
      for (Skin &skin : skins)
        {
          ContactState &state = skin.state;
          skin.area           = *sum++;
          state.normal_force  = *sum++;
          state.area          = *sum++;
          state.area_in_touch = *sum++;
          state.sliding_area  = *sum++;
          for (unsigned int c = 0; c < dim; ++c)
            {
              state.force[c]    = *sum++;
              state.friction[c] = *sum++;
            }
          state.penetration = *deepest++;
        }
    }
  } // namespace



  double
  ContactState::sliding_part() const
  {
    return area_in_touch > 0. ? sliding_area / area_in_touch : 0.;
  }



  bool
  ContactState::is_anchored() const
  {
    return area_in_touch > 0. && sliding_part() < 0.5;
  }



  std::vector<ContactState>
  contact_states(const Body               &body,
                 const BoundaryConditions &conditions,
                 SurfaceTerms             &terms,
                 const Vector             &solution,
                 const LoadTime           &t)
  {
    std::vector<ContactState> states;
    if (!has_contact(conditions))
      return states;

    const unsigned int n_segments = body.anatomy.geometry().n_segments();
    const auto         contacts   = contacts_of(conditions);
    std::vector<Skin>  skins(contacts.size() * n_segments);
    terms.visit_points(
      solution, t, [&](const unsigned int condition, const SurfacePoint &at) {
        if (contacts[condition] != nullptr)
          add_point(*contacts[condition],
                    at,
                    terms.point().JxW,
                    skins[condition * n_segments + at.segment]);
      });
    sum_over_ranks(skins, body.space.communicator());
    for (unsigned int i = 0; i < skins.size(); ++i)
      if (skins[i].area > 0.)
        {
          states.push_back(skins[i].state);
          states.back().name = conditions.condition(i / n_segments).name;
          states.back().segment = i % n_segments;
        }
    return states;
  }
} // namespace lumbricus
