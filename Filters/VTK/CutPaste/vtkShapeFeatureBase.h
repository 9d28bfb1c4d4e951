#pragma once

#include "CutPaste/CutFeature.h"

class vtkPolyData;

/**
 * What a feature stood on where it was cut, as data: the point arrays `LoopCoordinates` and
 * `LoopNormal` and the field data CutFeature.Seed, .SeedNormal, .SeedDirection,
 * .ConformalRadius, .Refined and .ReturnsInPlace: see vtkShapeCutFeature.
 */
namespace vtkShapeFeatureBase
{

/// Writes that of a cut that has one. At a seam, whose points are doubled, all of them have it.
void Write(const shape::CutFeatureResult& cut, vtkPolyData* feature);

/// A feature that is to be set down again.
struct Feature
{
  shape::FeatureFootprint Base;
  bool HasOwnFill; ///< whether nothing is known of what it stood on
};

/**
 * The feature's base at one of its loops. surface: the points and triangles of `data`. loopIndex:
 * the longest of the loops being 0, or the one that was cut. Throws shape::InvalidInput if there is
 * no such loop, and as shape::BuildFootprintOnOwnFill; shape::Aborted.
 */
Feature Read(
  vtkPolyData* data, const shape::Mesh& surface, int loopIndex, const shape::Progress& progress);

} // namespace vtkShapeFeatureBase
