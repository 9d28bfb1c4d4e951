#pragma once

#include "Geodesics/SurfacePath.h"

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace shape
{

/// The points of an edge, the lower one first; -1 and -1 for no edge.
using PointPair = std::pair<int, int>;

/// A point of a loop: a point of the surface, or a new one on an edge or inside a triangle.
struct ImprintNode
{
  int Id = -1;
  int Low = -1, High = -1; ///< the ends of its edge; equal at a surface point; -1 in a triangle
  std::int64_t Along = 0;  ///< the distance from Low to High, in units of 1 / ImprintNodes::Parts

  bool IsOn(const PointPair& edge) const
  {
    return (this->Low == edge.first || this->Low == edge.second) &&
      (this->High == edge.first || this->High == edge.second);
  }
};

/// Returns the edge that two nodes lie on.
PointPair FindCommonEdge(const ImprintNode& a, const ImprintNode& b);

/// Assigns a unique index to each position that loops on a surface pass through.
class ImprintNodes
{
public:
  /// Positions on edges and barycentric coordinates are integers in units of 1 / Parts, so that
  /// their sums and differences are exact.
  static constexpr double Parts = 1099511627776.0; // 2^40

  /// snapShare: see CurveImprintingOptions.
  ImprintNodes(const Mesh& surface, double snapShare)
    : Surface(surface)
    , SnapShare(snapShare)
  {
  }

  /// Returns the node at a position, which is snapped to an edge or a point close to it.
  ImprintNode At(const SurfacePoint& position);

  /// Adds another new point and returns its index.
  int Add(const SurfacePoint& position);

  /// Returns the new points on an edge, keyed by their position along it; may be empty.
  const std::map<std::int64_t, int>& OnEdge(int a, int b) const;
  const std::map<PointPair, std::map<std::int64_t, int>>& OnEdges() const
  {
    return this->EdgeNodes;
  }

  /// The new points; their indices follow those of the surface's points.
  const std::vector<SurfacePoint>& NewPoints() const { return this->Positions; }

private:
  int NumberOf(const std::array<std::int64_t, 4>& key, const SurfacePoint& position);

  const Mesh& Surface;
  double SnapShare;
  std::vector<SurfacePoint> Positions;
  std::map<std::array<std::int64_t, 4>, int> Numbers; ///< indices of new points, by position
  std::map<PointPair, std::map<std::int64_t, int>> EdgeNodes;
};

} // namespace shape
