#pragma once

#include "CutPaste/CutFeature.h"

#include <vector>

class vtkPolyData;

/**
 * Conversion of the bases of a feature to VTK data and back. A base is the filled surface on which
 * the feature stood at one of its loops when it was cut. The data are the point arrays
 * `LoopCoordinates`, `LoopNormal` and, if loops cross gaps, `LoopOrder`, and the field data
 * CutFeature.Seed, .SeedNormal, .SeedDirection, .ConformalRadius and .Refined: see
 * vtkShapeCutFeature.
 */
namespace vtkShapeFeatureBase
{

/// Writes the bases of a cut feature to `feature`, if it has any. ids: the id of each of its points
/// (shape::DividedPart); all duplicate points of a seam get the same values. crossesGaps: whether
/// loops have sides that are no edges of the feature.
void Write(const std::vector<shape::FeatureFootprint>& bases, const std::vector<int>& ids,
  bool crossesGaps, vtkPolyData* feature);

/// A feature to be pasted.
struct Feature
{
  std::vector<shape::FeatureFootprint> Bases; ///< the one at the seed first
  bool HasOwnFill; ///< if true, no base was stored, and fills of the feature's loops replace them
};

/**
 * Returns the bases of a feature at one or all of its loops. surface: the points and triangles of
 * `data`. A point cloud has a single loop, its closed line, and local triangles. Throws
 * shape::InvalidInput if there is no such loop, the exceptions of shape::BuildFootprintOnOwnFill,
 * and shape::Aborted.
 */
Feature Read(vtkPolyData* data, const shape::Mesh& surface, const shape::JoinedLoops& joined,
  const shape::Progress& progress);

} // namespace vtkShapeFeatureBase
