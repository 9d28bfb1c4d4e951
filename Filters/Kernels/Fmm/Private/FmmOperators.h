#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace shape
{

/// Accuracy of the expansions. Thresholds are relative to the largest singular value or entry.
struct FmmAccuracy
{
  /// Gauss points along an edge of the inner and outer cube of a box, even
  int InnerNodes = 6, OuterNodes = 6;
  double MinimumSingularValue = 1e-5; ///< smaller singular values are dropped
  double MinimumEntry = 1e-5;         ///< smaller entries of an operator are dropped
};

/**
 * The operators that expand the field of the charges in a box, translate it to other boxes and
 * evaluate it there, for 1/r: a kernel-independent multipole method.
 *
 * In units of half the box's edge, charges in the box are replaced by equivalent charges on the
 * inner cube, of half edge 1 (the box itself). Their potentials agree on the outer cube, of half
 * edge 3, and so everywhere outside it (L. Ying, G. Biros, D. Zorin, "A kernel-independent adaptive
 * fast multipole algorithm in two and three dimensions", J. Comput. Phys. 196, 2004, section 3.1).
 * Both cubes carry Gauss points. Let A be the potentials on the outer cube of charges on the inner
 * one. A = U S V^T is the singular value decomposition of the integral operator, and only its
 * largest singular values are kept (W. Fong, E. Darve, "The black-box fast multipole method", 2009,
 * section 3.3). So `Modes` coefficients represent the field of a box:
 *
 *   outgoing  c = V^T (equivalent charges) = Expansion^T (potentials on the outer cube)
 *   incoming  v = V^T (potentials on the inner cube); Expansion v = charges on the outer cube that
 *             have this field in the box
 *
 * Each singular vector is even or odd in x, y and z. So the operators of mirrored offsets differ
 * only in signs, and 56 instead of 316 are stored. 1/r is homogeneous, so one set serves boxes of
 * all sizes.
 */
template <typename Real>
struct FmmOperators
{
  static constexpr double InnerCube = 1.0, OuterCube = 3.0;
  /// Two boxes of one level whose parents touch differ by less than this many boxes along each
  /// axis.
  static constexpr int Reach = 4;

  /// Throws Aborted.
  FmmOperators(const FmmAccuracy& accuracy, const Progress& progress);

  int Modes = 0;  ///< number of coefficients of a box for each column of the charges
  int Stride = 0; ///< Modes, rounded up to whole vectors
  Eigen::MatrixXd InnerPoints, OuterPoints; ///< Gauss points on the two cubes, one per row
  Eigen::MatrixXd Expansion; ///< number of OuterPoints, rounded up to whole vectors, x Stride
  Eigen::MatrixXd Collected; ///< transpose of Expansion
  Eigen::MatrixXd Inner; ///< number of InnerPoints, rounded up, x Stride: equivalent charges from c
  std::vector<Real> Signs; ///< [mirrored axes as bits][Stride]

  /// A matrix stored by columns of `Stride` rows; entries below the threshold are zero.
  struct Operator
  {
    std::vector<Real> Entries;
    int Rows = 0, Columns = 0; ///< all other rows and columns are zero
    /// number of leading columns that are not zero, for each sixteen rows; descending
    std::vector<int> Extents;
  };
  Operator FromChild;                               ///< from the child at (-, -, -): c to c
  Operator ToChild;                                 ///< to the child at (-, -, -): v to v
  std::array<Operator, Reach * Reach * Reach> Over; ///< c to v, for each |target - source| in boxes
};

extern template struct FmmOperators<float>;
extern template struct FmmOperators<double>;

} // namespace shape
