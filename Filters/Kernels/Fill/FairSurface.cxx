#include "Fill/FairSurface.h"

#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"

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

/// Voronoi areas of the points (n); at the loop, within the patch only. Each is at least a tenth of
/// a third of the area of the triangles around.
Eigen::VectorXd VoronoiAreas(const Mesh& patch, const TriangleAngles& angles)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(patch.Points.rows());
  for (Eigen::Index t = 0; t < patch.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = patch.Triangles(t, (k + 1) % 3), to = patch.Triangles(t, (k + 2) % 3);
      // A Voronoi area is the sum of cotangent times squared length over 8, of both angles opposite
      // each edge. It may be negative at obtuse triangles, hence the lower limit.
      const double share = 0.125 * angles.Cotangents(t, k) *
        (patch.Points.row(to) - patch.Points.row(from)).squaredNorm();
      areas(from) += share;
      areas(to) += share;
    }
  }
  return areas.cwiseMax(
    0.1 * ComputeLumpedMasses(patch.Triangles, angles.Areas, patch.Points.rows()));
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

Geometry Measure(const Mesh& patch, const Eigen::MatrixXd& loopNormals)
{
  const Eigen::Index points = patch.Points.rows();
  const TriangleAngles angles = ComputeTriangleAngles(patch);
  Geometry is;
  is.Stiffness = BuildCotangentStiffness(patch.Triangles, angles.Cotangents, points);
  is.Areas = VoronoiAreas(patch, angles);
  const double minimum = 1e-12 * is.Areas.mean();
  is.Areas = is.Areas.cwiseMax(std::max(minimum, std::numeric_limits<double>::min()));
  is.Normals = ComputeVertexNormals(patch, NormalWeight::Max);
  is.Normals.topRows(loopNormals.rows()) = loopNormals;
  // The cotangent Laplacian of the positions is 2 H n times the area.
  const Eigen::MatrixXd laplacian = is.Stiffness * patch.Points;
  is.Curvature = laplacian.cwiseProduct(is.Normals).rowwise().sum().cwiseQuotient(2.0 * is.Areas);
  is.SecondForm = Eigen::VectorXd::Zero(points);
  for (int column = 0; column < is.Stiffness.outerSize(); ++column)
  {
    for (Sparse::InnerIterator entry(is.Stiffness, column); entry; ++entry)
    {
      const auto row = static_cast<int>(entry.row());
      // k1^2 + k2^2 is the Dirichlet energy density of the normals. Half of an edge's energy
      // belongs to each end.
      is.SecondForm(row) -=
        0.5 * entry.value() * (is.Normals.row(row) - is.Normals.row(column)).squaredNorm();
    }
  }
  is.SecondForm = is.SecondForm.cwiseQuotient(is.Areas).cwiseMax(0.0);
  std::vector<double> sorted(is.SecondForm.begin(), is.SecondForm.end());
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  // The limit keeps single creased triangles from making the derivative indefinite.
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

/// The rows and columns of the points after the loop.
Sparse Inner(const Sparse& all, Eigen::Index loop)
{
  const Eigen::Index inner = all.rows() - loop;
  return all.bottomRightCorner(inner, inner);
}

/// Solves Newton's equation for the movement of points along their normals.
class NewtonStep
{
public:
  /// cautious: take shorter steps, from a matrix that is certainly positive definite. again: reuse
  /// the last derivative.
  /// The equation is S H = 0 at the inner points: H is harmonic. A movement u along the normals
  /// changes H by (M^-1 S u - K u) / 2, with K = k1^2 + k2^2. Newton's equation is therefore
  /// (S M^-1 S - S K) u = -2 S H. S K is made symmetric, so that a Cholesky factorisation applies.
  Eigen::VectorXd Find(
    const Geometry& is, Eigen::Index loop, bool cautious, bool again, const Progress& progress)
  {
    const Eigen::Index inner = is.Areas.size() - loop;
    const Eigen::VectorXd residual = -(is.Stiffness * is.Curvature).tail(inner);
    if (again)
    {
      return this->Solver.Solve(2.0 * residual);
    }
    const Sparse bending = is.Stiffness * WithRowsScaled(is.Stiffness, is.Areas.cwiseInverse());
    const Sparse turned = WithRowsScaled(is.Stiffness, is.SecondForm);
    const Sparse squares = turned.transpose();
    const Sparse plain = Inner(bending, loop);
    const Sparse derivative = plain - 0.5 * Inner(squares + turned, loop);
    Eigen::VectorXd step;
    // If the surface bends strongly over its width, the derivative may not be positive definite.
    if ((cautious || !this->TrySolve(derivative, 2.0 * residual, step, progress)) &&
      !this->TrySolve(plain, 2.0 * residual, step, progress))
    {
      throw SolveFailure("the fair surface's equation has no solution; look for triangles "
                         "without area around the hole");
    }
    return step;
  }

private:
  bool TrySolve(const Sparse& matrix, const Eigen::VectorXd& right, Eigen::VectorXd& solution,
    const Progress& progress)
  {
    try
    {
      this->Solver.Factorize(matrix, progress);
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
double SafeShare(const Mesh& patch, const Eigen::VectorXd& step, Eigen::Index loop)
{
  double steepest = 0.0;
  const auto moved = [&](int point) { return point < loop ? 0.0 : step(point - loop); };
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

double MeanLoopEdge(const Eigen::MatrixXd& points, Eigen::Index loop)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop; ++i)
  {
    sum += (points.row((i + 1) % loop) - points.row(i)).norm();
  }
  return sum / static_cast<double>(loop);
}

} // namespace

/// Mixed finite elements: M L = S x - flux defines the Laplacian L, also at the loop, and S L = 0
/// at the inner points is the equation.
Eigen::MatrixXd SolveBiharmonicSurface(
  const Mesh& disk, const BoundaryLoop& loop, const Progress& progress)
{
  const Eigen::Index points = disk.Points.rows(), corners = loop.Points.rows();
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(points, 3);
  positions.topRows(corners) = loop.Points;
  if (points == corners)
  {
    return positions;
  }
  const TriangleAngles angles = ComputeTriangleAngles(disk);
  const Sparse stiffness = BuildCotangentStiffness(disk.Triangles, angles.Cotangents, points);
  Eigen::VectorXd masses = ComputeLumpedMasses(disk.Triangles, angles.Areas, points);
  masses = masses.cwiseMax(1e-9 * masses.mean());
  // The flux over the boundary: its outward conormals times the length that belongs to each point.
  Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(points, 3);
  for (Eigen::Index i = 0; i < corners; ++i)
  {
    const Eigen::Index next = (i + 1) % corners;
    const RowVector3d side = loop.Points.row(next) - loop.Points.row(i);
    const RowVector3d normal = (loop.Normals.row(i) + loop.Normals.row(next)).stableNormalized();
    flux.row(i) += 0.5 * side.cross(normal);
    flux.row(next) += 0.5 * side.cross(normal);
  }
  const Sparse weighted = WithRowsScaled(stiffness, masses.cwiseInverse()).transpose();
  SparseCholesky solver;
  solver.Factorize(Inner(Sparse(weighted * stiffness), corners), progress);
  const Eigen::MatrixXd right = weighted * (flux - stiffness * positions);
  positions.bottomRows(points - corners) = solver.Solve(right.bottomRows(points - corners));
  return positions;
}

/// Newton's method with step control: a step is cut if it bends edges too much (SafeShare), and the
/// share is halved if steps do not become shorter. Without convergence the best surface met is the
/// result.
FairSurfaceResult SolveFairSurface(const Mesh& start, const Eigen::MatrixXd& loopNormals,
  const FairSurfaceOptions& options, const Progress& progress)
{
  const Eigen::Index loop = loopNormals.rows(), inner = start.Points.rows() - loop;
  Mesh patch = start;
  FairSurfaceResult result{ start.Points, 0, inner == 0 };
  double minimum = std::numeric_limits<double>::infinity(), last = minimum;
  double share = 1.0, taken = 1.0, lastLength = minimum;
  const double enough = options.Tolerance * MeanLoopEdge(start.Points, loop);
  NewtonStep newton;
  bool isNear = false; // so near that the derivative hardly changes
  // The iteration has stalled if two steps in a row at this share do not become shorter.
  constexpr double minimumShare = 0.25;
  int stalls = 0;
  while (!result.Converged && stalls < 2 && result.Iterations < options.MaximumIterations)
  {
    const double begin = static_cast<double>(result.Iterations) / options.MaximumIterations;
    progress(begin);
    const Geometry is = Measure(patch, loopNormals);
    progress(begin);
    const double energy = is.Curvature.dot(is.Stiffness * is.Curvature);
    if (energy < minimum)
    {
      minimum = energy;
      result.Points = patch.Points;
    }
    // A rise of the energy shows that the derivative misleads: the next step uses the bilaplacian
    // alone, which is positive definite.
    const Eigen::VectorXd step = newton.Find(is, loop, energy > last, isNear && energy <= last,
      progress.Part(begin, (result.Iterations + 1.0) / options.MaximumIterations));
    last = energy;
    // Steps that do not become shorter as expected oscillate.
    const double length = step.cwiseAbs().maxCoeff();
    // After a full step the next one should be at most 70 % as long; after a partial step it may be
    // longer in proportion.
    const bool goesAstray = length > (1.0 - 0.3 * taken) * lastLength;
    stalls = share == minimumShare && goesAstray ? stalls + 1 : 0;
    share = goesAstray ? std::max(minimumShare, 0.5 * share) : std::min(1.0, 2.0 * share);
    constexpr double nearby = 0.1;
    // A tenth of an edge.
    isNear = length <= nearby * enough / options.Tolerance && length <= 0.8 * lastLength;
    lastLength = length;
    taken = std::min(share, SafeShare(patch, step, loop));
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
