#pragma once

#include "Geodesics/SurfacePath.h"

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace shape
{

/// The two points of an edge, in ascending order; (-1, -1) for no edge.
using PointPair = std::pair<int, int>;

/// A point of a loop: either a point of the surface, or a new point on an edge or inside a
/// triangle.
struct ImprintNode
{
  int Id = -1;
  int Low = -1, High = -1; ///< the ends of its edge; equal for a surface point; -1 in a triangle
  std::int64_t Along = 0;  ///< position from Low (0) to High (ImprintNodes::Parts)

  bool IsOn(const PointPair& edge) const
  {
    return (this->Low == edge.first || this->Low == edge.second) &&
      (this->High == edge.first || this->High == edge.second);
  }
};

/// Returns the edge that two nodes lie on, or (-1, -1) if there is none.
PointPair FindCommonEdge(const ImprintNode& a, const ImprintNode& b);

/// Assigns a unique index to each position that loops on a surface pass through.
class ImprintNodes
{
public:
  /// Positions on edges and barycentric coordinates are rounded to multiples of 1 / Parts, so that
  /// their sums and differences are exact.
  static constexpr double Parts = 1099511627776.0; // 2^40

  /// snapShare: see CurveImprintingOptions.
  ImprintNodes(const Mesh& surface, double snapShare)
    : Surface(surface)
    , SnapShare(snapShare)
  {
  }

  /// Returns the node at a position. The position is first snapped to a surface point or an edge
  /// close to it.
  ImprintNode At(const SurfacePoint& position);

  /// Adds a new point without looking for an existing one. Returns its index.
  int Add(const SurfacePoint& position);

  /// Returns the new points on an edge, keyed by their position along the edge; may be empty.
  const std::map<std::int64_t, int>& OnEdge(int a, int b) const;
  const std::map<PointPair, std::map<std::int64_t, int>>& OnEdges() const
  {
    return this->EdgeNodes;
  }

  /// The new points, which are numbered after the points of the surface.
  const std::vector<SurfacePoint>& NewPoints() const { return this->Positions; }

private:
  int NumberOf(const std::array<std::int64_t, 4>& key, const SurfacePoint& position);

  const Mesh& Surface;
  double SnapShare;
  std::vector<SurfacePoint> Positions;
  std::map<std::array<std::int64_t, 4>, int> Numbers; ///< indices of new points, keyed by position
  std::map<PointPair, std::map<std::int64_t, int>> EdgeNodes;
};

} // namespace shape
