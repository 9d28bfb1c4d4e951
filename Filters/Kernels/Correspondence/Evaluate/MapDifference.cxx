#include "Correspondence/Evaluate/MapDifference.h"

#include "Base/Errors.h"
#include "Correspondence/Evaluate/Private/TriangleProducts.h"
#include "Linear/SymmetricEigen.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Relative to the largest singular value: the root of the minimum share of area on the image.
constexpr double MinimumSingularValueRatio = 0.03;

/// Returns the number of points that triangles use.
int UsedPoints(const Topology& topology)
{
  return static_cast<int>((topology.ComponentId.array() >= 0).count());
}

void RequirePoints(int asked, int points, const std::string& name)
{
  if (asked > points)
  {
    throw InvalidInput("NumberOfEigenpairs is " + std::to_string(asked) + ", but " + name +
      " has only " + std::to_string(points) + " points; lower it, or subdivide the surface");
  }
}

/// Returns, for each image, the vertex where it is, or -1 if it is at none.
Eigen::VectorXi FindVertices(const SurfacePoints& map, const Eigen::MatrixXi& triangles)
{
  Eigen::VectorXi vertices = FindNearestCorners(map, triangles);
  for (Eigen::Index i = 0; i < vertices.size(); ++i)
  {
    if (map.Barycentrics.row(i).maxCoeff() < 1.0)
    {
      vertices(i) = -1;
    }
  }
  return vertices;
}

/// The midpoints of a surface's edges, their images by a map of its points, and a third of the area
/// of the triangles beside each edge. Integrals over the surface are sums over these. At midpoints,
/// unlike at vertices, the error for piecewise linear functions is the same on both surfaces.
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
      // Half-edges are sorted, so both half-edges of an edge follow each other. The rule with the
      // three midpoints is exact for products of two linear functions.
      shares.back() += areas(edge.Triangle);
    }
    this->Areas =
      Eigen::Map<Eigen::VectorXd>(shares.data(), static_cast<Eigen::Index>(shares.size()));
    const std::vector<int> others = this->MapEdgesToEdges(second, map);
    const Eigen::MatrixXd images = PullBack(map, second.Triangles(), second.Points());
    const SurfacePoints found =
      SurfaceLocator(second).Find(this->Midpoints(images)(others, Eigen::all), progress);
    this->Images.Triangles(others) = found.Triangles;
    this->Images.Barycentrics(others, Eigen::all) = found.Barycentrics;
  }

  /// Returns the means of the values (n x d) at the ends of edges.
  Eigen::MatrixXd Midpoints(const Eigen::MatrixXd& values) const
  {
    return 0.5 * (values(this->Low, Eigen::all) + values(this->High, Eigen::all));
  }

private:
  /// If both ends of an edge are mapped to the ends of an edge, so is its midpoint: beside a
  /// triangle without area, the closest edge could be another one. Returns the other edges.
  std::vector<int> MapEdgesToEdges(const Surface& second, const SurfacePoints& map)
  {
    const std::vector<HalfEdge>& edges = second.HalfEdges();
    const Eigen::VectorXi vertices = FindVertices(map, second.Triangles());
    this->Images = { Eigen::VectorXi(this->Areas.size()), Eigen::MatrixXd(this->Areas.size(), 3) };
    std::vector<int> others;
    for (int i = 0; i < static_cast<int>(this->Low.size()); ++i)
    {
      const int a = vertices(this->Low[i]), b = vertices(this->High[i]);
      const std::pair<int, int> ends(std::min(a, b), std::max(a, b));
      // The half-edges are sorted, and no end of theirs is -1.
      const auto edge = std::lower_bound(edges.begin(), edges.end(), ends,
        [](const HalfEdge& e, const std::pair<int, int>& wanted)
        { return std::make_pair(e.Low(), e.High()) < wanted; });
      if (edge == edges.end() || edge->Low() != ends.first || edge->High() != ends.second)
      {
        others.push_back(i);
        continue;
      }
      this->Images.Triangles(i) = edge->Triangle;
      this->Images.Barycentrics.row(i).setConstant(0.5);
      this->Images.Barycentrics(i, (edge->Corner + 2) % 3) = 0.0;
    }
    return others;
  }
};

/// The functional map, and how many of its singular values were cut off.
struct FunctionalMapFit
{
  Eigen::MatrixXd Matrix;
  int Undetermined;
};

