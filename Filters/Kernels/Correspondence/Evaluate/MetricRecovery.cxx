#include "Correspondence/Evaluate/MetricRecovery.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Evaluate/Private/TriangleProducts.h"
#include "Mesh/HalfEdges.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

constexpr Eigen::Index ChunkColumns = 512;
/// Penalty of a combination that does not vary, relative to one that varies most: it decides only
/// what the operators leave open, such as the tensor's normal part.
constexpr double ConstantPenalty = 1e-3;

/// The entries on and above the diagonal of a symmetric matrix, those above scaled so that norms of
/// vectors are norms of matrices.
Eigen::VectorXd UpperEntries(const Eigen::MatrixXd& matrix)
{
  Eigen::VectorXd entries(matrix.rows() * (matrix.rows() + 1) / 2);
  Eigen::Index at = 0;
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    for (Eigen::Index row = 0; row < column; ++row)
    {
      entries(at++) = std::sqrt(0.5) * (matrix(row, column) + matrix(column, row));
    }
    entries(at++) = matrix(column, column);
  }
  return entries;
}

/// Adds `scale` times the UpperEntries of (x y^T + y x^T) / 2 to a column.
void AddProduct(const Eigen::Ref<const Eigen::RowVectorXd>& x,
  const Eigen::Ref<const Eigen::RowVectorXd>& y, double scale, Eigen::Ref<Eigen::VectorXd> column)
{
  const double above = scale * std::sqrt(0.5);
  Eigen::Index at = 0;
  for (Eigen::Index c = 0; c < x.size(); ++c)
  {
    column.segment(at, c) +=
      (above * y(c)) * x.head(c).transpose() + (above * x(c)) * y.head(c).transpose();
    at += c;
    column(at++) += scale * x(c) * y(c);
  }
}

/// Returns c with the least |system c - right|^2 + weight mean(diag) sum penalties c^2.
Eigen::VectorXd SolvePenalised(const Eigen::MatrixXd& system, const Eigen::VectorXd& right,
  const Eigen::VectorXd& penalties, double weight)
{
  Eigen::MatrixXd normal = system.transpose() * system;
  const double mean = normal.trace() / static_cast<double>(normal.rows());
  normal.diagonal() += weight * mean * penalties;
  return normal.ldlt().solve(system.transpose() * right);
}

/// The two least-squares problems, whose unknowns are coefficients of the eigenfunctions.
class MetricEquations
{
public:
  /// pairs: of the operators. modes: their combinations are the unknowns.
  MetricEquations(const Surface& first, const LaplaceEigenpairs& pairs,
    const LaplaceEigenpairs& modes, int constants)
    : First(first)
    , Functions(pairs.Eigenfunctions)
    , Modes(std::sqrt(modes.Masses.sum()) * modes.Eigenfunctions)
    , Roots(pairs.Eigenvalues.tail(pairs.Eigenvalues.size() - constants).cwiseSqrt())
    , Penalties(
        (modes.Eigenvalues / modes.Eigenvalues.maxCoeff()).array().square() + ConstantPenalty)
  {
  }

