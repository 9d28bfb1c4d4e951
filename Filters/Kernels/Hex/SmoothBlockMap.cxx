#include "Hex/SmoothBlockMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Hex/Features/LostCreases.h"
#include "Hex/Private/BoundarySplines.h"
#include "Hex/Private/HarmonicExtension.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Extent.h"
#include "Mesh/HexMesh.h"
#include "Quality/ScaledJacobian.h"
#include "Remesh/SurfaceFeatures.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace shape
{
namespace
{

using Eigen::MatrixXd;
using Eigen::RowVector3d;
using Sparse = Eigen::SparseMatrix<double>;

/// Positions nearer than this, as a fraction of the diagonal, coincide.
constexpr double Coincident = 1e-7;
/// Rounds of step 2, and their factor of second differences. On the ellipsoid, the sphere and the
/// blob-closed of CGAL, the largest errors before the second fit were 7.4e-4, 9.7e-4 and 7.8e-4
/// with 1e-3, and 8.0e-4, 1.1e-3 and 9.7e-4 with 1e-2.
constexpr int WeightedRounds = 20;
constexpr double WeightedFactor = 1e-3;

/// The surface and its creases, and how the points of the boundary are bound to them.
class SlidingPoints
{
public:
  SlidingPoints(const Eigen::MatrixXi& quads, const MatrixXd& positions, const Surface& surface,
    double featureAngle)
    : Given(positions)
    , OnSurface(surface)
    , Tolerance(Coincident * ComputeBoxDiagonal(surface))
    , FreedomOf(positions.rows(), 3)
  {
    for (const int point : quads.reshaped())
    {
      this->FreedomOf[point] = 2;
    }
    const SurfaceFeatures features = FindFeatures(surface, featureAngle, 0.0);
    if (!features.Curves.empty())
    {
      this->OnCreases.emplace(BuildFlatTriangles(BuildCreaseLines(surface, features)));
      this->BindToCreases(quads, MatrixXd(surface.Points()(features.Corners, Eigen::all)));
    }
  }

  /// The nearest allowed position, and the unit directions (rows) in which a distance from it is to
  /// be avoided.
  struct Target
  {
    RowVector3d Position;
    MatrixXd Directions;
  };

  Target Find(int point, const RowVector3d& at) const
  {
    const int freedom = this->FreedomOf[point];
    if (freedom == 0)
    {
      return { this->Given.row(point), Eigen::Matrix3d::Identity() };
    }
    const SurfaceLocator& locator = freedom == 1 ? *this->OnCreases : this->OnSurface;
    const ClosestPoint found = locator.FindOne(at);
    const Eigen::Matrix3d corners = GetCorners(locator.GetSurface(), found.Triangle);
    Target target{ found.Position, MatrixXd(3 - freedom, 3) };
    if (freedom == 1)
    {
      const Eigen::Vector3d tangent = (corners.row(1) - corners.row(0)).normalized();
      const Eigen::Vector3d one = tangent.unitOrthogonal();
      target.Directions << one.transpose(), tangent.cross(one).transpose();
      return target;
    }
    // At an edge of the surface, planes through it are tangent: the one across the distance is.
    const RowVector3d away = at - found.Position;
    target.Directions = found.Distance > this->Tolerance
      ? RowVector3d(away / found.Distance)
      : RowVector3d(
          (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).normalized());
    return target;
  }

private:
  void BindToCreases(const Eigen::MatrixXi& quads, const MatrixXd& corners)
  {
    constexpr double sagitta = 0.125; // of an edge along a crease, as a fraction of its length
    const auto distance = [&](const RowVector3d& at)
    { return this->OnCreases->FindOne(at).Distance; };
    std::vector<char> isOn(this->FreedomOf.size(), 0);
    std::set<std::pair<int, int>> edges;
    for (Eigen::Index quad = 0; quad < quads.rows(); ++quad)
    {
      for (int k = 0; k < 4; ++k)
      {
        edges.insert(std::minmax(quads(quad, k), quads(quad, (k + 1) % 4)));
      }
    }
    for (std::size_t point = 0; point < isOn.size(); ++point)
    {
      isOn[point] = this->FreedomOf[point] == 2 &&
        distance(this->Given.row(static_cast<Eigen::Index>(point))) <= this->Tolerance;
    }
    std::vector<int> along(isOn.size(), 0);
    for (const auto& [a, b] : edges)
    {
      const RowVector3d one = this->Given.row(a), other = this->Given.row(b);
      if (isOn[a] && isOn[b] && distance(0.5 * (one + other)) <= sagitta * (one - other).norm())
      {
        ++along[a];
        ++along[b];
      }
    }
    for (std::size_t point = 0; point < isOn.size(); ++point)
    {
      if (isOn[point])
      {
        const RowVector3d at = this->Given.row(static_cast<Eigen::Index>(point));
        const bool isCorner = along[point] != 2 ||
          (corners.rows() > 0 &&
            (corners.rowwise() - at).rowwise().norm().minCoeff() <= this->Tolerance);
        this->FreedomOf[point] = isCorner ? 0 : 1;
      }
    }
  }

  const MatrixXd& Given;
  SurfaceLocator OnSurface;
  std::optional<SurfaceLocator> OnCreases;
  double Tolerance;
  std::vector<int> FreedomOf; ///< 0 if a point is held, 1 on a crease, 2 on the surface, 3 inside
};

/// The control points of the boundary, and the steps of steps 1 and 2.
class TangentDistances
{
public:
  TangentDistances(
    const BoundarySplines& splines, const SlidingPoints& sliding, const MatrixXd& targets)
    : Splines(splines)
    , Sliding(sliding)
    , Gram(Sparse(splines.Basis.transpose()) * splines.Basis)
    , Bending(Sparse(splines.Differences.transpose()) * splines.Differences)
    , Weights(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(splines.Points.size())))
  {
    SparseCholesky solver;
    Sparse identity(this->Gram.rows(), this->Gram.rows());
    identity.setIdentity();
    solver.Factorize(this->Gram + Regularisation * identity);
    this->Controls = solver.Solve(Sparse(splines.Basis.transpose()) * targets);
  }

  /// The positions on the splines: one row for each point of the grid, 0 inside.
  MatrixXd Positions() const { return this->Splines.Basis * this->Controls; }

  /// Raises the weights of points that are farther from their targets than the mean, and lowers the
  /// others. distances: > 0 for at least one of the points on the boundary.
  void Reweight(const Eigen::VectorXd& distances)
  {
    // Lawson's factor is the distance itself. Then weights vanish, and points slide where they
    // like.
    constexpr double largest = 10.0;
    this->Weights.array() *= (distances.array() / distances.mean()).sqrt();
    this->Weights =
      (this->Weights / this->Weights.mean()).cwiseMax(1.0 / largest).cwiseMin(largest);
  }

  /// One Gauss-Newton step for this factor of second differences.
  void Step(double factor, const Progress& progress)
  {
    const MatrixXd now = this->Positions();
    const auto& points = this->Splines.Points;
    std::vector<SlidingPoints::Target> targets(points.size());
    constexpr int grain = 64;
    ParallelFor(
      static_cast<int>(points.size()), grain,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          targets[i] = this->Sliding.Find(points[i], now.row(points[i]));
        }
      },
      progress);
    const Eigen::SparseMatrix<double, Eigen::RowMajor> basis = this->Splines.Basis;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> wanted;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double root = std::sqrt(this->Weights(static_cast<Eigen::Index>(i)));
      for (Eigen::Index k = 0; k < targets[i].Directions.rows(); ++k)
      {
        const RowVector3d direction = root * targets[i].Directions.row(k);
        for (decltype(basis)::InnerIterator at(basis, points[i]); at; ++at)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            entries.emplace_back(static_cast<int>(wanted.size()),
              static_cast<int>(3 * at.col() + axis), at.value() * direction(axis));
          }
        }
        wanted.push_back(direction.dot(targets[i].Position));
      }
    }
    const Eigen::Index unknowns = 3 * this->Controls.rows();
    Sparse rows(static_cast<Eigen::Index>(wanted.size()), unknowns);
    rows.setFromTriplets(entries.begin(), entries.end());
    const Sparse normal = Sparse(rows.transpose()) * rows +
      ForEachAxis(factor * (this->Bending + Damping * this->Gram), Regularisation);
    const MatrixXd kept = factor * Damping * (this->Gram * this->Controls);
    const Eigen::VectorXd right =
      rows.transpose() * Eigen::Map<const Eigen::VectorXd>(wanted.data(), rows.rows()) +
      kept.transpose().reshaped();
    this->Solver.Factorize(normal, progress);
    this->Controls =
      this->Solver.Solve(right, progress).reshaped(3, this->Controls.rows()).transpose();
  }

