// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** The segment a cell is of, from 1. */
  class SegmentOfCell : public CellField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.segment;
    }

    unsigned int
    place() const override
    {
      return 7;
    }
  };

  static const Register<Field, SegmentOfCell>
    segment_of_cell("segment", "the number from the head, from 1.");



  /** The tissue a cell is of: the index in Geometry::tissues(). */
  class TissueOfCell : public CellField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.tissue;
    }

    unsigned int
    place() const override
    {
      return 8;
    }
  };

  static const Register<Field, TissueOfCell>
    tissue_of_cell("tissue", "the number, from 0.");



  /** The rank that owns a cell. */
  class RankOfCell : public CellField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.cell->subdomain_id();
    }

    unsigned int
    place() const override
    {
      return 9;
    }
  };

  static const Register<Field, RankOfCell>
    rank_of_cell("rank", "the one that computes the cell.");
} // namespace lumbricus
