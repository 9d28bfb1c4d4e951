#pragma once

#include "CutPaste/PasteFeature.h"
#include "Mesh/Mesh.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

/// Conversion of the result of Shape Paste Feature to data.
namespace vtkShapePastedData
{

/// A surface and its triangles, with closed seams (shape::WeldedSurface).
struct Part
{
  shape::Mesh Surface;               ///< without points that no triangle uses
  vtkSmartPointer<vtkPolyData> Data; ///< the same with the data of its points and cells
  int WeldedPoints = 0;
};

/// Reads a surface. name: denotes the data in errors. Throws shape::InvalidInput as
/// shape::WeldedSurface does.
Part Read(vtkPolyData* data, const std::string& name, const shape::Progress& progress);

/**
 * Writes the pasted surface with the data of both parts (vtkShapeCarry). If both parts have an
 * array, its values at the feature's points are blended to agree with the target's at the loop:
 * shape::BlendAtSeam over `blendWidth` of the feature's depth. The band's cells get the target's
 * values there. The cell array `Part` is 0 on the target, 1 on the band and 2 on the feature.
 */
void Write(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const Part& target, const Part& featurePart, double blendWidth, vtkPolyData* output);

} // namespace vtkShapePastedData
