#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace shape
{

/// Accuracy of the expansions. MinimumSingularValue is relative to the largest singular value,
/// MinimumEntry to the largest entry of an operator.
struct FmmAccuracy
{
  /// number of Gauss points along an edge of the inner and of the outer cube of a box; even
  int InnerNodes = 6, OuterNodes = 6;
  double MinimumSingularValue = 1e-5; ///< smaller singular values are dropped
  /// trailing rows and columns of an operator are skipped if all their entries are smaller
  double MinimumEntry = 1e-5;
};

/**
 * The operators that expand the field of the charges in a box, translate it to other boxes and
 * evaluate it there, for the kernel 1/r: a kernel-independent multipole method.
 *
 * Lengths are in units of half the box's edge. Charges in the box are replaced by equivalent
 * charges on the surface of the inner cube, which has half edge 1 and is the box itself. The
 * charges and the equivalent charges have the same potentials on the surface of the outer cube,
 * which has half edge 3, and so everywhere outside it (L. Ying, G. Biros, D. Zorin, "A
 * kernel-independent adaptive fast multipole algorithm in two and three dimensions", J. Comput.
 * Phys. 196, 2004, section 3.1). Both cubes carry Gauss points. Let A be the integral operator from
 * charges on the inner cube to potentials on the outer cube, and A = U S V^T its singular value
 * decomposition. Only the largest singular values are kept (W. Fong, E. Darve, "The black-box fast
 * multipole method", 2009, section 3.3). So `Modes` coefficients represent the field of a box:
 *
 *   outgoing  c = V^T (equivalent charges) = Expansion^T (potentials on the outer cube)
 *   incoming  v = V^T (potentials on the inner cube); Expansion v = charges on the outer cube that
 *             have this field in the box
 *
 * Each singular vector is even or odd in x, y and z. Operators for mirrored offsets therefore
 * differ only in signs, and 56 operators are stored instead of 316. 1/r is homogeneous, so one set
 * of operators serves boxes of all sizes.
 */
template <typename Real>
struct FmmOperators
{
  static constexpr double InnerCube = 1.0, OuterCube = 3.0;
  /// If the parents of two boxes on the same level touch, the cell indices of the boxes differ by
  /// less than this along each axis.
  static constexpr int Reach = 4;

  /// Throws Aborted.
  FmmOperators(const FmmAccuracy& accuracy, const Progress& progress);

  int Modes = 0;  ///< number of coefficients of a box, for each column of the charges
  int Stride = 0; ///< Modes, rounded up to whole vectors
  Eigen::MatrixXd InnerPoints, OuterPoints; ///< the Gauss points of the two cubes, one per row
  /// One row for each outer point, padded to whole vectors; Stride columns.
  Eigen::MatrixXd Expansion;
  Eigen::MatrixXd Collected; ///< transpose of Expansion
  /// One row for each inner point, padded to whole vectors; Stride columns. The equivalent charges
  /// are Inner times c.
  Eigen::MatrixXd Inner;
  /// 8 x Stride: row i has the signs of the coefficients after mirroring along the axes that are
  /// set as bits of i
  std::vector<Real> Signs;

  /// A matrix, stored column by column; each column has Stride entries.
  struct Operator
  {
    std::vector<Real> Entries;
    int Rows = 0, Columns = 0; ///< all later rows and columns are skipped
    /// for each group of sixteen rows, the number of leading columns that are not skipped;
    /// descending
    std::vector<int> Extents;
  };
  /// computes c of the parent from c of its child in the lowest octant (-, -, -)
  Operator FromChild;
  /// computes v of the child in the lowest octant (-, -, -) from v of its parent
  Operator ToChild;
  /// compute v of a target box from c of a source box, for each |target - source| in cells
  std::array<Operator, Reach * Reach * Reach> Over;
};

extern template struct FmmOperators<float>;
extern template struct FmmOperators<double>;

} // namespace shape