  /// Returns the ratio of areas of each triangle. mass: k x k. mean: the ratio that the penalties
  /// prefer.
  Eigen::VectorXd SolveAreas(
    const Eigen::MatrixXd& mass, double mean, double smoothness, const Progress& progress) const
  {
    const Eigen::MatrixXi& triangles = this->First.Triangles();
    const Eigen::VectorXd areas = 0.5 * this->First.AreaVectors().rowwise().norm();
    const Eigen::MatrixXd unknowns = AverageAtCorners(triangles, this->Modes);
    Eigen::VectorXd ofMean = Eigen::VectorXd::Zero(UpperEntries(mass).size());
    const Eigen::MatrixXd system = this->Accumulate(
      triangles.rows(), ofMean.size(), unknowns.cols(),
      [&](Eigen::Index t, Eigen::Ref<Eigen::VectorXd> column)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Eigen::RowVectorXd midpoint = 0.5 *
            (this->Functions.row(triangles(t, k)) + this->Functions.row(triangles(t, (k + 1) % 3)));
          AddProduct(midpoint, midpoint, areas(t) / 3.0, column);
        }
      },
      [&](Eigen::Index t, Eigen::Ref<Eigen::RowVectorXd> row) { row = unknowns.row(t); },
      Eigen::VectorXd::Ones(triangles.rows()), ofMean, progress);
    return (unknowns *
             SolvePenalised(
               system, UpperEntries(mass) - mean * ofMean, this->Penalties, smoothness))
             .array() +
      mean;
  }

  /// Returns the squared length of each edge. areas: of the triangles on the other surface.
  /// dirichlet: products of gradients of the functions that are not constant.
  Eigen::VectorXd SolveSquaredLengths(const Eigen::MatrixXd& dirichlet,
    const Eigen::VectorXd& areas, double smoothness, const Progress& progress) const
  {
    const std::vector<HalfEdge>& sides = this->First.HalfEdges();
    std::vector<std::size_t> begins; // of the half-edges of each edge
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (i == 0 || sides[i].Low() != sides[i - 1].Low() || sides[i].High() != sides[i - 1].High())
      {
        begins.push_back(i);
      }
    }
    const auto count = static_cast<Eigen::Index>(begins.size());
    begins.push_back(sides.size());
    const double mean = areas.sum() / ComputeArea(this->First);
    Eigen::MatrixXd vectors(count, 3), midpoints(count, this->Modes.cols());
    for (Eigen::Index e = 0; e < count; ++e)
    {
      const HalfEdge& side = sides[begins[e]];
      vectors.row(e) = this->First.Points().row(side.End) - this->First.Points().row(side.Begin);
      midpoints.row(e) = 0.5 * (this->Modes.row(side.Begin) + this->Modes.row(side.End));
    }
    // Divided by the root of its eigenvalue, each function has energy 1.
    const Eigen::MatrixXd functions =
      this->Functions.rightCols(this->Roots.size()) * this->Roots.cwiseInverse().asDiagonal();
    const Eigen::VectorXd right = UpperEntries(this->Roots.cwiseInverse().asDiagonal() * dirichlet *
      this->Roots.cwiseInverse().asDiagonal());
    // e C e = sum of the six entries of C, times these factors.
    const auto factors = [&](Eigen::Index e)
    {
      const Eigen::RowVector3d v = vectors.row(e);
      Eigen::Matrix<double, 1, 6> result;
      result << v.cwiseAbs2(), 2.0 * v(0) * v(1), 2.0 * v(0) * v(2), 2.0 * v(1) * v(2);
      return result;
    };
    const Eigen::Index modes = this->Modes.cols();
    const auto unknowns = [&](Eigen::Index e, Eigen::Ref<Eigen::RowVectorXd> row)
    {
      for (int c = 0; c < 6; ++c)
      {
        row.segment(c * modes, modes) = factors(e)(c) * midpoints.row(e);
      }
    };
    const Eigen::VectorXd preferred = mean * vectors.rowwise().squaredNorm();
    Eigen::VectorXd ofMean = Eigen::VectorXd::Zero(right.size());
    const Eigen::MatrixXi& triangles = this->First.Triangles();
    const Eigen::MatrixXd system = this->Accumulate(
      count, right.size(), 6 * modes,
      [&](Eigen::Index e, Eigen::Ref<Eigen::VectorXd> column)
      {
        for (std::size_t i = begins[e]; i < begins[e + 1]; ++i)
        {
          // The factor of q_k in the energy of f and g is -(f_i g_j + f_j g_i) / (8 area), where
          // f_i and f_j are the differences of f along the two other edges.
          const int t = sides[i].Triangle, corner = sides[i].Corner;
          const auto a = functions.row(triangles(t, corner)),
                     b = functions.row(triangles(t, (corner + 1) % 3)),
                     c = functions.row(triangles(t, (corner + 2) % 3));
          AddProduct(c - b, a - c, -0.25 / areas(t), column);
        }
      },
      unknowns, preferred, ofMean, progress);
    const Eigen::VectorXd found =
      SolvePenalised(system, right - ofMean, this->Penalties.replicate(6, 1), smoothness);
    Eigen::VectorXd squares = preferred;
    Eigen::RowVectorXd row(6 * modes);
    for (Eigen::Index e = 0; e < count; ++e)
    {
      unknowns(e, row);
      squares(e) += row.dot(found);
    }
    return squares;
  }

private:
  /// Returns the sum over the elements (triangles or edges) of equation(element) unknowns(element),
  /// and adds the sum of equation(element) * preferred(element) to ofPreferred.
  template <typename Equation, typename Unknowns>
  static Eigen::MatrixXd Accumulate(Eigen::Index elements, Eigen::Index rows, Eigen::Index columns,
    const Equation& equation, const Unknowns& unknowns, const Eigen::VectorXd& preferred,
    Eigen::VectorXd& ofPreferred, const Progress& progress)
  {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rows, columns);
    // Chunks are short enough for a report every half second.
    const Eigen::Index length = std::clamp<Eigen::Index>(
      Eigen::Index(1000000000) / (rows * columns), Eigen::Index(8), ChunkColumns);
    const BlasThreads threads(BlasThreads::WorthSharing(static_cast<int>(columns)));
    for (Eigen::Index begin = 0; begin < elements; begin += length)
    {
      progress(static_cast<double>(begin) / static_cast<double>(elements));
      const Eigen::Index chunk = std::min(length, elements - begin);
      Eigen::MatrixXd left = Eigen::MatrixXd::Zero(rows, chunk), right(columns, chunk);
      ParallelFor(static_cast<int>(chunk), 16,
        [&](int from, int to)
        {
          Eigen::RowVectorXd row(columns);
          for (int i = from; i < to; ++i)
          {
            equation(begin + i, left.col(i));
            unknowns(begin + i, row);
            right.col(i) = row.transpose();
          }
        });
      sum.noalias() += left * right.transpose();
      ofPreferred.noalias() += left * preferred.segment(begin, chunk);
    }
    return sum;
  }

  const Surface& First;
  const Eigen::MatrixXd& Functions;
  Eigen::MatrixXd Modes; ///< dimensionless
  Eigen::VectorXd Roots; ///< of the eigenvalues that are not 0
  Eigen::VectorXd Penalties;
};

