#include "Correspondence/Landmarks/LandmarkCells.h"

#include "Base/Errors.h"
#include "Geodesics/HeatGeodesics.h"

namespace shape
{
namespace
{

/// The initial map of Ezuz et al.: all of a landmark's geodesic Voronoi cell goes to its partner.
SurfacePoints Cells(const Surface& from, const Surface& to, const Landmarks& landmarks, int which,
  const Progress& progress)
{
  std::vector<int> points;
  for (const auto& landmark : landmarks)
  {
    points.push_back(landmark[which]);
  }
  const Eigen::MatrixXd distances = ComputeHeatDistances(from, points, progress);
  Eigen::VectorXi targets(distances.rows());
  for (Eigen::Index i = 0; i < distances.rows(); ++i)
  {
    Eigen::Index nearest = 0;
    distances.row(i).minCoeff(&nearest);
    targets(i) = landmarks[nearest][1 - which];
  }
  return MakeSurfacePointsAtVertices(targets, to);
}

} // namespace

SurfaceMaps MapByLandmarkCells(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress)
{
  if (landmarks.empty())
  {
    throw InvalidInput("there is no landmark to start from; give at least three");
  }
  return { Cells(a, b, landmarks, 0, progress.Part(0.0, 0.5)),
    Cells(b, a, landmarks, 1, progress.Part(0.5, 1.0)) };
}

} // namespace shape
