#include "Geometry/Private/PointNormals.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Private/ParaboloidFit.h"
#include "Mesh/Graph.h"
#include "Search/PointTree.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// The normal of the plane that fits best.
RowVector3d FitPlane(const Eigen::MatrixXd& offsets)
{
  const Eigen::MatrixXd centred = offsets.rowwise() - offsets.colwise().mean();
  const double size = centred.cwiseAbs().maxCoeff();
  if (!(size > 0.0))
  {
    return RowVector3d::UnitZ();
  }
  const Eigen::Matrix3d moments = (centred / size).transpose() * (centred / size);
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0).transpose();
}

/// The normal at the origin of a paraboloid over the plane, which the fit itself improves.
RowVector3d FitNormal(const Eigen::MatrixXd& offsets)
{
  RowVector3d normal = FitPlane(offsets);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(offsets.rows());
  for (int round = 0; round < 2; ++round)
  {
    Eigen::Matrix3d frame; // columns
    frame.col(2) = normal.transpose();
    frame.col(0) = normal.unitOrthogonal().transpose();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    const Eigen::RowVector2d slopes = FitSlopesOfParaboloid(offsets * frame, weights);
    normal = (normal - slopes * frame.leftCols<2>().transpose()).normalized();
  }
  return normal;
}

/// Whether the normal points upwards; to the sides, x and then y decide.
bool PointsUp(const RowVector3d& normal)
{
  constexpr double level = 1e-9;
  const int axis = std::abs(normal.z()) > level ? 2 : std::abs(normal.x()) > level ? 0 : 1;
  return normal(axis) >= 0.0;
}

/// Hoppe et al. 1992, section 3.3: the spanning tree of each part grows from its highest point
/// (Prim's algorithm).
void Orient(const Eigen::MatrixXd& points, const Graph& graph, Eigen::MatrixXd& normals,
  const Progress& progress)
{
  using Item = std::pair<double, std::pair<int, int>>; // weight, node, previous node
  std::vector<int> order(points.rows());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    { return points(a, 2) != points(b, 2) ? points(a, 2) > points(b, 2) : a < b; });
  std::vector<char> isDone(points.rows(), 0);
  std::size_t done = 0;
  for (const int root : order)
  {
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    queue.push({ 0.0, { root, -1 } });
    while (!queue.empty())
    {
      const auto [node, before] = queue.top().second;
      queue.pop();
      if (isDone[node])
      {
        continue;
      }
      isDone[node] = 1;
      if (++done % 8192 == 0)
      {
        progress(static_cast<double>(done) / static_cast<double>(order.size()));
      }
      const bool agrees = before < 0 ? PointsUp(normals.row(node))
                                     : normals.row(node).dot(normals.row(before)) >= 0.0;
      if (!agrees)
      {
        normals.row(node) *= -1.0;
      }
      for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
      {
        const int next = graph.Neighbours[k];
        if (!isDone[next])
        {
          queue.push({ 1.0 - std::abs(normals.row(node).dot(normals.row(next))), { next, node } });
        }
      }
    }
  }
}

} // namespace

Eigen::MatrixXd EstimatePointNormals(
  const Eigen::MatrixXd& points, const PointNormalsOptions& options, const Progress& progress)
{
  constexpr int few = 6; // coefficients of a paraboloid
  RequireOption(options.Nearest >= few, "Nearest", options.Nearest, "at least 6");
  const auto count = static_cast<int>(points.rows());
  const PointTree tree(points);
  Eigen::MatrixXd normals(count, 3);
  std::vector<std::vector<int>> near(count);
  ParallelFor(
    count, 256,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        near[i] = tree.Nearest(points.row(i), options.Nearest + 1);
        const Eigen::MatrixXd offsets = points(near[i], Eigen::all).rowwise() - points.row(i);
        normals.row(i) = FitNormal(offsets);
      }
    },
    progress.Part(0.0, 0.7));
  std::vector<std::pair<int, int>> links;
  for (int i = 0; i < count; ++i)
  {
    for (const int j : near[i])
    {
      if (j != i)
      {
        links.emplace_back(i, j);
      }
    }
  }
  Orient(points, BuildGraph(points, std::move(links)), normals, progress.Part(0.7, 1.0));
  progress(1.0);
  return normals;
}

} // namespace shape
