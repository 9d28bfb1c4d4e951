#pragma once

#include "CutPaste/CutFeature.h"
#include "Transfer/PreciseArrays.h"

class vtkPolyData;

/// A feature that was cut, and the rest of the surface, as data.
namespace vtkShapeCutParts
{

/**
 * Writes both with the data of `surface` (vtkShapeCarry) and, on fills, what vtkShapeFillValues
 * makes of them. Adds `OriginalPointId` (vtkIdType; -1: new), to the rest the cell array `Filled`,
 * and to the feature what it stood on: see vtkShapeCutFeature. numbered: the surface's triangles.
 */
void Write(const shape::CutFeatureResult& cut, const shape::NumberedSurface& numbered,
  vtkPolyData* surface, vtkPolyData* feature, vtkPolyData* rest);

/// Field data of both: Loops, LoopsLeftOut, CutLength, FeatureArea, Holes, WeldedPoints.
void AddFacts(const shape::CutFeatureResult& cut, vtkPolyData* output);

} // namespace vtkShapeCutParts
