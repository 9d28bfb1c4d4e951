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
  Mesh Surface;                 ///< points of the surface in their order, then new ones
  shape::Provenance Provenance; ///< from the surface
  std::vector<int> Ids;         ///< of each point: see SurfaceDivision; -1: not on the surface
};

/// A part with its seams closed: the same points, but only the first one of those with the same id
/// is used.
Mesh MergeSeam(const DividedPart& part);

/// A surface divided in two along edges, which ImprintCurves may have inserted.
class SurfaceDivision
{
public:
  /// joined: kept by reference. split: of the joined surface. isFeature: of each of its
  /// triangles.
  SurfaceDivision(const shape::Surface& surface, const WeldedSurface& joined, ImprintedCurves split,
    std::vector<char> isFeature);

  double CutLength() const { return this->Length; } ///< 0: there is one part only
  double MeanArea() const;                          ///< of the given triangles beside the cut

  /// The feature or the rest. Ids of its points are those of the joined surface after the split.
  DividedPart PartOf(bool feature) const;

  /// The boundary loops of a part that consist of cut edges only, with the part to the left; the
  /// longest first. ids: of its points.
  std::vector<std::vector<int>> CutLoops(const Mesh& part, const std::vector<int>& ids) const;

  /// Duplicates points of the cut at which triangles of a part touch without a common edge; the
  /// duplicates come last.
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
