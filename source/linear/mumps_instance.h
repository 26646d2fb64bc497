// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_mumps_instance_h
#define lumbricus_linear_mumps_instance_h

#include <lumbricus/linear/mumps.h>

#include <dmumps_c.h>
#include <smumps_c.h>

namespace lumbricus
{
  /** What of MUMPS depends on the precision: its structure and its function. */
  template <typename Number>
  struct Precision;

  /** Double. */
  template <>
  struct Precision<double>
  {
    /** What it is called with. */
    using Data = DMUMPS_STRUC_C;
    /** Its only function. */
    static constexpr auto call = dmumps_c;
  };

  /** Single. */
  template <>
  struct Precision<float>
  {
    /** What it is called with. */
    using Data = SMUMPS_STRUC_C;
    /** Its only function. */
    static constexpr auto call = smumps_c;
  };



  /** What MUMPS is called with: its structure, by the numbers of its manual,
   * which start at one. */
  template <typename Number>
  struct Mumps<Number>::Instance
  {
    /** Its names for what run() does. */
    enum Job
    {
      initialise      = -1, ///< begin
      terminate       = -2, ///< end
      analysis        = 1,  ///< of the pattern
      factorise       = 2,  ///< the matrix
      back_substitute = 3   ///< solve with the factors
    };

    /** Of dmumps_c.h or smumps_c.h. */
    typename Precision<Number>::Data data;

    /** ICNTL(i), an option. */
    MUMPS_INT &
    control(const int i)
    {
      return data.icntl[i - 1];
    }

    /** INFOG(i), the same on all ranks; what is negative is an error. */
    MUMPS_INT
    info(const int i) const
    {
      return data.infog[i - 1];
    }

    /** RINFOG(i), the same on all ranks. */
    double
    real_info(const int i) const
    {
      return data.rinfog[i - 1];
    }
  };
} // namespace lumbricus

#endif
