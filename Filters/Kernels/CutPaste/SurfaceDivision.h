#pragma once

#include "Geometry/SurfaceWelding.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"
#include "Remesh/CurveImprinting.h"

#include <set>
#include <utility>
#include <vector>

namespace shape
{

/// A part of a surface.
struct DividedPart
{
  Mesh Surface;                 ///< the points of the surface in their order, then new ones
  shape::Provenance Provenance; ///< from the surface
  std::vector<int> Ids; ///< id of each point (see SurfaceDivision); -1 if not on the surface
};

/// Closes the seams of a part. All points remain, but triangles use only the first of several
/// points with the same id.
Mesh MergeSeam(const DividedPart& part);

/// A surface divided in two along edges, which ImprintCurves may have inserted.
class SurfaceDivision
{
public:
  /// joined: kept by reference. split: the joined surface after curves were imprinted. isFeature:
  /// for each triangle of `split`, whether it belongs to the feature.
  SurfaceDivision(const shape::Surface& surface, const WeldedSurface& joined, ImprintedCurves split,
    std::vector<char> isFeature);

  /// The length of the cut; 0 if there is one part only.
  double CutLength() const { return this->Length; }
  /// The mean area of the surface's original triangles beside the cut.
  double MeanArea() const;

  /// Returns the feature or the rest. The id of a point is its index in the joined surface after
  /// curves were imprinted.
  DividedPart PartOf(bool feature) const;

  /// Returns the boundary loops of a part that consist of cut edges only, with the part to the
  /// left, the longest first. ids: one for each point of the part.
  std::vector<std::vector<int>> CutLoops(const Mesh& part, const std::vector<int>& ids) const;

  /// Duplicates each point of the cut at which triangles of a part touch without a common edge. The
  /// duplicates follow all other points.
  void PartPinches(DividedPart& part) const;

private:
  int OriginalOf(int triangle) const;
  int GivenPoint(int triangle, int point) const;
  Eigen::RowVector3d WeightsOf(int triangle, int point) const;

  shape::Surface Surface;
  const WeldedSurface& Joined;
  ImprintedCurves Split;
  std::vector<char> IsFeature;
  std::set<std::pair<int, int>> Cut; ///< edges between feature and rest, the lower point first
  std::set<int> CutPoints;
  double Length = 0.0;
};

} // namespace shape
