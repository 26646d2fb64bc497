// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_stiffness_ratio_h
#define lumbricus_anatomy_stiffness_ratio_h

#include <lumbricus/anatomy/anatomy.h>

#include <string>

namespace lumbricus
{
  /**
   * How much stiffer the stiffest tissue of a body is than the softest, by
   * their shear moduli. Stresses of the one are rounded to eps times its
   * modulus; to the other these are strains of about eps times the ratio, eps =
   * 2e-16.
   */
  class StiffnessRatio
  {
  public:
    /** Of the tissues of @p anatomy, whose parameters have been read. */
    explicit StiffnessRatio(const Anatomy &anatomy);

    /** The ratio, at least one. */
    double
    value() const;

    /** Throw ExcInput where it is more than double precision can bridge. */
    void
    check() const;

    /** A line that begins with "Warning:" where accuracy suffers, or empty. */
    std::string
    warning() const;

  private:
    struct Extreme
    {
      std::string section;
      std::string name;
      double      mu = 0.;
    };

    /** The two tissues with their moduli. */
    std::string
    words() const;

    Extreme softest, stiffest;
  };
} // namespace lumbricus

#endif
