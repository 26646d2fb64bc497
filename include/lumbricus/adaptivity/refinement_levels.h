// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_refinement_levels_h
#define lumbricus_adaptivity_refinement_levels_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <map>
#include <string>
#include <vector>

namespace lumbricus
{
  /** How coarse and how fine cells may be, tissue by tissue. */
  class RefinementLevels : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    /**
     * Read the levels of the tissues of @p anatomy. No cell is coarser than
     * @p least, up to which cells follow the curved surfaces. Throws ExcInput
     * for a tissue that is not there. Collective.
     */
    void
    initialize(const Anatomy &anatomy, const unsigned int least);

    /** The level to which cells of a tissue may be merged; 0 is the coarse
     * mesh. */
    unsigned int
    coarsest(const unsigned int tissue) const;

    /** The level to which cells of a tissue may be refined. */
    unsigned int
    finest(const unsigned int tissue) const;

  private:
    struct Range
    {
      unsigned int coarsest;
      unsigned int finest;
    };

    static Range
    parse(const std::string &tissue, const std::string &text);

    Range                              common = {0, 4};
    std::map<std::string, std::string> of_tissues;
    std::vector<Range>                 by_tissue;
  };
} // namespace lumbricus

#endif
