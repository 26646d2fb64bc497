// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/family_transfer.h>

#include <deal.II/lac/full_matrix.h>

namespace lumbricus
{
  namespace
  {
    // Where the components of all displacements begin.
    std::vector<unsigned int>
    scalar_begins(const CellLayout &layout)
    {
      std::vector<unsigned int> begins;
      for (unsigned int c = 0; c < dim; ++c)
        for (const unsigned int begin : layout.displacement_begins())
          begins.push_back(begin + c * MixedSpace::n_nodes);
      return begins;
    }



    // to += M from
    void
    multiply(const dealii::FullMatrix<double> &M,
             const double                     *from,
             double                           *to)
    {
      for (unsigned int i = 0; i < M.m(); ++i)
        for (unsigned int j = 0; j < M.n(); ++j)
          to[i] += M(i, j) * from[j];
    }
  } // namespace



  FamilyTransfer::FamilyTransfer(const CellLayout &layout)
    : size(layout.size())
    , scalars(scalar_begins(layout))
    , pressures(layout.pressure_begins())
  {}



  FamilyTransfer::Values
  FamilyTransfer::to_child(const unsigned int c, const Values &parent) const
  {
    Values child(size);
    for (const unsigned int begin : scalars)
      multiply(displacement.get_prolongation_matrix(c),
               &parent[begin],
               &child[begin]);
    for (const unsigned int begin : pressures)
      multiply(pressure.get_prolongation_matrix(c),
               &parent[begin],
               &child[begin]);
    return child;
  }



  FamilyTransfer::Values
  FamilyTransfer::to_parent(const std::vector<Values> &children) const
  {
    Values parent(size);
    for (unsigned int c = 0; c < children.size(); ++c)
      {
        // A node of the parent is one of each child that it touches.
        const auto &injection = displacement.get_restriction_matrix(c);
        for (unsigned int i = 0; i < injection.m(); ++i)
          for (unsigned int j = 0; j < injection.n(); ++j)
            if (injection(i, j) > 0.5)
              for (const unsigned int begin : scalars)
                parent[begin + i] = children[c][begin + j];
        for (const unsigned int begin : pressures)
          multiply(pressure.get_restriction_matrix(c),
                   &children[c][begin],
                   &parent[begin]);
      }
    return parent;
  }
} // namespace lumbricus
