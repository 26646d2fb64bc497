// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_border_vector_h
#define lumbricus_discretization_border_vector_h

#include <lumbricus/core/state.h>

#include <vector>

namespace lumbricus
{
  /** A row or column of a Border: a vector of the free unknowns of which next to
   * all entries are zero, as on the surface of one chamber. */
  class BorderVector
  {
  public:
    BorderVector() = default;

    /** The entries of @p dense that are not zero, of those this rank owns. */
    explicit BorderVector(const Vector &dense)
    {
      const auto n = dense.locally_owned_size();
      for (unsigned int i = 0; i < n; ++i)
        if (dense.local_element(i) != 0.)
          {
            places.push_back(i);
            values.push_back(dense.local_element(i));
          }
    }

    /** The owned entries at @p places, in ascending order; some may be zero. */
    BorderVector(const std::vector<unsigned int> &places,
                 const std::vector<double>       &values)
      : places(places)
      , values(values)
    {}

    /** Call @p f(place, value) for all entries. */
    template <typename Function>
    void
    for_each(const Function &f) const
    {
      for (unsigned int k = 0; k < places.size(); ++k)
        f(places[k], values[k]);
    }

    /** The part of the scalar product with @p other that the owned entries make.
     */
    double
    product(const BorderVector &other) const
    {
      double       sum = 0.;
      unsigned int l   = 0;
      for (unsigned int k = 0; k < places.size(); ++k)
        {
          while (l < other.places.size() && other.places[l] < places[k])
            ++l;
          if (l < other.places.size() && other.places[l] == places[k])
            sum += values[k] * other.values[l];
        }
      return sum;
    }

    /** The part of the scalar product with @p x that the owned entries make. */
    double
    product(const Vector &x) const
    {
      double sum = 0.;
      for (unsigned int k = 0; k < places.size(); ++k)
        sum += values[k] * x.local_element(places[k]);
      return sum;
    }

    /** The part of its square that the owned entries make. */
    double
    square() const
    {
      double sum = 0.;
      for (const double value : values)
        sum += value * value;
      return sum;
    }

    /** x += factor times this. */
    void
    add_to(Vector &x, const double factor) const
    {
      for (unsigned int k = 0; k < places.size(); ++k)
        x.local_element(places[k]) += factor * values[k];
    }

    /** Multiply it with @p factor. */
    void
    scale(const double factor)
    {
      for (double &value : values)
        value *= factor;
    }

    /** Set all of @p x to this. */
    void
    copy_to(Vector &x) const
    {
      x = 0.;
      add_to(x, 1.);
    }

  private:
    std::vector<unsigned int> places;
    std::vector<double>       values;
  };
} // namespace lumbricus

#endif
