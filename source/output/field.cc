// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>

namespace lumbricus
{
  unsigned int
  Field::n_components() const
  {
    switch (kind())
      {
        case Kind::vector:
          return dim;
        case Kind::tensor:
          return dim * dim;
        default:
          return 1;
      }
  }



  void
  Field::store(const double value, double *values)
  {
    *values = value;
  }



  void
  Field::store(const dealii::Tensor<1, dim> &value, double *values)
  {
    for (unsigned int i = 0; i < dim; ++i)
      *values++ = value[i];
  }



  void
  Field::store(const dealii::Tensor<2, dim> &value, double *values)
  {
    for (unsigned int i = 0; i < dim; ++i)
      store(value[i], values + i * dim);
  }
} // namespace lumbricus
