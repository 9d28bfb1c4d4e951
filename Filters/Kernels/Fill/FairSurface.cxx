#include "Fill/FairSurface.h"

#include "Base/Errors.h"
#include "Linear/SparseSolve.h"
#include "Geometry/PatchNormals.h"
#include "Laplacian/CotangentWeights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shape
{
namespace
{

using Sparse = Eigen::SparseMatrix<double>;
using Eigen::RowVector3d;

/// Voronoi areas of the points (n), at the rim on the patch's side; at least a tenth of what a
/// third of each triangle gives.
Eigen::VectorXd VoronoiAreas(const Mesh& patch, const TriangleAngles& angles)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(patch.Points.rows());
  for (Eigen::Index t = 0; t < patch.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = patch.Triangles(t, (k + 1) % 3), to = patch.Triangles(t, (k + 2) % 3);
      const double share = 0.125 * angles.Cotangents(t, k) *
        (patch.Points.row(to) - patch.Points.row(from)).squaredNorm();
      areas(from) += share;
      areas(to) += share;
    }
  }
  return areas.cwiseMax(0.1 * LumpedMasses(patch.Triangles, angles.Areas, patch.Points.rows()));
}

/// The patch's geometry at one iteration.
struct Geometry
{
  Sparse Stiffness;           ///< n x n
  Eigen::VectorXd Areas;      ///< n
  Eigen::MatrixXd Normals;    ///< n x 3
  Eigen::VectorXd Curvature;  ///< n: the mean of the principal curvatures
  Eigen::VectorXd SecondForm; ///< n: the sum of their squares, at most four times the median
};

Geometry Measure(const Mesh& patch, const Eigen::MatrixXd& rimNormals)
{
  const Eigen::Index points = patch.Points.rows();
  const TriangleAngles angles = AnglesOfTriangles(patch);
  Geometry is;
  is.Stiffness = CotangentStiffness(patch.Triangles, angles.Cotangents, points);
  is.Areas = VoronoiAreas(patch, angles);
  const double least = 1e-12 * is.Areas.mean();
  is.Areas = is.Areas.cwiseMax(std::max(least, std::numeric_limits<double>::min()));
  is.Normals = MaxNormals(patch);
  is.Normals.topRows(rimNormals.rows()) = rimNormals;
  const Eigen::MatrixXd laplacian = is.Stiffness * patch.Points;
  is.Curvature = laplacian.cwiseProduct(is.Normals).rowwise().sum().cwiseQuotient(2.0 * is.Areas);
  is.SecondForm = Eigen::VectorXd::Zero(points);
  for (int column = 0; column < is.Stiffness.outerSize(); ++column)
  {
    for (Sparse::InnerIterator entry(is.Stiffness, column); entry; ++entry)
    {
      const auto row = static_cast<int>(entry.row());
      is.SecondForm(row) -=
        0.5 * entry.value() * (is.Normals.row(row) - is.Normals.row(column)).squaredNorm();
    }
  }
  is.SecondForm = is.SecondForm.cwiseQuotient(is.Areas).cwiseMax(0.0);
  std::vector<double> sorted(is.SecondForm.begin(), is.SecondForm.end());
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  is.SecondForm = is.SecondForm.cwiseMin(4.0 * sorted[sorted.size() / 2]);
  return is;
}

/// A matrix with its rows scaled.
Sparse WithRowsScaled(Sparse matrix, const Eigen::VectorXd& scales)
{
  for (int column = 0; column < matrix.outerSize(); ++column)
  {
    for (Sparse::InnerIterator entry(matrix, column); entry; ++entry)
    {
      entry.valueRef() *= scales(entry.row());
    }
  }
  return matrix;
}

/// The rows and columns of the points after the rim.
Sparse Inner(const Sparse& all, Eigen::Index rim)
{
  const Eigen::Index inner = all.rows() - rim;
  return all.bottomRightCorner(inner, inner);
}

/// Solves Newton's equation: how far points move along their normals.
class NewtonStep
{
public:
  /// cautious: shorter steps, of what is sure to be positive definite. again: with the derivative
  /// of the last time.
  Eigen::VectorXd Find(const Geometry& is, Eigen::Index rim, bool cautious, bool again)
  {
    const Eigen::Index inner = is.Areas.size() - rim;
    const Eigen::VectorXd residual = -(is.Stiffness * is.Curvature).tail(inner);
    if (again)
    {
      return this->Solver.Solve(2.0 * residual);
    }
    const Sparse bending = is.Stiffness * WithRowsScaled(is.Stiffness, is.Areas.cwiseInverse());
    const Sparse turned = WithRowsScaled(is.Stiffness, is.SecondForm);
    const Sparse squares = turned.transpose();
    const Sparse plain = Inner(bending, rim);
    const Sparse derivative = plain - 0.5 * Inner(squares + turned, rim);
    Eigen::VectorXd step;
    // Where the surface bends much over its width the derivative may not be positive definite.
    if ((cautious || !this->TrySolve(derivative, 2.0 * residual, step)) &&
      !this->TrySolve(plain, 2.0 * residual, step))
    {
      throw SolveFailure("the fair surface's equation has no solution; look for triangles "
                         "without area around the hole");
    }
    return step;
  }

private:
  bool TrySolve(const Sparse& matrix, const Eigen::VectorXd& right, Eigen::VectorXd& solution)
  {
    try
    {
      this->Solver.Factorize(matrix);
    }
    catch (const SolveFailure&)
    {
      return false;
    }
    solution = this->Solver.Solve(right);
    return solution.allFinite();
  }

