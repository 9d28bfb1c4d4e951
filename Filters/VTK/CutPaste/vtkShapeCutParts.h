#pragma once

#include "CutPaste/CutFeature.h"
#include "Transfer/PreciseArrays.h"

class vtkPolyData;

/// Conversion of a cut feature, and of the rest of the surface, to VTK data.
namespace vtkShapeCutParts
{

/**
 * Writes the feature and the rest with the data of `surface` (vtkShapeCarry). vtkShapeFillValues
 * computes the data on fills. Adds `OriginalPointId` (vtkIdType; -1: new) to both, the cell array
 * `Filled` to the rest, and the base to the feature: see vtkShapeCutFeature. numbered: the
 * triangles of `surface`.
 */
void Write(const shape::CutFeatureResult& cut, const shape::NumberedSurface& numbered,
  vtkPolyData* surface, vtkPolyData* feature, vtkPolyData* rest);

/// Adds facts to one of the outputs: Loops, LoopsLeftOut, CutLength, FeatureArea, Holes,
/// WeldedPoints.
void AddFacts(const shape::CutFeatureResult& cut, vtkPolyData* output);

} // namespace vtkShapeCutParts