private:
  static constexpr double Damping = 1e-3; ///< of motions, relative to the factor
  static constexpr double Regularisation = 1e-10;

  /// The matrix that applies another one to each of three components, plus a multiple of 1.
  static Sparse ForEachAxis(const Sparse& matrix, double diagonal)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < static_cast<int>(matrix.cols()); ++column)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        for (Sparse::InnerIterator at(matrix, column); at; ++at)
        {
          entries.emplace_back(
            static_cast<int>(3 * at.row() + axis), 3 * column + axis, at.value());
        }
        entries.emplace_back(3 * column + axis, 3 * column + axis, diagonal);
      }
    }
    Sparse result(3 * matrix.rows(), 3 * matrix.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  const BoundarySplines& Splines;
  const SlidingPoints& Sliding;
  Sparse Gram, Bending;
  Eigen::VectorXd Weights; ///< of the points on the boundary
  MatrixXd Controls;
  SparseCholesky Solver;
};

int CountInvertedCells(const Eigen::MatrixXi& cells, const MatrixXd& positions)
{
  return static_cast<int>((ComputeScaledJacobians({ positions, cells }).array() <= 0.0).count());
}

} // namespace

MatrixXd EvaluateAtNodes(const std::vector<GridBlock>& blocks, const MatrixXd& targets,
  const BlockSplineOptions& options, const Progress& progress)
{
  MatrixXd positions = targets;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    progress(static_cast<double>(i) / static_cast<double>(blocks.size()));
    const GridBlock& block = blocks[i];
    positions(block.Nodes, Eigen::all) =
      Evaluate(FitBlockSpline(block.Counts, targets(block.Nodes, Eigen::all), options),
        NodeParameters(block.Counts));
  }
  return positions;
}

