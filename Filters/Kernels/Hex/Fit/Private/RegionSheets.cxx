#include "Hex/Fit/Private/RegionSheets.h"

#include "Hex/Features/RegionMatch.h"
#include "Hex/Fit/Private/Pillowing.h"
#include "Mesh/RegionSurfaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using LabelSet = std::set<int>;

/// Angles of quads between edges on curves, in degrees. From the first on, a quad is not good;
/// beyond the second, two are better.
constexpr double StraightAngle = 120.0, WideAngle = 145.0;

/// The corner of a quad between two edges on curves.
struct CurveCorner
{
  LabelSet Quad;          ///< the labels on both sides of the quad
  LabelSet First, Second; ///< the labels around its two edges
  double Angle;           ///< at the positions where the fit starts; degrees
};

/// Finds all corners of quads between two edges of the network.
std::vector<CurveCorner> FindCurveCorners(
  const HexMesh& mesh, const RegionFaces& faces, const RegionMatch& match)
{
  std::map<int, Eigen::RowVector3d> starts(
    match.Boundary.Starts.begin(), match.Boundary.Starts.end());
  const auto at = [&](int point) -> Eigen::RowVector3d
  {
    const auto start = starts.find(point);
    return start == starts.end() ? Eigen::RowVector3d(mesh.Points.row(point)) : start->second;
  };
  std::map<std::pair<int, int>, LabelSet> labelsOf;
  for (const RegionNetwork::Curve& curve : match.Chains.Curves)
  {
    const std::size_t count = curve.Points.size();
    for (std::size_t i = 0; i + (curve.Closed ? 0 : 1) < count; ++i)
    {
      const auto [low, high] = std::minmax(curve.Points[i], curve.Points[(i + 1) % count]);
      labelsOf[{ low, high }] = LabelSet(curve.Labels.begin(), curve.Labels.end());
    }
  }
  std::vector<CurveCorner> corners;
  for (Eigen::Index q = 0; q < faces.Quads.rows(); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int before = faces.Quads(q, (k + 3) % 4), here = faces.Quads(q, k),
                after = faces.Quads(q, (k + 1) % 4);
      const auto first = labelsOf.find(std::minmax(before, here)),
                 second = labelsOf.find(std::minmax(here, after));
      if (first != labelsOf.end() && second != labelsOf.end())
      {
        const Eigen::RowVector3d a = at(before) - at(here), b = at(after) - at(here);
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
        corners.push_back(
          { { faces.Labels(q, 0), faces.Labels(q, 1) }, first->second, second->second, angle });
      }
    }
  }
  return corners;
}

/// Returns a label around both edges of a corner, but not beside its quad; nothing if the edges are
/// on curves of different regions.
std::optional<int> FindLabelAcross(const CurveCorner& corner)
{
  const auto found = std::find_if(corner.First.begin(), corner.First.end(),
    [&](int label) { return corner.Second.count(label) > 0 && corner.Quad.count(label) == 0; });
  return found == corner.First.end() ? std::nullopt : std::optional<int>(*found);
}

RegionFaces FindFaces(const HexMesh& mesh, const std::vector<int>& regionOf)
{
  return FindRegionFaces(mesh,
    Eigen::Map<const Eigen::VectorXi>(regionOf.data(), static_cast<Eigen::Index>(regionOf.size())));
}

/// Inserts a layer inside the union of some regions, along their faces with others.
void InsertSheet(const LabelSet& labels, HexMesh& mesh, std::vector<int>& regionOf)
{
  const RegionFaces faces = FindFaces(mesh, regionOf);
  Eigen::MatrixXi quads(faces.Quads.rows(), 4);
  Eigen::Index count = 0;
  for (Eigen::Index q = 0; q < faces.Quads.rows(); ++q)
  {
    const int first = faces.Labels(q, 0), second = faces.Labels(q, 1);
    if (labels.count(first) > 0 && labels.count(second) == 0)
    {
      quads.row(count++) = faces.Quads.row(q);
    }
    else if (labels.count(first) == 0 && labels.count(second) > 0 &&
      second != RegionSurfaces::Outside)
    {
      quads.row(count++) = faces.Quads.row(q).reverse();
    }
  }
  quads.conservativeResize(count, 4);
  std::vector<int> rows;
  for (int hex = 0; hex < static_cast<int>(regionOf.size()); ++hex)
  {
    if (labels.count(regionOf[hex]) > 0)
    {
      rows.push_back(hex);
    }
  }
  PadSide(mesh, rows, quads, regionOf);
}

} // namespace

void InsertRegionSheets(
  HexMesh& mesh, std::vector<int>& regionOf, const RegionTargets& targets, double cellSize)
{
  LabelSet all(regionOf.begin(), regionOf.end());
  all.insert(RegionSurfaces::Outside);
  const auto corners = [&]
  {
    const RegionFaces faces = FindFaces(mesh, regionOf);
    return FindCurveCorners(mesh, faces, MatchRegions(mesh, faces, targets, cellSize));
  };
  LabelSet within;
  for (const CurveCorner& corner : corners())
  {
    const std::optional<int> label = FindLabelAcross(corner);
    if (label && corner.Angle > StraightAngle)
    {
      within.insert(*label);
    }
  }
  for (const int label : within)
  {
    LabelSet others = all;
    others.erase(label);
    InsertSheet(others, mesh, regionOf);
  }
  std::set<LabelSet> wide;
  for (const CurveCorner& corner : corners())
  {
    if (!FindLabelAcross(corner) && corner.Angle > WideAngle)
    {
      wide.insert(corner.Quad);
    }
  }
  for (const LabelSet& pair : wide)
  {
    InsertSheet(pair, mesh, regionOf);
  }
}

} // namespace shape
