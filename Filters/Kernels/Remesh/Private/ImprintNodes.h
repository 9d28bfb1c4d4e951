#pragma once

#include "Geodesics/SurfacePath.h"

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace shape
{

/// An edge's points, the lower one first; -1 and -1 for none.
using PointPair = std::pair<int, int>;

/// A point of a loop: one of the surface's, or a new one on an edge or inside a triangle.
struct ImprintNode
{
  int Id = -1;
  int Low = -1, High = -1; ///< the edge that it lies on; the same at a point; -1 inside
  std::int64_t Along = 0;  ///< how far from Low to High, in ImprintNodes::Parts

  bool IsOn(const PointPair& edge) const
  {
    return (this->Low == edge.first || this->Low == edge.second) &&
      (this->High == edge.first || this->High == edge.second);
  }
};

/// The edge that two nodes lie on.
PointPair FindCommonEdge(const ImprintNode& a, const ImprintNode& b);

/// Numbers the positions that loops over a surface run through: each once.
class ImprintNodes
{
public:
  /// Edges, and barycentric coordinates, are counted in this many parts: their sums and differences
  /// are exact.
  static constexpr double Parts = 1099511627776.0; // 2^40

  /// snapShare: see CurveImprintingOptions.
  ImprintNodes(const Mesh& surface, double snapShare)
    : Surface(surface)
    , SnapShare(snapShare)
  {
  }

  /// The node at a position, which may be moved to an edge or a point that it is near to.
  ImprintNode At(const SurfacePoint& position);

  /// The number of a further new point.
  int Add(const SurfacePoint& position);

  /// The new points on an edge, by how far along it they are; empty where there are none.
  const std::map<std::int64_t, int>& OnEdge(int a, int b) const;
  const std::map<PointPair, std::map<std::int64_t, int>>& OnEdges() const
  {
    return this->EdgeNodes;
  }

  /// The new points, whose numbers follow those of the surface's.
  const std::vector<SurfacePoint>& NewPoints() const { return this->Positions; }

private:
  int NumberOf(const std::array<std::int64_t, 4>& key, const SurfacePoint& position);

  const Mesh& Surface;
  double SnapShare;
  std::vector<SurfacePoint> Positions;
  std::map<std::array<std::int64_t, 4>, int> Numbers; ///< of new points, by their position
  std::map<PointPair, std::map<std::int64_t, int>> EdgeNodes;
};

} // namespace shape
