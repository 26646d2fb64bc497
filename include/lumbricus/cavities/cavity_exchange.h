// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavity_exchange_h
#define lumbricus_cavities_cavity_exchange_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/geometry/segment_expression.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace lumbricus
{
  /**
   * What flows between neighbouring cavities, out of the body and into it. In a
   * step of the length dt the amounts M of the contents become
   *
   *   M_k = M_k^n - dt ( sum_j g_kj (P_k + e_k - P_j - e_j) + g_k P_k - q_k ),
   *
   * with e_k, by how much more than P_k the pressure in the liquid of cavity k would
   * be at the origin by its weight (LiquidWeight::excess()), with the conductance g_kj of the pores to the next cavities, g_k of the leak
   * and the inflow q_k: implicit in time (backward Euler). What leaves one cavity
   * is what comes into the next, to the last bit. The entries are of the whole
   * body; a part of it has that part of them.
   */
  class CavityExchange : public ParameterOwner
  {
  public:
    /** A cavity, as far as this has to know it. */
    struct Cavity
    {
      unsigned int segment; ///< from zero
      /** Whether its content is an amount: CavityContent::keeps_amount(). */
      bool keeps_amount;
    };

    /** What is in all cavities at the end of a step. */
    struct Amounts
    {
      std::vector<double>        M;     ///< [mm^3]
      dealii::FullMatrix<double> dM_dP; ///< [mm^5/N]
    };

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** For the segments of @p geometry. */
    void
    initialize(const Geometry &geometry);

    /** Whether anything may flow. */
    bool
    any() const;

    /** Pores, leak and inflow. Those between two segments are a pore's of the one
     * nearer to the head. */
    std::vector<const SegmentExpression *>
    expressions() const;

    /** Whether there is a pore behind segment @p segment, from zero, at time
     * @p t. Throws ExcParameter where its conductance, or that of the leak, is
     * negative. */
    bool
    pore_behind(const unsigned int segment, const double t) const;

    /** Whether something flows in or out at segment @p segment at time @p t, but
     * through pores. */
    bool
    is_open(const unsigned int segment, const double t) const;

    /**
     * The amounts at time @p t, @p dt after they were @p before, at the pressures
     * @p P of @p cavities, which are in the order of their segments, and e =
     * @p excess; of those that are no amounts, what they were.
     */
    Amounts
    amounts(const std::vector<Cavity> &cavities,
            const std::vector<double> &before,
            const std::vector<double> &P,
            const std::vector<double> &excess,
            const LoadTime            &t,
            const double               dt) const;

  private:
    SegmentExpression pores  = {"Pores", "0"};
    SegmentExpression leak   = {"Leak", "0"};
    SegmentExpression inflow = {"Inflow", "0"};
    /** Which part of the body is computed. */
    double part = 1.;
  };
} // namespace lumbricus

#endif