/// Fits the map from functions on the first surface to functions on the second one: least squares
/// over the samples, weighted by area. Where the map covers little of the second surface, the
/// system is nearly singular, so small singular values are cut off. As they are not smaller than
/// 0.03 of the largest, the normal equations lose only three digits.
FunctionalMapFit FitFunctionalMap(const EdgeSamples& samples, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& here, const Eigen::MatrixXd& beyond, const Progress& progress)
{
  const Eigen::MatrixXd values = samples.Midpoints(here);
  const Eigen::Index count = samples.Areas.size(), there = beyond.cols();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(there, there),
                  right = Eigen::MatrixXd::Zero(there, here.cols());
  constexpr Eigen::Index chunk = 16384;
  for (Eigen::Index begin = 0; begin < count; begin += chunk)
  {
    progress(0.9 * static_cast<double>(begin) / static_cast<double>(count));
    const Eigen::Index rows = std::min(chunk, count - begin);
    const SurfacePoints images{ samples.Images.Triangles.segment(begin, rows),
      samples.Images.Barycentrics.middleRows(begin, rows) };
    const Eigen::MatrixXd pulled = PullBack(images, triangles, beyond),
                          weighted = samples.Areas.segment(begin, rows).asDiagonal() * pulled;
    normal.noalias() += weighted.transpose() * pulled;
    right.noalias() += weighted.transpose() * values.middleRows(begin, rows);
  }
  const Eigenpairs squares =
    FindLargestEigenpairs(normal, static_cast<int>(there), progress.Part(0.9, 1.0));
  const double minimum = std::pow(MinimumSingularValueRatio, 2) * squares.Values(0);
  const auto rank = static_cast<int>((squares.Values.array() >= minimum).count());
  const auto vectors = squares.Vectors.leftCols(rank);
  return { vectors *
      (squares.Values.head(rank).cwiseInverse().asDiagonal() * (vectors.transpose() * right)),
    static_cast<int>(there) - rank };
}

/// Computes the eigenvalues of a symmetric matrix, those farthest from 1 first, and its
/// eigenvectors. An eigenvalue that is not positive is the farthest.
void Order(const Eigen::MatrixXd& matrix, DifferenceOperator& result, Eigen::MatrixXd& vectors)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  // Both operators are products A' A, so that a negative eigenvalue is rounding.
  const Eigen::VectorXd values = solver.eigenvalues().cwiseMax(0.0);
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  const auto change = [&](int i) { return std::abs(std::log(std::max(values(i), 1e-300))); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return change(a) > change(b); });
  order.resize(std::min<std::size_t>(order.size(), DifferenceEigenfunctions));
  result.Eigenvalues = values(order);
  vectors = solver.eigenvectors()(Eigen::all, order);
}

/// Returns <d, other d> / <d, here d> for the row d of `functions` at each point; 1 if the
/// denominator is 0.
Eigen::VectorXd Around(
  const Eigen::MatrixXd& functions, const Eigen::MatrixXd& other, const Eigen::MatrixXd& here)
{
  Eigen::VectorXd result = Eigen::VectorXd::Ones(functions.rows());
  const Eigen::VectorXd above = (functions * other).cwiseProduct(functions).rowwise().sum(),
                        below = (functions * here).cwiseProduct(functions).rowwise().sum();
  for (Eigen::Index i = 0; i < result.size(); ++i)
  {
    if (below(i) > 0.0)
    {
      result(i) = above(i) / below(i);
    }
  }
  return result;
}

/// The operator here^-1 other, from the products of functions on the first surface and on the
/// second one.
DifferenceOperator CompareProducts(
  const Eigen::MatrixXd& functions, const Eigen::MatrixXd& here, const Eigen::MatrixXd& other)
{
  const Eigen::LLT<Eigen::MatrixXd> factor(here);
  if (factor.info() != Eigen::Success)
  {
    throw SolveFailure("the eigenfunctions of SurfaceA are not independent on its triangles; lower "
                       "NumberOfEigenpairs, or remesh the surface");
  }
  DifferenceOperator result;
  result.Matrix = factor.solve(other);
  result.Field = Around(functions, other, here);
  // The operator itself is not symmetric. The similar matrix is: it has the same real eigenvalues,
  // and orthogonal vectors.
  const Eigen::MatrixXd half = factor.matrixL().solve(other);
  Eigen::MatrixXd vectors;
  Order(factor.matrixL().solve(half.transpose()), result, vectors);
  result.Eigenfunctions = functions * factor.matrixU().solve(vectors);
  return result;
}

