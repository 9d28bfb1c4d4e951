#include "Fmm/Private/FmmOperators.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <lapacke.h>
#include <numeric>

namespace shape
{

namespace
{

/// Length of the widest vectors in single precision.
constexpr int Widest = 16;

int RoundedUp(Eigen::Index count)
{
  return static_cast<int>(count + Widest - 1) / Widest * Widest;
}

/// The positive half of the Gauss-Legendre points on [-1, 1], and their weights.
Eigen::ArrayX2d PositiveGaussPoints(int count)
{
  Eigen::ArrayX2d rule(count / 2, 2);
  for (int i = 0; i < count / 2; ++i)
  {
    // Newton's method for the roots of the Legendre polynomial, from their asymptotic estimate.
    double x = std::cos(M_PI * (i + 0.75) / (count + 0.5)), slope = 1.0;
    for (int step = 0; step < 100; ++step)
    {
      // The three-term recurrence of the Legendre polynomials; then the derivative from the last
      // two.
      double before = 1.0, value = x;
      for (int degree = 2; degree <= count; ++degree)
      {
        const double next = ((2 * degree - 1) * x * value - (degree - 1) * before) / degree;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    rule.row(i) << x, 2.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

/// Returns the sign of a vector with the given parity after mirroring along `axes` (both as bits).
double Sign(int axes, int parity)
{
  const int both = axes & parity;
  return ((both ^ both >> 1 ^ both >> 2) & 1) != 0 ? -1.0 : 1.0;
}

/// The Gauss points of the octant x, y, z > 0 and the square roots of their weights, then their
/// mirror images. Point o of the octant, mirrored along the axes g, has number g x octant + o.
struct CubePoints
{
  Eigen::MatrixXd Positions;
  Eigen::VectorXd RootWeights;
  int Octant = 0;

  CubePoints(int nodes, double halfSide)
    : Octant(3 * nodes * nodes / 4)
  {
    const Eigen::ArrayX2d rule = PositiveGaussPoints(nodes);
    this->Positions.resize(8 * this->Octant, 3);
    this->RootWeights.resize(8 * this->Octant);
    int row = 0;
    for (int axes = 0; axes < 8; ++axes)
    {
      for (int face = 0; face < 3; ++face)
      {
        for (int i = 0; i < nodes / 2; ++i)
        {
          for (int j = 0; j < nodes / 2; ++j, ++row)
          {
            this->Positions(row, face) = 1.0;
            this->Positions(row, (face + 1) % 3) = rule(i, 0);
            this->Positions(row, (face + 2) % 3) = rule(j, 0);
            this->Positions.row(row) *= halfSide;
            this->RootWeights[row] = std::sqrt(rule(i, 1) * rule(j, 1));
            for (int c = 0; c < 3; ++c)
            {
              this->Positions(row, c) *= Sign(axes, 1 << c);
            }
          }
        }
      }
    }
  }
};

Eigen::MatrixXd InverseDistances(const Eigen::MatrixXd& to, const Eigen::MatrixXd& from)
{
  Eigen::MatrixXd matrix(to.rows(), from.rows());
  for (Eigen::Index j = 0; j < from.rows(); ++j)
  {
    matrix.col(j) = ((to.col(0).array() - from(j, 0)).square() +
      (to.col(1).array() - from(j, 1)).square() + (to.col(2).array() - from(j, 2)).square())
                      .rsqrt();
  }
  return matrix;
}

/// The largest singular values of A, and their vectors weighted by the roots of the weights.
struct Spectrum
{
  Eigen::VectorXd Values;
  Eigen::MatrixXd Left, Right; ///< number of points x number of values
  std::vector<int> Parities;   ///< axes along which a vector is odd, as bits
};

Spectrum Decompose(const CubePoints& inner, const CubePoints& outer, double threshold)
{
  // The integral operator is discretized by quadrature: each entry is multiplied by the square
  // roots of both weights (Fong and Darve 2009, section 3.3). A is invariant under mirroring, so
  // its singular vectors are even or odd along each axis: eight decompositions of an eighth of the
  // size replace one.
  const int rows = outer.Octant, columns = inner.Octant, octant = std::min(rows, columns);
  const Eigen::MatrixXd full = outer.RootWeights.head(rows).asDiagonal() *
    InverseDistances(outer.Positions.topRows(rows), inner.Positions) *
    inner.RootWeights.asDiagonal();
  std::array<Eigen::MatrixXd, 8> left, right;
  Eigen::VectorXd values(8 * octant);
  for (int parity = 0; parity < 8; ++parity)
  {
    // The operator on vectors of one parity, from their values in one octant.
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(rows, columns);
    for (int axes = 0; axes < 8; ++axes)
    {
      block += Sign(axes, parity) * full.middleCols(axes * columns, columns);
    }
    left[parity].resize(rows, octant);
    right[parity].resize(octant, columns);
    if (LAPACKE_dgesdd(LAPACK_COL_MAJOR, 'S', rows, columns, block.data(), rows,
          values.data() + parity * octant, left[parity].data(), rows, right[parity].data(),
          octant) != 0)
    {
      throw SolveFailure("the operators of the multipole method could not be decomposed; use the "
                         "direct method");
    }
  }
  // The singular values of all parities together, descending, down to the threshold.
  std::vector<int> order(8 * octant);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] > values[b]; });
  const double minimum = threshold * values.maxCoeff();
  order.erase(std::find_if(order.begin(), order.end(), [&](int i) { return values[i] < minimum; }),
    order.end());

  Spectrum kept;
  const auto count = static_cast<int>(order.size());
  kept.Values.resize(count);
  kept.Left.resize(8 * rows, count);
  kept.Right.resize(8 * columns, count);
  for (int mode = 0; mode < count; ++mode)
  {
    const int parity = order[mode] / octant, column = order[mode] % octant;
    kept.Values[mode] = values[order[mode]];
    kept.Parities.push_back(parity);
    for (int axes = 0; axes < 8; ++axes)
    {
      // The vector is continued to all octants by mirroring, and normalised.
      const double sign = Sign(axes, parity) / std::sqrt(8.0);
      kept.Left.col(mode).segment(axes * rows, rows) = sign * left[parity].col(column);
      kept.Right.col(mode).segment(axes * columns, columns) =
        sign * right[parity].row(column).transpose();
    }
  }
  kept.Left = outer.RootWeights.asDiagonal() * kept.Left;
  kept.Right = inner.RootWeights.asDiagonal() * kept.Right;
  return kept;
}

/// Replaces each two neighbouring octants of the eight by their sum and difference, along each axis
/// in turn.
template <typename Octant>
void AddAndSubtract(const Octant& octant)
{
  for (int axis = 1; axis < 8; axis *= 2)
  {
    for (int axes = 0; axes < 8; ++axes)
    {
      if ((axes & axis) == 0)
      {
        auto low = octant(axes), high = octant(axes | axis);
        low += high;
        high = low - 2.0 * high;
      }
    }
  }
}

/// Returns Right^T potentials Right. Each vector is even or odd along each axis, so with the sums
/// and differences of the octants the products have an eighth of the size.
Eigen::MatrixXd Projected(Eigen::MatrixXd potentials, const Spectrum& modes, int octant)
{
  AddAndSubtract([&](int axes) { return potentials.middleCols(axes * octant, octant); });
  AddAndSubtract([&](int axes) { return potentials.middleRows(axes * octant, octant); });
  std::array<std::vector<int>, 8> ofParity;
  for (int mode = 0; mode < static_cast<int>(modes.Parities.size()); ++mode)
  {
    ofParity[modes.Parities[mode]].push_back(mode);
  }
  std::array<Eigen::MatrixXd, 8> vectors;
  for (int parity = 0; parity < 8; ++parity)
  {
    vectors[parity] = modes.Right.topRows(octant)(Eigen::all, ofParity[parity]);
  }
  Eigen::MatrixXd projected(modes.Right.cols(), modes.Right.cols());
  for (int to = 0; to < 8; ++to)
  {
    for (int from = 0; from < 8; ++from)
    {
      const Eigen::MatrixXd half =
        potentials.block(to * octant, from * octant, octant, octant) * vectors[from];
      projected(ofParity[to], ofParity[from]) = vectors[to].transpose() * half;
    }
  }
  return projected;
}

template <typename Real>
typename FmmOperators<Real>::Operator Pack(
  const Eigen::MatrixXd& matrix, int stride, double smallest)
{
  typename FmmOperators<Real>::Operator packed;
  packed.Extents.assign(stride / Widest, 0);
  for (int j = 0; j < matrix.cols(); ++j)
  {
    for (int i = 0; i < matrix.rows(); ++i)
    {
      if (std::abs(matrix(i, j)) >= smallest)
      {
        packed.Extents[i / Widest] = j + 1;
        packed.Rows = std::max(packed.Rows, i + 1);
        packed.Columns = j + 1;
      }
    }
  }
  for (int group = stride / Widest - 1; group > 0; --group)
  {
    // Extents descend. Coefficients are sorted by singular value, so small entries gather at the
    // end; the product skips them.
    packed.Extents[group - 1] = std::max(packed.Extents[group - 1], packed.Extents[group]);
  }
  packed.Entries.assign(static_cast<std::size_t>(stride) * packed.Columns, Real(0));
  for (int j = 0; j < packed.Columns; ++j)
  {
    for (int i = 0; i < matrix.rows(); ++i)
    {
      packed.Entries[static_cast<std::size_t>(j) * stride + i] = static_cast<Real>(matrix(i, j));
    }
  }
  return packed;
}

} // namespace

template <typename Real>
FmmOperators<Real>::FmmOperators(const FmmAccuracy& accuracy, const Progress& progress)
{
  // Outline:
  // 1. The decomposition A = U S V^T, which gives the coefficients of a box.
  // 2. Expansion = U S^-1, Inner = V, and the signs of the mirrored modes.
  // 3. Translations between a box and its child.
  // 4. Translations to the boxes of the V list.
  const BlasThreads one(false);
  const CubePoints inner(accuracy.InnerNodes, InnerCube), outer(accuracy.OuterNodes, OuterCube);
  this->InnerPoints = inner.Positions;
  this->OuterPoints = outer.Positions;
  // Step 1: the decomposition.
  const Spectrum modes = Decompose(inner, outer, accuracy.MinimumSingularValue);
  // Step 2: the coefficients of a box.
  const auto count = static_cast<int>(modes.Values.size());
  this->Modes = count;
  this->Stride = RoundedUp(count);
  this->Inner = Eigen::MatrixXd::Zero(RoundedUp(modes.Right.rows()), this->Stride);
  this->Inner.topLeftCorner(modes.Right.rows(), count) = modes.Right;
  this->Expansion = Eigen::MatrixXd::Zero(RoundedUp(modes.Left.rows()), this->Stride);
  this->Expansion.topLeftCorner(modes.Left.rows(), count) =
    modes.Left * modes.Values.cwiseInverse().asDiagonal();
  this->Collected = this->Expansion.transpose();
  this->Signs.assign(8 * static_cast<std::size_t>(this->Stride), Real(1));
  for (int axes = 0; axes < 8; ++axes)
  {
    for (int mode = 0; mode < count; ++mode)
    {
      this->Signs[static_cast<std::size_t>(axes) * this->Stride + mode] =
        static_cast<Real>(Sign(axes, modes.Parities[mode]));
    }
  }

  // Step 3. In units of the parent, the child's inner cube has half edge 1 / 2.
  const Eigen::MatrixXd child = (0.5 * inner.Positions).array() - 0.5;
  const Eigen::MatrixXd up = this->Expansion.topLeftCorner(modes.Left.rows(), count).transpose() *
    (InverseDistances(outer.Positions, child) * modes.Right);
  this->FromChild = Pack<Real>(up, this->Stride, 0.0);
  // The potentials of a child are in units of the child's edge, half of the parent's.
  this->ToChild = Pack<Real>(0.5 * up.transpose(), this->Stride, 0.0);

  ParallelFor(
    Reach * Reach * Reach, 1,
    [&](int offset, int)
    {
      // Step 4. Boxes of half edge 1 are 2 apart; those that touch need no operator.
      const Eigen::RowVector3d cells(
        offset / (Reach * Reach), offset / Reach % Reach, offset % Reach);
      if (cells.maxCoeff() > 1.0)
      {
        const Eigen::MatrixXd target = inner.Positions.rowwise() + 2.0 * cells;
        const Eigen::MatrixXd matrix =
          Projected(InverseDistances(target, inner.Positions), modes, inner.Octant);
        this->Over[offset] =
          Pack<Real>(matrix, this->Stride, accuracy.MinimumEntry * matrix.cwiseAbs().maxCoeff());
      }
    },
    progress);
}

template struct FmmOperators<float>;
template struct FmmOperators<double>;

} // namespace shape
