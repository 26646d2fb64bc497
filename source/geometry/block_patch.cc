// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_patch.h"

#include <lumbricus/core/exceptions.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lumbricus
{
  const std::array<std::string, 6> block_face_names = {
    {"x min", "x max", "y min", "y max", "z min", "z max"}};



  BlockPatch::BlockPatch(const std::string &name)
    : name(name)
  {}



  void
  BlockPatch::declare_parameters(dealii::ParameterHandler &prm)
  {
    std::string choices;
    for (const std::string &face : block_face_names)
      choices += (choices.empty() ? "" : "|") + face;

    const dealii::Patterns::List corner(dealii::Patterns::Double(0.),
                                        dim - 1,
                                        dim - 1);
    prm.add_parameter("Face",
                      face_name,
                      "The face of the block that the rectangle is on.",
                      dealii::Patterns::Selection(choices));
    prm.add_parameter("From",
                      from,
                      "[mm] The corner of the rectangle with the smallest "
                      "coordinates: the two along the face, in the order x, y, "
                      "z. It has to be a vertex of the mesh.",
                      corner);
    prm.add_parameter("To",
                      to,
                      "[mm] The corner opposite, with the largest coordinates.",
                      corner);
  }



  void
  BlockPatch::check(const std::string               &section,
                    const std::vector<double>       &lengths,
                    const std::vector<unsigned int> &n_cells) const
  {
    for (unsigned int i = 0; i < dim - 1; ++i)
      {
        const unsigned int d    = axes()[i];
        const double       cell = lengths[d] / n_cells[d];
        for (const bool last : {false, true})
          {
            const double       value = last ? to[i] : from[i];
            const double       n     = std::round(value / cell);
            std::ostringstream message;
            message << ": " << "xyz"[d] << " = " << value;
            if (n > n_cells[d])
              message << " is outside of the block, which ends at "
                      << lengths[d] << ". Give a smaller number.";
            else if (std::abs(value - n * cell) > 1e-8 * cell)
              message << " is not on a mesh line: the " << n_cells[d]
                      << " cells along "
                      << "xyz"[d] << " are " << cell << " mm long. Move it to "
                      << n * cell << ", or change 'Cells'.";
            else
              continue;
            AssertThrow(false,
                        ExcInput(about_parameter(
                          section + (last ? "/To" : "/From"), message.str())));
          }
        AssertThrow(from[i] + cell / 2 < to[i],
                    ExcInput(about_parameter(
                      section + "/To",
                      std::string(": along ") + "xyz"[d] +
                        " the rectangle has no width. Give a larger number "
                        "than in 'From'.")));
      }
  }



  unsigned int
  BlockPatch::face() const
  {
    return std::find(block_face_names.begin(),
                     block_face_names.end(),
                     face_name) -
           block_face_names.begin();
  }



  bool
  BlockPatch::contains(const dealii::Point<dim> &X) const
  {
    for (unsigned int i = 0; i < dim - 1; ++i)
      {
        const double x = X[axes()[i]];
        if (x < from[i] || x > to[i])
          return false;
      }
    return true;
  }



  bool
  BlockPatch::overlaps(const BlockPatch &other) const
  {
    if (face() != other.face())
      return false;
    for (unsigned int i = 0; i < dim - 1; ++i)
      {
        // Edges that are meant to be the same may differ by rounding.
        const double width =
          std::min(to[i], other.to[i]) - std::max(from[i], other.from[i]);
        if (width <= 1e-6 * (to[i] - from[i]))
          return false;
      }
    return true;
  }



  std::array<unsigned int, dim - 1>
  BlockPatch::axes() const
  {
    const unsigned int normal = face() / 2;
    return {{normal == 0 ? 1u : 0u, normal == 2 ? 1u : 2u}};
  }
} // namespace lumbricus
