// SPDX-License-Identifier: LGPL-2.1-or-later
// What a skin in contact does, before and after the mesh changes.
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/contact/contact.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "specimen.h"

using namespace lumbricus;

namespace
{
  // A block that lies on the ground with friction, and is pressed into it.
  const std::string block_on_the_ground = R"(
subsection Geometry
  set Shape = block
  subsection block
    set Cells = 4, 2, 1
  end
end
subsection Boundary conditions
  set Names = ground
  subsection ground
    set Boundary = z min
    set Type     = contact
    subsection contact
      set Friction     = 0.3, 0.6, 0.45
      set Elastic slip = 0.01
    end
  end
end
subsection Adaptivity
  set Every = 1
end
)";

  using Place    = std::array<long, dim>;
  using Traction = std::array<double, dim>;

  // The traction at every node of the skin by its place, on all ranks, with what
  // @p state remembers.
  std::map<Place, Traction>
  tractions(const Specimen &body, const State &state)
  {
    std::vector<double> numbers;
    body.model->surface_terms.visit_cell_nodes(
      state,
      [&](const OwnedCell & /*cell*/,
          const unsigned int /*node*/,
          const unsigned int  i,
          const SurfacePoint &point) {
        const auto &contact = dynamic_cast<const Contact &>(
          *body.parameters.boundary_conditions.condition(i).type);
        const auto T = contact.standing(point).traction();
        for (unsigned int c = 0; c < dim; ++c)
          numbers.push_back(point.X[c]);
        for (unsigned int c = 0; c < dim; ++c)
          numbers.push_back(T[c]);
      });
    std::map<Place, Traction> all;
    for (const auto &of_rank :
         dealii::Utilities::MPI::all_gather(body.comm, numbers))
      for (unsigned int k = 0; k < of_rank.size(); k += 2 * dim)
        {
          Place    place;
          Traction traction;
          for (unsigned int c = 0; c < dim; ++c)
            {
              place[c]    = static_cast<long>(std::round(1e6 * of_rank[k + c]));
              traction[c] = of_rank[k + dim + c];
            }
          all[place] = traction;
        }
    return all;
  }



  // Where the skin had been augmented and pressed less since, it lay above the
  // ground, and the next augmentation let go of it: a worm with one long wave on its
  // ten segments lost all but a few of its points at once, and no smaller step
  // helped. Newton's method is to begin with the pressures that there were.
  TEST(ContactMemory, AugmentingKeepsPressures)
  {
    Specimen body(block_on_the_ground);
    State   &state = body.state;
    Vector   way;
    for (const unsigned int seed : {1u, 2u})
      {
        // Less and less deep.
        state.solution = body.random(0.02 / seed, seed);
        const auto before = tractions(body, state);
        ASSERT_TRUE(body.model->surface_terms.augment(state, state.time, way));
        body.model->equilibrium.constrain(way);
        const auto as_they_lay = tractions(body, state);
        state.solution += way;
        const auto   after = tractions(body, state);
        unsigned int n_pressed = 0, n_let_go = 0;
        for (const auto &[place, T] : before)
          if (T[2] > 0.)
            {
              ++n_pressed;
              n_let_go += as_they_lay.at(place)[2] == 0.;
              EXPECT_NEAR(after.at(place)[2], T[2], 1e-10);
            }
        EXPECT_GT(n_pressed, 5u);
        if (seed == 2)
          {
            EXPECT_GT(n_let_go, 0u);
          }
      }
  }



  // Nodes that stick, slide, are augmented and are apart, where displacements are
  // as rough as can be: nothing is solved for in between.
  TEST(ContactMemory, RefinementChangesNoTraction)
  {
    Specimen  body(block_on_the_ground);
    State    &state = body.state;
    const auto move = [&](const unsigned int seed) {
      state.solution = body.random(0.02, seed);
    };
    move(1);
    Vector way;
    body.model->surface_terms.augment(state, state.time, way);
    body.model->end_step(state);
    move(2);

    const auto   before = tractions(body, state);
    double       largest = 0.;
    unsigned int n_apart = 0, n_pressed = 0, n_sliding = 0;
    for (const auto &[place, T] : before)
      {
        largest = std::max(largest, std::abs(T[2]));
        const double across = std::hypot(T[0], T[1]);
        if (T[2] == 0.)
          ++n_apart;
        else if (across > 0.)
          ++n_pressed;
        n_sliding += across >= 0.3 * T[2] && across > 0.;
      }
    EXPECT_EQ(before.size(), 9 * 5);
    EXPECT_GT(n_apart, 5u);
    EXPECT_GT(n_pressed, 5u);
    EXPECT_GT(n_sliding, 5u);

    mark_where(body.model->triangulation,
               [](const auto &cell) { return cell->center()[0] < 0.5; });
    change_mesh(
      body.model->triangulation,
      body.model->space,
      [&]() { body.model->number_unknowns(); },
      state);
    body.model->reinit();
    const auto after = tractions(body, state);
    EXPECT_EQ(after.size(), 9 * 9 + 4 * 5);
    for (const auto &[place, T] : before)
      for (unsigned int c = 0; c < dim; ++c)
        EXPECT_NEAR(after.at(place)[c], T[c], 1e-13 * largest);
  }
} // namespace
