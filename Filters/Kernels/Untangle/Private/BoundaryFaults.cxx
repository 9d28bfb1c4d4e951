#include "Untangle/Private/BoundaryFaults.h"

#include "Geometry/SelfIntersections.h"
#include "Untangle/Private/StarCollar.h"
#include "Untangle/Private/StarKernel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Returns the boundary faces that have an area.
std::vector<StarFace> FindWideFaces(const SolidCells& solid)
{
  std::vector<StarFace> faces = FindStarFaces(solid);
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [&](const StarFace& face)
                {
                  const Eigen::Vector3d a = solid.Points.row(face[0]),
                                        b = solid.Points.row(face[1]),
                                        c = solid.Points.row(face[2]);
                  return !((b - a).cross(c - a).squaredNorm() > 0.0);
                }),
    faces.end());
  return faces;
}

/// Finds out whether the boundary crosses itself: cells then cannot all be positive.
void FindCrossings(const SolidCells& solid, const std::vector<StarFace>& faces,
  BoundaryFaults& faults, const Progress& progress)
{
  constexpr int maximum = 100;
  Mesh boundary{ solid.Points.topRows(solid.PointCount()), Eigen::MatrixXi() };
  boundary.Triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (Eigen::Index t = 0; t < boundary.Triangles.rows(); ++t)
  {
    boundary.Triangles.row(t) << faces[t][0], faces[t][1], faces[t][2];
  }
  const std::vector<Crossing> crossings = FindSelfIntersectionsFrom(boundary, 0, maximum, progress);
  faults.BoundaryCrossings = std::min(maximum, static_cast<int>(crossings.size()));
  if (!crossings.empty())
  {
    faults.FirstCrossing = crossings.front().Position;
  }
}

/// Finds edges whose two triangles overlap and lie in one plane, within rounding.
void FindFoldedEdges(
  const SolidCells& solid, const std::vector<StarFace>& faces, BoundaryFaults& faults)
{
  struct Side
  {
    Eigen::Vector3d Normal;
    int Corner; ///< the one that is not on the edge
  };
  const double rounding =
    4.0 * std::numeric_limits<double>::epsilon() * solid.Points.cwiseAbs().maxCoeff();
  std::map<std::pair<int, int>, Side> sides;
  for (const StarFace& face : faces)
  {
    const Eigen::Vector3d a = solid.Points.row(face[0]), b = solid.Points.row(face[1]),
                          c = solid.Points.row(face[2]);
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    for (int k = 0; k < 3; ++k)
    {
      const std::pair<int, int> edge = std::minmax(face[k], face[(k + 1) % 3]);
      const auto [other, isFirst] = sides.try_emplace(edge, Side{ normal, face[(k + 2) % 3] });
      const Eigen::RowVector3d end = solid.Points.row(edge.first);
      const double distance =
        (solid.Points.row(other->second.Corner) - end).dot(normal.transpose());
      if (isFirst || normal.dot(other->second.Normal) > 0.0 || std::abs(distance) > rounding)
      {
        continue;
      }
      if (faults.FoldedEdges == 0)
      {
        faults.FirstFolded = (end + solid.Points.row(edge.second)) / 2.0;
      }
      ++faults.FoldedEdges;
    }
  }
}

/// Finds out whether a position inside sees the whole boundary.
void FindHiddenTriangles(
  const SolidCells& solid, const std::vector<StarFace>& faces, BoundaryFaults& faults)
{
  if (faces.empty())
  {
    return;
  }
  const StarPlacement centre = FindStarCentre(solid, faces);
  for (const StarFace& face : faces)
  {
    if (SeesFace(solid.Points, face, centre.Position))
    {
      continue;
    }
    if (faults.HiddenTriangles == 0)
    {
      faults.FirstHidden =
        (solid.Points.row(face[0]) + solid.Points.row(face[1]) + solid.Points.row(face[2])) / 3.0;
    }
    ++faults.HiddenTriangles;
  }
  if (faults.HiddenTriangles == 0)
  {
    faults.StarClearance = centre.Clearance;
  }
}

} // namespace

BoundaryFaults FindBoundaryFaults(const SolidCells& solid, const Progress& progress)
{
  const std::vector<StarFace> faces = FindWideFaces(solid);
  BoundaryFaults faults;
  FindCrossings(solid, faces, faults, progress);
  FindFoldedEdges(solid, faces, faults);
  FindHiddenTriangles(solid, faces, faults);
  return faults;
}

} // namespace shape
