// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/fibre_warnings.h>

#include <cstddef>

namespace lumbricus
{
  std::string
  fibre_warnings(const Anatomy &anatomy)
  {
    std::string all;
    const auto  add = [&](const FibreField &fibres) {
      const std::string what = fibres.warning();
      if (!what.empty())
        all += "Warning: " + what + "\n";
    };
    for (unsigned int i = 0; i < anatomy.n_muscles(); ++i)
      add(anatomy.muscle(i).fibres());
    for (unsigned int i = 0; i < anatomy.geometry().tissues().size(); ++i)
      {
        const Tissue &tissue = anatomy.tissue(i);
        for (const FibreField *fibres : tissue.law().fibre_fields())
          add(*fibres);
        for (std::size_t k = 0; k < tissue.fibre_families().size(); ++k)
          add(tissue.fibre_families()[k].fibres());
      }
    return all;
  }
} // namespace lumbricus