/// The conformal operator: constants, the first functions, have no gradient and are left out.
DifferenceOperator CompareGradients(const Eigen::MatrixXd& functions, const Eigen::MatrixXd& here,
  const Eigen::MatrixXd& other, Eigen::Index constants)
{
  const Eigen::Index count = functions.cols(), others = count - constants;
  DifferenceOperator result = CompareProducts(functions.rightCols(others),
    here.bottomRightCorner(others, others), other.bottomRightCorner(others, others));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  matrix.bottomRightCorner(others, others) = result.Matrix;
  result.Matrix = std::move(matrix);
  return result;
}

/// Corman et al. 2017: the products of the same functions on the triangles of the first surface and
/// on their images.
MapDifferenceResult CompareTriangles(const Surface& first, const Surface& second,
  const SurfacePoints& map, int pairs, Eigen::Index constants, const Progress& progress)
{
  const LaplaceEigenpairs basis =
    SolveLaplaceEigenproblem(first, pairs, progress.Part(0.0, 0.9, "computing the eigenfunctions"));
  const Eigen::MatrixXd& functions = basis.Eigenfunctions;
  const TriangleProducts here = ComputeTriangleProducts(first, functions),
                         beyond = ComputeTriangleProducts(
                           first.WithPoints(PullBack(map, second.Triangles(), second.Points())),
                           functions);
  progress(0.95);
  MapDifferenceResult result;
  result.Area = CompareProducts(functions, here.Mass, beyond.Mass);
  result.Conformal = CompareGradients(functions, here.Dirichlet, beyond.Dirichlet, constants);
  progress(1.0);
  return result;
}

} // namespace

// 1. The functional map F from A's eigenfunctions to twice as many of B's (FitFunctionalMap).
// 2. The area-based difference F' F.
// 3. The conformal difference L1^-1 F' L2 F.
MapDifferenceResult MapDifference(const Surface& first, const Surface& second,
  const SurfacePoints& map, const MapDifferenceOptions& options, const Progress& progress)
{
  const Topology topology = RequireManifold(first, "SurfaceA");
  const int used = UsedPoints(topology),
            usedThere = UsedPoints(RequireManifold(second, "SurfaceB"));
  const int count = options.NumberOfEigenpairs;
  RequireOption(count > topology.Components, "NumberOfEigenpairs", count,
    "more than the number of SurfaceA's components, " + std::to_string(topology.Components));
  RequirePoints(count, used, "SurfaceA");
  RequirePoints(count, usedThere, "SurfaceB");
  if (options.Products == MapDifferenceOptions::ProductsType::Triangles)
  {
    return CompareTriangles(first, second, map, count, topology.Components, progress);
  }
  // Images of A's eigenfunctions contain higher frequencies of B; with only as many functions the
  // projection would look like a loss of area.
  const int there = std::min({ 2 * count, used, usedThere });

  const EdgeSamples samples(first, second, map, progress.Part(0.0, 0.1));
  const LaplaceEigenpairs here = SolveLaplaceEigenproblem(
                            first, count, progress.Part(0.1, 0.3, "computing the eigenfunctions")),
                          beyond = SolveLaplaceEigenproblem(
                            second, there, progress.Part(0.3, 0.9, "computing the eigenfunctions"));
  const FunctionalMapFit f = FitFunctionalMap(samples, second.Triangles(), here.Eigenfunctions,
    beyond.Eigenfunctions, progress.Part(0.9, 1.0));

  MapDifferenceResult result;
  result.Undetermined = f.Undetermined;
  // Rustamov et al.: both bases are orthonormal, so the area-based difference is F' F. The
  // conformal difference compares Dirichlet energies: L1^-1 F' L2 F.
  result.Area = CompareProducts(
    here.Eigenfunctions, Eigen::MatrixXd::Identity(count, count), f.Matrix.transpose() * f.Matrix);
  result.Conformal = CompareGradients(here.Eigenfunctions, here.Eigenvalues.asDiagonal(),
    f.Matrix.transpose() * beyond.Eigenvalues.asDiagonal() * f.Matrix, topology.Components);
  progress(1.0);
  return result;
}

} // namespace shape