void RequireOperators(
  const Eigen::MatrixXd& area, const Eigen::MatrixXd& conformal, int points, int components)
{
  const Eigen::Index count = area.rows();
  if (area.cols() != count || conformal.rows() != count || conformal.cols() != count)
  {
    throw InvalidInput("the operators are no square matrices of one size; connect the output "
                       "Operators of Shape Map Difference");
  }
  if (!area.allFinite() || !conformal.allFinite())
  {
    throw InvalidInput("the operators have values that are not finite; compute them again");
  }
  if (count <= components || count > points)
  {
    throw InvalidInput("the operators act on " + std::to_string(count) +
      " eigenfunctions, but the surface has " + std::to_string(points) + " points and " +
      std::to_string(components) + " components; connect the surface for which they were computed");
  }
}

} // namespace

// 1. The inner products on the other surface: those on the first one, times the operators.
// 2. Areas: the mass matrix is linear in them.
// 3. Squared lengths: the stiffness matrix is linear in them, for these areas.
RecoveredMetric RecoverMetric(const Surface& first, const Eigen::MatrixXd& area,
  const Eigen::MatrixXd& conformal, const MetricRecoveryOptions& options, const Progress& progress)
{
  RequireOption(options.Smoothness > 0.0, "Smoothness", options.Smoothness, "positive");
  const Topology topology = RequireManifold(first, "the Input");
  const auto points = static_cast<int>((topology.ComponentId.array() >= 0).count());
  RequireOperators(area, conformal, points, topology.Components);
  const auto count = static_cast<int>(area.rows());
  const Eigen::Index varying = count - topology.Components;
  const LaplaceEigenpairs pairs =
    SolveLaplaceEigenproblem(first, count, progress.Part(0.0, 0.1, "computing the eigenfunctions"));
  // Products of two of the functions vary up to twice as fast as the functions. The first of more
  // eigenfunctions may be another basis of the eigenspaces, so they do not replace `pairs`.
  const LaplaceEigenpairs modes = SolveLaplaceEigenproblem(
    first, std::min(2 * count, points), progress.Part(0.1, 0.3, "computing the eigenfunctions"));
  const TriangleProducts here = ComputeTriangleProducts(first, pairs.Eigenfunctions);
  const MetricEquations equations(first, pairs, modes, topology.Components);

  RecoveredMetric metric;
  const Eigen::VectorXd ratios = equations.SolveAreas(here.Mass * area, area.trace() / count,
    options.Smoothness, progress.Part(0.3, 0.4, "solving for the areas"));
  metric.Areas = 0.5 * ratios.cwiseProduct(first.AreaVectors().rowwise().norm());
  if (ratios.minCoeff() <= 0.0)
  {
    throw SolveFailure("the areas of " + std::to_string((ratios.array() <= 0.0).count()) +
      " triangles are recovered as negative; raise Smoothness, or compute the operators with more "
      "eigenpairs");
  }
  const Eigen::VectorXd squares =
    equations.SolveSquaredLengths(here.Dirichlet.bottomRightCorner(varying, varying) *
        conformal.bottomRightCorner(varying, varying),
      metric.Areas.cwiseMax(1e-300), options.Smoothness,
      progress.Part(0.4, 1.0, "solving for the lengths"));

  metric.Sides.resize(first.Triangles().rows(), 3);
  const std::vector<HalfEdge>& sides = first.HalfEdges();
  Eigen::Index edge = -1;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    edge +=
      i == 0 || sides[i].Low() != sides[i - 1].Low() || sides[i].High() != sides[i - 1].High();
    metric.Sides(sides[i].Triangle, (sides[i].Corner + 2) % 3) =
      std::sqrt(std::max(0.0, squares(edge)));
  }
  const Eigen::VectorXd longest = metric.Sides.rowwise().maxCoeff();
  metric.BrokenTriangles =
    static_cast<int>((2.0 * longest.array() >= metric.Sides.rowwise().sum().array()).count());
  progress(1.0);
  return metric;
}

} // namespace shape
