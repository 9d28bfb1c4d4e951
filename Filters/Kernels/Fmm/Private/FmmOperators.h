#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace shape
{

/// How well a field is kept. Thresholds are relative to the largest of their kind.
struct FmmAccuracy
{
  int InnerNodes = 6, OuterNodes = 6; ///< Gauss points along an edge of a box's cubes, even
  double MinimumSingularValue = 1e-5; ///< the smallest singular value that is kept
  double MinimumEntry = 1e-5;         ///< the smallest entry of an operator that is kept
};

/**
 * How the field of charges in a box is written down, carried to other boxes and evaluated there,
 * for 1/r: a kernel-independent multipole method.
 *
 * In units of half the box's side: charges in the box are replaced by equivalent charges on the
 * cube of half side 1 (its own sides), such that their potentials agree on the cube of half side 3,
 * and so everywhere outside it (L. Ying, G. Biros, D. Zorin, "A kernel-independent adaptive fast
 * multipole algorithm in two and three dimensions", J. Comput. Phys. 196, 2004, section 3.1). Both
 * cubes carry Gauss points, so that with A the potentials on the outer cube of charges on the inner
 * one, A = U S V^T is the singular value decomposition of the integral operator, and its largest
 * singular values alone are kept (W. Fong, E. Darve, "The black-box fast multipole method", 2009,
 * section 3.3): `Modes` numbers stand for the field of a box.
 *
 *   outgoing  c = V^T (equivalent charges) = Expansion^T (potentials on the outer cube)
 *   incoming  v = V^T (potentials on the inner cube); Expansion v = charges on the outer cube that
 *             have this field in the box
 *
 * Each singular vector is even or odd in x, y and z, so the operators of mirrored offsets differ in
 * signs alone: 56 instead of 316 of them are kept. 1/r scales: one set serves all sizes of boxes.
 */
template <typename Real>
struct FmmOperators
{
  static constexpr double InnerCube = 1.0, OuterCube = 3.0;
  /// Boxes whose parents touch are fewer than this many boxes apart along each axis.
  static constexpr int Reach = 4;

  /// Throws Aborted.
  FmmOperators(const FmmAccuracy& accuracy, const Progress& progress);

  int Modes = 0;  ///< numbers that stand for a box, for each column of the charges
  int Stride = 0; ///< the same, rounded up to whole vectors
  Eigen::MatrixXd InnerPoints, OuterPoints; ///< on the two cubes, one a row
  Eigen::MatrixXd Expansion;                ///< OuterPoints, rounded up to whole vectors, x Stride
  Eigen::MatrixXd Collected;                ///< Expansion's transpose
  Eigen::MatrixXd Inner;   ///< InnerPoints, rounded up, x Stride: equivalent charges from c
  std::vector<Real> Signs; ///< [mirrored axes as bits][Stride]

  /// A product's matrix, by columns of `Stride` rows, with the largest entries alone.
  struct Operator
  {
    std::vector<Real> Entries;
    int Rows = 0, Columns = 0; ///< the others are zero
    std::vector<int> Extents;  ///< for each sixteen rows the columns that are not zero, not rising
  };
  Operator FromChild;                               ///< of the child at (-, -, -): c to c
  Operator ToChild;                                 ///< v to v
  std::array<Operator, Reach * Reach * Reach> Over; ///< c to v, by |target - source| in boxes
};

extern template struct FmmOperators<float>;
extern template struct FmmOperators<double>;

} // namespace shape
