#include "Correspondence/Transport/GromovHausdorff.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Transport/Private/ExactDistances.h"
#include "Geodesics/ExactGeodesics.h"
#include "Geodesics/FarthestPoints.h"
#include "Mesh/Graph.h"
#include "Mesh/SurfacePoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace shape
{
namespace
{

/// The columns, each in ascending order.
Eigen::MatrixXd Sorted(Eigen::MatrixXd matrix)
{
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
  {
    std::sort(matrix.col(j).begin(), matrix.col(j).end());
  }
  return matrix;
}

/// The largest distance of a number in `from` from the nearest number in `to`; both are ascending.
/// Returns a number of at least `enough` as soon as the result is that large.
double ReachNumbers(const Eigen::Ref<const Eigen::VectorXd>& from,
  const Eigen::Ref<const Eigen::VectorXd>& to, double enough)
{
  double reach = 0.0;
  Eigen::Index j = 0;
  for (Eigen::Index i = 0; i < from.size() && reach < enough; ++i)
  {
    while (j + 1 < to.size() && std::abs(to(j + 1) - from(i)) <= std::abs(to(j) - from(i)))
    {
      ++j;
    }
    reach = std::max(reach, std::abs(to(j) - from(i)));
  }
  return reach;
}

/// For each column of `from`, the smallest Hausdorff distance to a column of `to`; the largest of
/// these.
double ReachSets(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to, const Progress& progress)
{
  Eigen::VectorXd nearest(from.cols());
  ParallelFor(
    static_cast<int>(from.cols()), 1,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        double least = std::numeric_limits<double>::infinity();
        for (Eigen::Index j = 0; j < to.cols(); ++j)
        {
          const double there = ReachNumbers(from.col(i), to.col(j), least);
          least = std::min(least, std::max(there, ReachNumbers(to.col(j), from.col(i), least)));
        }
        nearest(i) = least;
      }
    },
    progress);
  return nearest.maxCoeff();
}

/// Joins positions on one surface.
SurfacePoints Joined(const SurfacePoints& first, const SurfacePoints& second)
{
  SurfacePoints all{ Eigen::VectorXi(first.Triangles.size() + second.Triangles.size()),
    Eigen::MatrixXd(first.Triangles.size() + second.Triangles.size(), 3) };
  all.Triangles << first.Triangles, second.Triangles;
  all.Barycentrics << first.Barycentrics, second.Barycentrics;
  return all;
}

SurfacePoints RowsOf(const SurfacePoints& map, const std::vector<int>& rows)
{
  return { map.Triangles(rows), map.Barycentrics(rows, Eigen::all) };
}

/// The distances between positions on a surface (k x k), and the largest distance of a point from
/// the nearest of the first `samples` positions.
Eigen::MatrixXd DistancesBetween(const Surface& surface, const SurfacePoints& positions,
  int samples, double& radius, const Progress& progress)
{
  const Eigen::MatrixXd fields = ComputeExactDistances(surface, positions, progress.Part(0.0, 0.9));
  radius = fields.leftCols(samples).rowwise().minCoeff().maxCoeff();
  const Eigen::MatrixXd between = PullBack(positions, surface.Triangles(), fields);
  Eigen::MatrixXd symmetric = 0.5 * (between + between.transpose());
  symmetric.diagonal().setZero();
  // Near its source, a distance is not linear in a triangle.
  constexpr double few = 4.0; // edges of mean length
  const std::vector<double>& edges = GetEdgeGraph(surface)->Lengths;
  const double near =
    few * std::accumulate(edges.begin(), edges.end(), 0.0) / static_cast<double>(edges.size());
  std::vector<int> from, to;
  for (int j = 0; j < static_cast<int>(symmetric.cols()); ++j)
  {
    for (int i = 0; i < j; ++i)
    {
      if (symmetric(i, j) < near)
      {
        from.push_back(i);
        to.push_back(j);
      }
    }
  }
  const Eigen::VectorXd exact = ComputeExactGeodesicsBetween(
    surface, RowsOf(positions, from), RowsOf(positions, to), progress.Part(0.9, 1.0));
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    symmetric(from[k], to[k]) = symmetric(to[k], from[k]) = exact(static_cast<Eigen::Index>(k));
  }
  return symmetric;
}

} // namespace

double BoundGromovHausdorff(
  const Eigen::MatrixXd& distancesA, const Eigen::MatrixXd& distancesB, const Progress& progress)
{
  const Eigen::MatrixXd a = Sorted(distancesA), b = Sorted(distancesB);
  return 0.5 *
    std::max(ReachSets(a, b, progress.Part(0.0, 0.5)), ReachSets(b, a, progress.Part(0.5, 1.0)));
}

GromovHausdorffResult MeasureGromovHausdorff(const Surface& a, const Surface& b,
  const SurfaceMaps& maps, const GromovHausdorffOptions& options, const Progress& progress)
{
  RequireOption(options.Samples >= 2, "DistanceSamples", options.Samples, "at least 2");
  RequireConnected(a, "surface A");
  RequireConnected(b, "surface B");
  const std::vector<int> onA = SampleFarthestPoints(a, options.Samples, progress.Part(0.0, 0.02)),
                         onB = SampleFarthestPoints(b, options.Samples, progress.Part(0.02, 0.04));
  const auto asPoints = [](const std::vector<int>& samples, const Surface& surface)
  {
    return MakeSurfacePointsAtVertices(
      Eigen::Map<const Eigen::VectorXi>(samples.data(), static_cast<Eigen::Index>(samples.size())),
      surface);
  };
  double radiusA = 0.0, radiusB = 0.0;
  const Eigen::MatrixXd distancesA =
    DistancesBetween(a, Joined(asPoints(onA, a), RowsOf(maps.BToA, onB)),
      static_cast<int>(onA.size()), radiusA, progress.Part(0.04, 0.5));
  // In the order of A's pairs: first the images of A's samples, then B's samples.
  const SurfacePoints images = RowsOf(maps.AToB, onA), samples = asPoints(onB, b);
  const Eigen::MatrixXd turned = DistancesBetween(
    b, Joined(samples, images), static_cast<int>(onB.size()), radiusB, progress.Part(0.5, 0.95));
  std::vector<int> order;
  for (std::size_t i = 0; i < onA.size() + onB.size(); ++i)
  {
    order.push_back(static_cast<int>(i < onA.size() ? onB.size() + i : i - onA.size()));
  }
  const Eigen::MatrixXd distancesB = turned(order, order);
  const Eigen::MatrixXd changes = distancesA - distancesB;
  GromovHausdorffResult result;
  const auto count = static_cast<double>(changes.rows());
  result.Maximum = changes.cwiseAbs().maxCoeff();
  result.RootMeanSquare = std::sqrt(changes.squaredNorm() / (count * (count - 1.0)));
  result.Upper = 0.5 * result.Maximum;
  result.Lower = BoundGromovHausdorff(distancesA, distancesB, progress.Part(0.95, 1.0));
  result.SamplingError = radiusA + radiusB;
  return result;
}

} // namespace shape
