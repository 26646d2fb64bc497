// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_dgemm_h
#define lumbricus_discretization_dgemm_h

/** BLAS: C = alpha op(A) op(B) + beta C, matrices by columns. */
extern "C" void
dgemm_(const char   *transa,
       const char   *transb,
       const int    *m,
       const int    *n,
       const int    *k,
       const double *alpha,
       const double *a,
       const int    *lda,
       const double *b,
       const int    *ldb,
       const double *beta,
       double       *c,
       const int    *ldc);

#endif
