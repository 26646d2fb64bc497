// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_tissue_h
#define lumbricus_anatomy_tissue_h

#include <lumbricus/core/registry.h>
#include <lumbricus/materials/material_law.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** A tissue of the body: its law and the muscles whose fibres run in it. */
  class Tissue : public ParameterOwner
  {
  public:
    /** The tissue of the section Tissues/@p name. */
    explicit Tissue(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** Let its law be, by default, that of the liquid inside a wall. Only
     * before extend_parameters(). */
    void
    make_liquid();

    /** The name of its section, see TissueName. */
    const std::string &
    name() const;

    /** Its constitutive law. */
    const MaterialLaw &
    law() const;

    /** The name of that law, as users choose it. */
    const std::string &
    law_name() const;

    /** The path of the law's section, for messages. */
    std::string
    law_section() const;

    /** Names of sections in Muscles. */
    const std::vector<std::string> &
    muscles() const;

  private:
    const std::string        tissue_name;
    Choice<MaterialLaw>      law_choice;
    std::vector<std::string> muscle_names;
  };
} // namespace lumbricus

#endif
