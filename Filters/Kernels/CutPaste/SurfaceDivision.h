#pragma once

#include "Geometry/SurfaceWelding.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Remesh/CurveImprinting.h"

#include <set>
#include <utility>
#include <vector>

namespace shape
{

/// A part of a surface.
struct DividedPart
{
  Mesh Surface;                       ///< points of the surface in their order, then new ones
  std::vector<int> OriginalPoints;    ///< of each point: the surface's, or -1
  SurfacePoints Positions;            ///< where it is on the surface; triangle -1: not on it
  std::vector<int> OriginalTriangles; ///< of each: the surface's that it is in, or -1: in none
  std::vector<int> Ids; ///< of each point: see SurfaceDivision; -1: not on the surface
};

/// A part whose seams are closed: the same points, of those with one id the first alone.
Mesh MergeSeam(const DividedPart& part);

/// A surface divided in two along edges, which it may have been given by ImprintCurves.
class SurfaceDivision
{
public:
  /// joined: kept by reference. split: of the joined surface. isFeature: of each of its
  /// triangles.
  SurfaceDivision(const shape::Surface& surface, const WeldedSurface& joined, ImprintedCurves split,
    std::vector<char> isFeature);

  double CutLength() const { return this->Length; } ///< 0: nothing is divided
  double MeanArea() const;                          ///< of the given triangles beside the cut

  /// The feature or the rest. Ids of its points are those of the joined surface after the split.
  DividedPart PartOf(bool feature) const;

  /// The loops of a part's border that were cut all around, with the part to the left; the longest
  /// first. ids: of its points.
  std::vector<std::vector<int>> CutLoops(const Mesh& part, const std::vector<int>& ids) const;

  /// Doubles points of the cut at which a part hangs together by no edge; copies come last.
  void PartPinches(DividedPart& part) const;

private:
  int OriginalOf(int triangle) const;
  int GivenPoint(int triangle, int point) const;
  SurfacePoint NewPosition(int triangle, int point) const;

  shape::Surface Surface;
  const WeldedSurface& Joined;
  ImprintedCurves Split;
  std::vector<char> IsFeature;
  std::set<std::pair<int, int>> Cut; ///< edges between feature and rest, the lower point first
  std::set<int> CutPoints;
  double Length = 0.0;
};

} // namespace shape
