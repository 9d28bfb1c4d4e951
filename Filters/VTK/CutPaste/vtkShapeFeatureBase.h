#pragma once

#include "CutPaste/CutFeature.h"

class vtkPolyData;

/**
 * Conversion of the base of a feature to VTK data and back. The base is the filled surface on which
 * the feature stood when it was cut. The data are the point arrays `LoopCoordinates` and
 * `LoopNormal` and the field data CutFeature.SeedNormal, .SeedDirection, .ConformalRadius and
 * .Refined: see vtkShapeCutFeature.
 */
namespace vtkShapeFeatureBase
{

/// Writes the base of a cut feature to `feature`, if it has one. All duplicate points of a seam get
/// the same values.
void Write(const shape::CutFeatureResult& cut, vtkPolyData* feature);

/// A feature to be pasted.
struct Feature
{
  shape::FeatureFootprint Base;
  bool HasOwnFill; ///< if true, no base was stored, and a fill of the feature's loop replaces it
};

/**
 * Returns the base of a feature at one of its loops. surface: the points and triangles of `data`.
 * loopIndex: 0 for the loop that was cut or, if none was cut, the longest loop. Throws
 * shape::InvalidInput if there is no such loop, the exceptions of shape::BuildFootprintOnOwnFill,
 * and shape::Aborted.
 */
Feature Read(
  vtkPolyData* data, const shape::Mesh& surface, int loopIndex, const shape::Progress& progress);

} // namespace vtkShapeFeatureBase
