#include "Correspondence/Evaluate/MapDifference.h"

#include "Base/Errors.h"
#include "Linear/DenseSolve.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Of the largest singular value: the root of the share of areas that counts.
constexpr double MinimumSingularValueRatio = 0.03;

/// Points that triangles use.
int UsedPoints(const Topology& topology)
{
  return static_cast<int>((topology.ComponentId.array() >= 0).count());
}

void RequirePoints(int asked, int points, const std::string& name)
{
  if (asked > points)
  {
    throw InvalidInput("NumberOfEigenpairs is " + std::to_string(asked) + " and " + name +
      " has only " + std::to_string(points) + " points; ask for fewer, or subdivide it");
  }
}

/// The midpoints of a surface's edges, their images by a map of its points, and a third of the
/// areas beside each: integrals over the surface are sums over these. Functions that are linear in
/// triangles lose as much there on either surface, which they would not at vertices.
struct EdgeSamples
{
  std::vector<int> Low, High; ///< points
  SurfacePoints Images;
  Eigen::VectorXd Areas;

  EdgeSamples(
    const Surface& first, const Surface& second, const SurfacePoints& map, const Progress& progress)
  {
    const Eigen::VectorXd areas = first.AreaVectors().rowwise().norm() / 6.0;
    std::vector<double> shares;
    for (const HalfEdge& edge : first.HalfEdges())
    {
      if (this->Low.empty() || edge.Low() != this->Low.back() || edge.High() != this->High.back())
      {
        this->Low.push_back(edge.Low());
        this->High.push_back(edge.High());
        shares.push_back(0.0);
      }
      shares.back() += areas(edge.Triangle);
    }
    this->Areas =
      Eigen::Map<Eigen::VectorXd>(shares.data(), static_cast<Eigen::Index>(shares.size()));
    const Eigen::MatrixXd images = PullBack(map, second.Triangles(), second.Points());
    this->Images = SurfaceLocator(second).Find(this->Midpoints(images), progress);
  }

  /// Means of the values (n x d) at the ends of edges.
  Eigen::MatrixXd Midpoints(const Eigen::MatrixXd& values) const
  {
    return 0.5 * (values(this->Low, Eigen::all) + values(this->High, Eigen::all));
  }
};

/// The eigenvalues of a symmetric matrix with those farthest from 1 in front, and its eigenvectors;
/// an eigenvalue that is no number above 0 is the farthest.
void Order(const Eigen::MatrixXd& matrix, DifferenceOperator& result, Eigen::MatrixXd& vectors)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const Eigen::VectorXd& values = solver.eigenvalues();
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  const auto change = [&](int i) { return std::abs(std::log(std::max(values(i), 1e-300))); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return change(a) > change(b); });
  order.resize(std::min<std::size_t>(order.size(), DifferenceEigenfunctions));
  result.Eigenvalues = values(order);
  vectors = solver.eigenvectors()(Eigen::all, order);
}

/// <d, matrix d> / <d, weights d> with the row d of `functions` at each point; 1 if that is 0.
Eigen::VectorXd Around(
  const Eigen::MatrixXd& functions, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& weights)
{
  Eigen::VectorXd result = Eigen::VectorXd::Ones(functions.rows());
  const Eigen::VectorXd above = (functions * matrix).cwiseProduct(functions).rowwise().sum(),
                        below = functions.cwiseAbs2() * weights;
  for (Eigen::Index i = 0; i < result.size(); ++i)
  {
    if (below(i) > 0.0)
    {
      result(i) = above(i) / below(i);
    }
  }
  return result;
}

DifferenceOperator AreaDifference(const Eigen::MatrixXd& functions, const Eigen::MatrixXd& f)
{
  DifferenceOperator result;
  result.Matrix = f.transpose() * f;
  result.Field = Around(functions, result.Matrix, Eigen::VectorXd::Ones(functions.cols()));
  Eigen::MatrixXd vectors;
  Order(result.Matrix, result, vectors);
  result.Eigenfunctions = functions * vectors;
  return result;
}

/// constants: how many of the first eigenvalues are 0.
DifferenceOperator ConformalDifference(const LaplaceEigenpairs& first,
  const LaplaceEigenpairs& second, const Eigen::MatrixXd& f, Eigen::Index constants)
{
  const Eigen::Index count = first.Eigenvalues.size(), others = count - constants;
  const Eigen::MatrixXd energies =
    f.transpose() * second.Eigenvalues.asDiagonal() * f; // of gradients on the second surface
  const auto varying = energies.bottomRightCorner(others, others);
  const Eigen::VectorXd values = first.Eigenvalues.tail(others);
  const Eigen::MatrixXd functions = first.Eigenfunctions.rightCols(others);

  DifferenceOperator result;
  result.Matrix.setZero(count, count);
  result.Matrix.bottomRightCorner(others, others) = values.cwiseInverse().asDiagonal() * varying;
  result.Field = Around(functions, varying, values);
  // R has the eigenvalues of L1^-1/2 F' L2 F L1^-1/2.
  const Eigen::VectorXd roots = values.cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd vectors;
  Order(roots.asDiagonal() * varying * roots.asDiagonal(), result, vectors);
  result.Eigenfunctions = functions * (roots.asDiagonal() * vectors);
  return result;
}

} // namespace

MapDifferenceResult MapDifference(const Surface& first, const Surface& second,
  const SurfacePoints& map, const MapDifferenceOptions& options, const Progress& progress)
{
  const Topology topology = RequireManifold(first, "SurfaceA");
  const int used = UsedPoints(topology),
            usedThere = UsedPoints(RequireManifold(second, "SurfaceB"));
  const int count = options.NumberOfEigenpairs;
  RequireOption(count > topology.Components, "NumberOfEigenpairs", count,
    "more than SurfaceA has components, which are " + std::to_string(topology.Components));
  RequirePoints(count, used, "SurfaceA");
  RequirePoints(count, usedThere, "SurfaceB");
  const int there = std::min({ 2 * count, used, usedThere });

  const EdgeSamples samples(first, second, map, progress.Part(0.0, 0.1));
  const LaplaceEigenpairs here = SolveLaplaceEigenproblem(first, count, progress.Part(0.1, 0.3)),
                          beyond = SolveLaplaceEigenproblem(second, there, progress.Part(0.3, 0.9));
  const Eigen::VectorXd roots = samples.Areas.cwiseSqrt();
  const SingularValues pulled(
    roots.asDiagonal() * PullBack(samples.Images, second.Triangles(), beyond.Eigenfunctions));
  const double minimum = MinimumSingularValueRatio * pulled.Values()(0);
  const Eigen::MatrixXd f =
    pulled.Solve(roots.asDiagonal() * samples.Midpoints(here.Eigenfunctions), minimum);

  MapDifferenceResult result;
  result.Undetermined = there - pulled.Rank(minimum);
  result.Area = AreaDifference(here.Eigenfunctions, f);
  result.Conformal = ConformalDifference(here, beyond, f, topology.Components);
  progress(1.0);
  return result;
}

} // namespace shape
