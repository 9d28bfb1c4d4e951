#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Geometry/SampledSurface.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A feature's loop on a point cloud, and the points below the feature.
struct LoopOnPoints
{
  TangentFrame Seed;            ///< see LoopOnTarget
  Eigen::MatrixXd Positions;    ///< n x 3: positions of the loop's points on the sampled surface
  Eigen::MatrixXd Normals;      ///< n x 3: unit normals there
  std::vector<char> IsAtSample; ///< for each point of the loop, whether it replaces a sample
  std::vector<char> IsRemoved;  ///< for each point, whether it is below the feature or on its loop
  /// For each point, whether a local triangle joins it to a removed one.
  std::vector<char> IsNearHole;
  int Covered = 0; ///< number of points below the feature
};

/**
 * A point cloud on which features are pasted. Samples are all that the method needs (Schmidt and
 * Singh, "Drag-and-drop surface composition", section 1). The exponential map of its local
 * triangles (ConnectSamples) carries the loop. Points whose images are inside it are removed; so
 * are points at which a point of the loop lies, within a thousandth of the spacing: the latter
 * replaces them.
 */
class PointTarget
{
public:
  /// samples: with local triangles. Throws the exceptions of ExponentialMap.
  explicit PointTarget(SampledSurface samples, const ExponentialMapOptions& options = {},
    const Progress& progress = {});

  const shape::Surface& Surface() const { return this->Map.Surface(); }
  const SurfaceLocator& Closest() const { return this->Map.Locator(); }
  ExponentialMap& Layout() { return this->Map; }
  const SampledSurface& Sampled() const { return this->Samples; }
  double Spacing() const { return this->MeanLink; } ///< mean length of an edge of local triangles

  /// Maps the base's loop to the points, as PasteTarget::Land does to a manifold. Throws
  /// InvalidInput if a point of the loop is beyond the patch or in a gap; Aborted.
  LoopOnPoints Land(
    const FeatureFootprint& base, const PastePlacement& placement, const Progress& progress = {});

private:
  SampledSurface Samples;
  ExponentialMap Map;
  double MeanLink;
};

/// The vertices of a surface, and midpoints of its edges, as samples of it.
struct SurfaceSamples
{
  SampledSurface Samples;
  /// Copies of the surface's points, then midpoints; no cells.
  Provenance Origin;
};

/// Samples any triangles: edges are split in two until none is longer than `spacing`, and the
/// points are connected (ConnectSamples), with the surface's normals if it is an oriented manifold,
/// otherwise with estimated ones. Throws InvalidInput if spacing is not positive; Aborted.
SurfaceSamples SampleTriangles(
  const Surface& surface, double spacing, const Progress& progress = {});

} // namespace shape
