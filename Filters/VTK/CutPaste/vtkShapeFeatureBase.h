#pragma once

#include "CutPaste/CutFeature.h"

class vtkPolyData;

/**
 * Conversion of the base of a feature, on which it stood when it was cut, to data and back. The
 * data are the point arrays `LoopCoordinates` and `LoopNormal` and the field data CutFeature.Seed,
 * .SeedNormal, .SeedDirection, .ConformalRadius, .Refined and .ReturnsInPlace: see
 * vtkShapeCutFeature.
 */
namespace vtkShapeFeatureBase
{

/// Writes the base of a cut, if it has one. All duplicate points of a seam get the same values.
void Write(const shape::CutFeatureResult& cut, vtkPolyData* feature);

/// A feature to be pasted.
struct Feature
{
  shape::FeatureFootprint Base;
  bool HasOwnFill; ///< whether the base is unknown and a fill of the feature's loop replaces it
};

/**
 * Returns the feature's base at one of its loops. surface: the points and triangles of `data`.
 * loopIndex: 0 for the longest loop, or the one that was cut. Throws shape::InvalidInput if there
 * is no such loop, the exceptions of shape::BuildFootprintOnOwnFill, shape::Aborted.
 */
Feature Read(
  vtkPolyData* data, const shape::Mesh& surface, int loopIndex, const shape::Progress& progress);

} // namespace vtkShapeFeatureBase