void RequireInRange(const SmoothBlockMapOptions& options)
{
  RequireOption(options.FeatureAngle > 0.0 && options.FeatureAngle <= 180.0, "FeatureAngle",
    options.FeatureAngle, "in (0, 180]");
}

SmoothBlockMap SmoothMapOfBlocks(const std::vector<GridBlock>& blocks, const Eigen::MatrixXi& cells,
  const MatrixXd& targets, const Surface& surface, const SmoothBlockMapOptions& options,
  const Progress& progress)
{
  RequireInRange(options);
  const SlidingPoints sliding(
    FindBoundaryQuads({ targets, cells }), targets, surface, options.FeatureAngle);
  const BoundarySplines splines(blocks, targets.rows(), options);
  progress(0.05);
  std::vector<char> isOuter(targets.rows(), 0);
  for (const int point : splines.Points)
  {
    isOuter[point] = 1;
  }
  const HarmonicExtension extension(ListHexEdges(cells), isOuter, progress.Part(0.05, 0.2));
  const int invertedBefore = CountInvertedCells(cells, targets);
  SmoothBlockMap best{ targets, EvaluateAtNodes(blocks, targets, options), 0.0, invertedBefore };
  double smallest = (best.Splines - targets).rowwise().norm().maxCoeff();
  TangentDistances fit(splines, sliding, targets);
  constexpr double first = 0.2;
  const double factors[] = { 1.0, 0.1, 0.01, 1e-3, 1e-4 };
  const int unweighted = static_cast<int>(std::size(factors));
  const int rounds = unweighted + WeightedRounds;
  for (int round = 0; round < rounds; ++round)
  {
    const auto share = [&](double part) { return first + (1.0 - first) * (round + part) / rounds; };
    const double factor = round < unweighted ? factors[round] : WeightedFactor;
    fit.Step(factor, progress.Part(share(0.0), share(0.3)));
    fit.Step(factor, progress.Part(share(0.3), share(0.6)));
    const MatrixXd outer = fit.Positions();
    MatrixXd motion = MatrixXd::Zero(targets.rows(), 3);
    motion(splines.Points, Eigen::all) =
      outer(splines.Points, Eigen::all) - targets(splines.Points, Eigen::all);
    extension.Extend(motion, progress.Part(share(0.6), share(0.7)));
    const MatrixXd fitted =
      EvaluateAtNodes(blocks, targets + motion, options, progress.Part(share(0.7), share(0.9)));
    MatrixXd positions = fitted;
    for (const int point : splines.Points)
    {
      positions.row(point) = sliding.Find(point, outer.row(point)).Position;
    }
    const Eigen::VectorXd distances =
      (fitted - positions)(splines.Points, Eigen::all).rowwise().norm();
    const int inverted = CountInvertedCells(cells, positions);
    const auto takeIfNearer = [&](const MatrixXd& onSplines)
    {
      const double largest = (onSplines - positions).rowwise().norm().maxCoeff();
      if (largest < smallest)
      {
        smallest = largest;
        best = { positions, onSplines, (positions - targets).rowwise().norm().maxCoeff(),
          inverted };
      }
    };
    if (inverted <= invertedBefore)
    {
      takeIfNearer(fitted);
      // Splines fitted again to the points on the surface can be nearer, because all points of the
      // boundary then have the same weight.
      takeIfNearer(EvaluateAtNodes(blocks, positions, options));
    }
    if (round + 1 >= unweighted && distances.maxCoeff() > 0.0)
    {
      fit.Reweight(distances);
    }
    progress(share(1.0));
  }
  return best;
}

} // namespace shape
