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



  Field::Kind
  ScalarField::kind() const
  {
    return Kind::scalar;
  }



  void
  ScalarField::get(const FieldPoint &point, double *values) const
  {
    *values = value(point);
  }



  Field::Kind
  VectorField::kind() const
  {
    return Kind::vector;
  }



  void
  VectorField::get(const FieldPoint &point, double *values) const
  {
    const dealii::Tensor<1, dim> v = value(point);
    for (unsigned int i = 0; i < dim; ++i)
      *values++ = v[i];
  }



  Field::Kind
  TensorField::kind() const
  {
    return Kind::tensor;
  }



  void
  TensorField::get(const FieldPoint &point, double *values) const
  {
    const dealii::Tensor<2, dim> v = value(point);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        *values++ = v[i][j];
  }



  Field::Kind
  CellField::kind() const
  {
    return Kind::scalar_per_cell;
  }



  void
  CellField::get(const FieldPoint &point, double *values) const
  {
    *values = value(point);
  }
} // namespace lumbricus
