#include "Parameterize/ConvexCombination.h"

#include "Base/Errors.h"
#include "Base/LibraryCall.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Extent.h"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/// Minimum edge length / mean edge length, which limits the weights to what doubles can add up.
constexpr double ShortestEdge = 1e-6;

/// Returns tan(a / 2) from the cotangent of a in (0, pi).
double HalfTangent(double cotangent)
{
  const double root = std::hypot(1.0, cotangent);
  // tan(a / 2) = csc a - cot a. For a positive cotangent this difference would cancel.
  return cotangent > 0.0 ? 1.0 / (root + cotangent) : root - cotangent;
}

double EdgeLength(const Mesh& surface, int a, int b)
{
  return (surface.Points.row(a) - surface.Points.row(b)).norm();
}

/// Returns the matrix of the equations sum_j w_ij (x_i - x_j) = 0 with mean value weights.
Eigen::SparseMatrix<double> MeanValueMatrix(const Mesh& surface)
{
  const Eigen::MatrixXd cotangents = ComputeTriangleAngles(surface).Cotangents;
  const double shortest = ShortestEdge * ComputeMeanEdgeLength(surface);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * surface.Triangles.rows());
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int i = surface.Triangles(t, corner);
      // Floater 2003, equation 2.1: the angle at i contributes to both of its edges.
      const double tangent = HalfTangent(cotangents(t, corner));
      for (const int side : { 1, 2 })
      {
        const int j = surface.Triangles(t, (corner + side) % 3);
        // If all points coincide, all weights are equal.
        const double length = std::max(EdgeLength(surface, i, j), shortest);
        const double weight = length > 0.0 ? tangent / length : tangent;
        entries.emplace_back(i, j, -weight);
        entries.emplace_back(i, i, weight);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(surface.Points.rows(), surface.Points.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::SparseMatrix<double> MatrixOf(const Mesh& surface, CombinationWeights weights)
{
  switch (weights)
  {
    case CombinationWeights::Uniform:
      // One half from each of the two triangles: the weight of an inner edge is 1.
      return BuildCotangentStiffness(surface.Triangles,
        Eigen::MatrixXd::Ones(surface.Triangles.rows(), 3), surface.Points.rows());
    case CombinationWeights::Cotangent:
      return BuildCotangentStiffness(
        surface.Triangles, ComputeTriangleAngles(surface).Cotangents, surface.Points.rows());
    case CombinationWeights::MeanValue:
      break;
  }
  return MeanValueMatrix(surface);
}

/// The rows of the matrix for the free points, split into two parts: a x_free = b.
struct FreeEquations
{
  Eigen::SparseMatrix<double> A;
  Eigen::MatrixXd B;
};

/// position: for each point its row among the free points, or -1 - its row among the fixed points.
FreeEquations EquationsOf(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<int>& position, int count, const Eigen::MatrixXd& positions)
{
  FreeEquations equations{ Eigen::SparseMatrix<double>(count, count),
    Eigen::MatrixXd::Zero(count, positions.cols()) };
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(matrix.nonZeros());
  for (int column = 0; column < matrix.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
    {
      const int row = position[entry.row()];
      if (row >= 0 && position[column] >= 0)
      {
        entries.emplace_back(row, position[column], entry.value());
      }
      else if (row >= 0)
      {
        equations.B.row(row) -= entry.value() * positions.row(-1 - position[column]);
      }
    }
  }
  equations.A.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

/// Solves by LU factorisation in Eigen's default order (COLAMD). For these matrices it is a hundred
/// times faster than in the order of a symmetric pattern. BiCGSTAB is not faster, and the tolerance
/// at which it stops would flip small triangles.
Eigen::MatrixXd SolveRows(const FreeEquations& equations, const Progress& progress)
{
  // The weights of different points vary with their edge lengths, so each row is scaled to diagonal
  // 1.
  const Eigen::VectorXd scale = equations.A.diagonal().cwiseInverse();
  const Eigen::SparseMatrix<double> a = scale.asDiagonal() * equations.A;
  const Eigen::MatrixXd right = scale.asDiagonal() * equations.B;
  Eigen::MatrixXd solution = right;
  bool unique = false;
  constexpr double operationsOfARow = 1e6;
  RunInterruptibly(
    [&]
    {
      Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
      solver.compute(a);
      unique = solver.info() == Eigen::Success;
      if (unique)
      {
        solution = solver.solve(right);
      }
    },
    operationsOfARow * static_cast<double>(a.rows()),
    { { &unique, sizeof(unique) }, { solution.data(), solution.size() * sizeof(double) } },
    progress);
  if (!unique)
  {
    throw SolveFailure("the equations of the mean value weights have no unique solution; remove "
                       "triangles without area");
  }
  return solution;
}

} // namespace

Eigen::MatrixXd SolveConvexCombination(const Mesh& surface, CombinationWeights weights,
  const std::vector<int>& fixed, const Eigen::MatrixXd& positions, const Progress& progress)
{
  progress(0.0);
  // Points are numbered as free or fixed. The matrix is split into the free rows and columns, and
  // the right side of the fixed columns.
  std::vector<int> position(surface.Points.rows(), 0);
  Eigen::MatrixXd all(surface.Points.rows(), positions.cols());
  for (std::size_t k = 0; k < fixed.size(); ++k)
  {
    position[fixed[k]] = -1 - static_cast<int>(k);
    all.row(fixed[k]) = positions.row(k);
  }
  int count = 0;
  for (int& row : position)
  {
    row = row < 0 ? row : count++;
  }
  if (count > 0)
  {
    const FreeEquations equations =
      EquationsOf(MatrixOf(surface, weights), position, count, positions);
    progress(0.3);
    Eigen::MatrixXd free;
    // Mean value weights are not symmetric, so they need LU instead of Cholesky.
    if (weights == CombinationWeights::MeanValue)
    {
      free = SolveRows(equations, progress.Part(0.3, 1.0));
    }
    else
    {
      SparseCholesky solver;
      solver.Factorize(equations.A, progress.Part(0.3, 0.9));
      free = solver.Solve(equations.B);
    }
    for (std::size_t i = 0; i < position.size(); ++i)
    {
      if (position[i] >= 0)
      {
        all.row(i) = free.row(position[i]);
      }
    }
  }
  progress(1.0);
  return all;
}

} // namespace shape
