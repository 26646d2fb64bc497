// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_field_h
#define lumbricus_output_field_h

#include <lumbricus/output/field_point.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <limits>
#include <string>

namespace lumbricus
{
  /**
   * A quantity at every point of the body, for pictures and material points.
   * The name it registers itself by is that of its array; derive from one of
   * the classes below, which have the function of a point.
   */
  class Field
  {
  public:
    /** What the value of the field is. */
    enum class Kind
    {
      scalar,         ///< a number
      vector,         ///< three
      tensor,         ///< nine, [i][j]
      scalar_per_cell ///< a number that is the same on all of a cell
    };

    virtual ~Field() = default;

    /** What the value of the field is. */
    virtual Kind
    kind() const = 0;

    /** How many numbers that is. */
    unsigned int
    n_components() const;

    /** Write n_components() numbers to @p values: those at @p point. */
    virtual void
    get(const FieldPoint &point, double *values) const = 0;

    /** Whether there is one in a run where these conditions act. Asked when all
     * parameters have been initialized. */
    virtual bool
    applies_to(const BoundaryConditions & /*conditions*/) const
    {
      return true;
    }

    /** Whether there is one for each muscle, FieldPoint::muscle. */
    virtual bool
    is_per_muscle() const
    {
      return false;
    }

    /** The name of the array for one of these muscles, where @p name is what
     * the field is registered by; as "fibre_outer". */
    virtual std::string
    array_name(const std::string &name, const Muscle &muscle) const
    {
      return name + "_" + muscle.field_name();
    }

    /** Fields come in the order of these numbers, where they are the same in
     * that of their names; those that do not care come last. */
    virtual unsigned int
    place() const
    {
      return std::numeric_limits<unsigned int>::max();
    }

  protected:
    /** Write the numbers that @p value consists of to @p values. */
    static void
    store(const double value, double *values);
    /** Write the components of @p value to @p values. */
    static void
    store(const dealii::Tensor<1, dim> &value, double *values);
    /** Write the components of @p value to @p values, row by row. */
    static void
    store(const dealii::Tensor<2, dim> &value, double *values);
  };



  /** A field whose value is a @p Value; @p its_kind says how it is written. */
  template <typename Value, Field::Kind its_kind>
  class FieldOf : public Field
  {
  public:
    Kind
    kind() const final
    {
      return its_kind;
    }

    void
    get(const FieldPoint &point, double *values) const final
    {
      store(value(point), values);
    }

    /** The value at @p point. */
    virtual Value
    value(const FieldPoint &point) const = 0;
  };



  /** A field of numbers, interpolated within a cell. */
  using ScalarField = FieldOf<double, Field::Kind::scalar>;

  /** A field of vectors, interpolated within a cell. */
  using VectorField = FieldOf<dealii::Tensor<1, dim>, Field::Kind::vector>;

  /** A field of tensors, interpolated within a cell. */
  using TensorField = FieldOf<dealii::Tensor<2, dim>, Field::Kind::tensor>;

  /** A number for every cell: the value at the last point of it. */
  using CellField = FieldOf<double, Field::Kind::scalar_per_cell>;



  /**
   * A field that is there on the skin alone, where a SurfaceTerm acts that
   * remembers something: a value at each node, the sum over these terms.
   * Elsewhere it is zero, and within the cells at the skin it falls to that.
   */
  class SurfaceField : public Field
  {
  public:
    /** Write n_components() zeros. */
    void
    get(const FieldPoint & /*point*/, double *values) const final
    {
      std::fill_n(values, n_components(), 0.);
    }

    /** Write n_components() numbers to @p values: those at the node @p point,
     * where @p term acts; its N and F are not there. */
    virtual void
    get_on_skin(const SurfaceTerm  &term,
                const SurfacePoint &point,
                double             *values) const = 0;
  };



  /** A field on the skin whose value is a @p Value. */
  template <typename Value, Field::Kind its_kind>
  class SurfaceFieldOf : public SurfaceField
  {
  public:
    Kind
    kind() const final
    {
      return its_kind;
    }

    void
    get_on_skin(const SurfaceTerm  &term,
                const SurfacePoint &point,
                double             *values) const final
    {
      store(value(term, point), values);
    }

    /** The value at @p point, where @p term acts. */
    virtual Value
    value(const SurfaceTerm &term, const SurfacePoint &point) const = 0;
  };



  /** A field of numbers on the skin. */
  using SurfaceScalarField = SurfaceFieldOf<double, Field::Kind::scalar>;

  /** A field of vectors on the skin. */
  using SurfaceVectorField =
    SurfaceFieldOf<dealii::Tensor<1, dim>, Field::Kind::vector>;
} // namespace lumbricus

#endif
