#include "Correspondence/Averages/WeightedAverages.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Search/NearestSurfacePoints.h"

#include <Eigen/QR>

#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr int AverageGrain = 64; // points

SurfacePoints Averaged(const LandmarkAverages& from, const LandmarkAverages& to,
  const SurfacePoints& start, const Progress& progress)
{
  SurfacePoints map = start;
  ParallelFor(
    static_cast<int>(start.Triangles.size()), AverageGrain,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const SurfacePoint average =
          to.Average(from.WeightsAt(i), { start.Triangles(i), start.Barycentrics.row(i) });
        map.Triangles(i) = average.Triangle;
        map.Barycentrics.row(i) = average.Barycentric;
      }
    },
    progress);
  return map;
}

void SetAtLandmarks(SurfacePoints& map, const std::vector<int>& points,
  const std::vector<int>& partners, const Mesh& other)
{
  const SurfacePoints at = MakeSurfacePointsAtVertices(
    Eigen::Map<const Eigen::VectorXi>(partners.data(), static_cast<Eigen::Index>(partners.size())),
    other);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    map.Triangles(points[i]) = at.Triangles(static_cast<Eigen::Index>(i));
    map.Barycentrics.row(points[i]) = at.Barycentrics.row(static_cast<Eigen::Index>(i));
  }
}

} // namespace

LandmarkAverages::LandmarkAverages(
  const Surface& surface, const std::vector<int>& landmarks, Eigen::MatrixXd embedding)
  : Landmarks(landmarks)
  , Positions(std::move(embedding))
  , Projection(surface, this->Positions)
{
}

// With the tangent plane's basis T at the vertex x, the conditions are sum w = 1 and
// sum w T' (a - x) = 0. They are the rows of C w = b. The minimum of w' D w under them is
// w = D^-1 C' l, where C D^-1 C' l = b.
Eigen::RowVectorXd LandmarkAverages::WeightsAt(int vertex) const
{
  const Eigen::MatrixXd offsets =
    this->Positions(this->Landmarks, Eigen::all).rowwise() - this->Positions.row(vertex);
  const Eigen::VectorXd squares = offsets.rowwise().squaredNorm();
  Eigen::Index nearest = 0;
  constexpr double atLandmark = 1e-20; // squared, for an area of 1
  if (squares.minCoeff(&nearest) < atLandmark)
  {
    return Eigen::RowVectorXd::Unit(squares.size(), nearest);
  }
  // Divided by the least distance, so that numbers near a landmark do not overflow.
  const Eigen::ArrayXd inverse = (squares(nearest) / squares.array()).square();
  Eigen::MatrixXd conditions(3, squares.size());
  conditions.row(0).setOnes();
  conditions.bottomRows(2) =
    (offsets * this->Projection.TangentAt(vertex)).transpose() / std::sqrt(squares(nearest));
  const Eigen::MatrixXd weighted = conditions * inverse.matrix().asDiagonal();
  const Eigen::Matrix3d system = weighted * conditions.transpose();
  const Eigen::Vector3d multipliers =
    system.completeOrthogonalDecomposition().solve(Eigen::Vector3d::UnitX());
  const Eigen::RowVectorXd weights = multipliers.transpose() * weighted;
  return weights / weights.sum();
}

SurfacePoint LandmarkAverages::Average(
  const Eigen::RowVectorXd& weights, const SurfacePoint& start) const
{
  return this->Projection.Find(weights * this->Positions(this->Landmarks, Eigen::all), start);
}

SurfaceMaps MapByWeightedAverages(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const SmacofOptions& scaling, const Progress& progress)
{
  RequireConnected(a, "surface A");
  RequireConnected(b, "surface B");
  RequireLandmarks(landmarks, a, b);
  const std::vector<int> onA = PointsOf(landmarks, 0), onB = PointsOf(landmarks, 1);
  if (landmarks.size() < 3)
  {
    throw InvalidInput("there are " + std::to_string(landmarks.size()) +
      " landmarks, but a plane of averages needs three; give three or more");
  }
  const auto embedded = [&](const Surface& surface, const Progress& part)
  {
    return Eigen::MatrixXd(
      EmbedBySmacof(surface, scaling, part) / std::sqrt(ComputePointAreas(surface).sum()));
  };
  const LandmarkAverages ofA(
    a, onA, embedded(a, progress.Part(0.0, 0.3, "embedding the surfaces"))),
    ofB(b, onB, embedded(b, progress.Part(0.3, 0.6)));
  const Eigen::MatrixXd alikeA = EmbedByLandmarks(a, onA, progress.Part(0.6, 0.63)),
                        alikeB = EmbedByLandmarks(b, onB, progress.Part(0.63, 0.66));
  const Progress begin = progress.Part(0.66, 0.8, "finding starts"),
                 rest = progress.Part(0.8, 1.0, "averaging the landmarks");
  SurfaceMaps maps{ Averaged(ofA, ofB,
                      FindNearestSurfacePoints(alikeA, b.Triangles(), alikeB, begin.Part(0.0, 0.5)),
                      rest.Part(0.0, 0.5)),
    Averaged(ofB, ofA,
      FindNearestSurfacePoints(alikeB, a.Triangles(), alikeA, begin.Part(0.5, 1.0)),
      rest.Part(0.5, 1.0)) };
  // The mean is a landmark there, up to rounding.
  SetAtLandmarks(maps.AToB, onA, onB, b);
  SetAtLandmarks(maps.BToA, onB, onA, a);
  progress(1.0);
  return maps;
}

} // namespace shape
