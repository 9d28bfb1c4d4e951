#pragma once

#include "CutPaste/CutPoints.h"

class vtkPolyData;

/// Conversion of a feature that was cut from a point cloud, and of the rest, to VTK data.
namespace vtkShapeCutCloud
{

/**
 * Writes the feature and the rest with the data of `cloud` (vtkShapeCarry), as vertices. A closed
 * line through the loop's points follows: in the feature always, in the rest if it was not filled.
 * Values at the points of the fill are harmonic. Adds normals, `OriginalPointId` (vtkIdType; -1:
 * new), the cell array `Filled` to the rest, and the base to the feature: see vtkShapeCutFeature.
 * samples: the connected points of `cloud`.
 */
void Write(const shape::CutPointsResult& cut, const shape::SampledSurface& samples,
  vtkPolyData* cloud, vtkPolyData* feature, vtkPolyData* rest);

/// Adds facts to one of the outputs. spacing: the mean distance of neighbouring points.
void AddFacts(
  const shape::CutPointsResult& cut, double spacing, bool hasEstimatedNormals, vtkPolyData* output);

} // namespace vtkShapeCutCloud