  SparseCholesky Solver;
};

/// The share of a step after which no edge has turned by more than about 45 degrees.
double SafeShare(const Mesh& patch, const Eigen::VectorXd& step, Eigen::Index rim)
{
  double steepest = 0.0;
  const auto moved = [&](int point) { return point < rim ? 0.0 : step(point - rim); };
  for (const auto& triangle : patch.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangle(k), b = triangle((k + 1) % 3);
      const double length = (patch.Points.row(b) - patch.Points.row(a)).norm();
      if (length > 0.0)
      {
        steepest = std::max(steepest, std::abs(moved(b) - moved(a)) / length);
      }
    }
  }
  return steepest > 1.0 ? 1.0 / steepest : 1.0;
}

double MeanRimEdge(const Eigen::MatrixXd& points, Eigen::Index rim)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < rim; ++i)
  {
    sum += (points.row((i + 1) % rim) - points.row(i)).norm();
  }
  return sum / static_cast<double>(rim);
}

} // namespace

Eigen::MatrixXd BiharmonicSurface(const Mesh& disk, const SurfaceRim& rim)
{
  const Eigen::Index points = disk.Points.rows(), corners = rim.Points.rows();
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(points, 3);
  places.topRows(corners) = rim.Points;
  if (points == corners)
  {
    return places;
  }
  const TriangleAngles angles = AnglesOfTriangles(disk);
  const Sparse stiffness = CotangentStiffness(disk.Triangles, angles.Cotangents, points);
  Eigen::VectorXd masses = LumpedMasses(disk.Triangles, angles.Areas, points);
  masses = masses.cwiseMax(1e-9 * masses.mean());
  // What flows over the rim: its conormals, out of the patch, times the length that each point has.
  Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(points, 3);
  for (Eigen::Index i = 0; i < corners; ++i)
  {
    const Eigen::Index next = (i + 1) % corners;
    const RowVector3d side = rim.Points.row(next) - rim.Points.row(i);
    const RowVector3d normal = (rim.Normals.row(i) + rim.Normals.row(next)).stableNormalized();
    flux.row(i) += 0.5 * side.cross(normal);
    flux.row(next) += 0.5 * side.cross(normal);
  }
  const Sparse weighted = WithRowsScaled(stiffness, masses.cwiseInverse()).transpose();
  SparseCholesky solver;
  solver.Factorize(Inner(Sparse(weighted * stiffness), corners));
  const Eigen::MatrixXd right = weighted * (flux - stiffness * places);
  places.bottomRows(points - corners) = solver.Solve(right.bottomRows(points - corners));
  return places;
}

FairSurfaceResult FairSurface(const Mesh& start, const Eigen::MatrixXd& rimNormals,
  const FairSurfaceOptions& options, const Progress& progress)
{
  const Eigen::Index rim = rimNormals.rows(), inner = start.Points.rows() - rim;
  Mesh patch = start;
  FairSurfaceResult result{ start.Points, 0, inner == 0 };
  double least = std::numeric_limits<double>::infinity(), last = least;
  double share = 1.0, taken = 1.0, lastLength = least;
  const double enough = options.Tolerance * MeanRimEdge(start.Points, rim);
  NewtonStep newton;
  bool isNear = false; // so near that the derivative changes hardly any more
  constexpr double leastShare = 0.25;
  int stalls = 0;
  while (!result.Converged && stalls < 2 && result.Iterations < options.MaximumIterations)
  {
    const double begin = static_cast<double>(result.Iterations) / options.MaximumIterations;
    progress(begin);
    const Geometry is = Measure(patch, rimNormals);
    progress(begin);
    const double energy = is.Curvature.dot(is.Stiffness * is.Curvature);
    if (energy < least)
    {
      least = energy;
      result.Points = patch.Points;
    }
    const Eigen::VectorXd step = newton.Find(is, rim, energy > last, isNear && energy <= last);
    last = energy;
    // Steps that do not become shorter, as they should by what was taken of the last one, go to and
    // fro.
    const double length = step.cwiseAbs().maxCoeff();
    const bool goesAstray = length > (1.0 - 0.3 * taken) * lastLength;
    stalls = share == leastShare && goesAstray ? stalls + 1 : 0;
    share = goesAstray ? std::max(leastShare, 0.5 * share) : std::min(1.0, 2.0 * share);
    constexpr double nearby = 0.1;
    isNear = length <= nearby * enough / options.Tolerance && length <= 0.8 * lastLength;
    lastLength = length;
    taken = std::min(share, SafeShare(patch, step, rim));
    patch.Points.bottomRows(inner) += (taken * step).asDiagonal() * is.Normals.bottomRows(inner);
    ++result.Iterations;
    if (length <= enough)
    {
      result.Converged = true;
      result.Points = patch.Points;
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
