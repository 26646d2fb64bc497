// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_state_h
#define lumbricus_core_state_h

#include <deal.II/lac/trilinos_vector.h>

namespace lumbricus
{
  /** What a state is made of: Trilinos' distributed vectors. */
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /**
   * All that a run has to remember, as a value: copy it to roll back.
   * Only Newton's method writes the solution, only the reset writes the two
   * others; a reset that relaxes the liquid's mesh writes all three.
   */
  struct State
  {
    /** The load parameter, called time [any unit: the problem is static]. */
    double time = 0.;
    /** Displacement u [mm] and pressure variable p [N/mm^2], owned entries. */
    Vector solution;
    /** u_ref [mm]: where the liquid is free of shear; unused elsewhere. */
    Vector rest_displacement;
    /** u_vol [mm]: where the liquid has its stress-free volume; zero as long as
     * that is the volume of the mesh. */
    Vector volume_displacement;

    /** After entries have been set. Collective. */
    void
    compress()
    {
      for (Vector *vector :
           {&solution, &rest_displacement, &volume_displacement})
        vector->compress(dealii::VectorOperation::insert);
    }
  };
} // namespace lumbricus

#endif
