// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_source_contact_round_obstacle_h
#define lumbricus_source_contact_round_obstacle_h

#include <lumbricus/contact/obstacle.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** An Obstacle that has a place and a radius, both of them in time. */
  class RoundObstacle : public Obstacle
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      place.declare_parameter(prm, place_documentation);
      radius.declare_parameter(prm, "[mm] An expression in the time t.");
    }

    std::vector<Expression>
    expressions() const override
    {
      std::vector<Expression> all = place.components();
      all.push_back(radius);
      return all;
    }

    std::string
    unfit(const double t) const override
    {
      const double R = value(radius, t);
      return R > 0. ? "" : "'Radius' is " + std::to_string(R);
    }

  protected:
    /** The place is the parameter @p entry with this default and
     * documentation. */
    RoundObstacle(const std::string &entry,
                  const std::string &default_place,
                  const std::string &documentation)
      : place(entry, default_place)
      , place_documentation(documentation)
    {}

    VectorExpression place;                   ///< [mm]
    Expression       radius = {"Radius", "1"}; ///< R [mm]

  private:
    const std::string place_documentation;
  };
} // namespace lumbricus

#endif
