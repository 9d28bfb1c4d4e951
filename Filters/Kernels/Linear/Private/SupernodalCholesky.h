#pragma once

#include "Base/Progress.h"

#include <Eigen/SparseCore>

namespace shape
{

/**
 * The pattern of a Cholesky factor L of P A P^T, whose columns are grouped into supernodes. The
 * columns of a supernode are consecutive and have the same rows below their diagonal block. The
 * values of a supernode are a dense matrix by columns, with one row for each of its rows.
 */
struct SupernodalPattern
{
  int Count;           ///< number of supernodes
  const int* Columns;  ///< the first column of each supernode, and the number of columns
  const int* RowEnds;  ///< where the rows of each supernode begin in Rows, and their number
  const int* Rows;     ///< rows of each supernode, ascending; its own columns are the first
  const int* Values;   ///< where the values of each supernode begin
  const int* Original; ///< for each row of P A P^T, the row of A
};

/**
 * Computes the values of L by left-looking supernodal factorisation (Ng and Peyton, "Block sparse
 * Cholesky algorithms on advanced uniprocessor computers", SIAM J. Sci. Comput. 14, 1993). Unlike a
 * library's factorisation, it reports its progress and can be interrupted.
 *
 * a: both triangular parts stored; its pattern is that of the factor or smaller. values: the values
 * of L, which are overwritten. Above the diagonal they are undefined. Returns whether A is positive
 * definite. The number of threads does not change the bits. Throws Aborted.
 */
bool FactorizeSupernodes(const Eigen::SparseMatrix<double>& a, const SupernodalPattern& pattern,
  double* values, const Progress& progress);

} // namespace shape
