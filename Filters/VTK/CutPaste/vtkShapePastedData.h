#pragma once

#include "CutPaste/PasteFeature.h"
#include "Mesh/Mesh.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

/// The result of Shape Paste Feature as data.
namespace vtkShapePastedData
{

/// A surface and its triangles, seams closed (shape::WeldedSurface).
struct Part
{
  shape::Mesh Surface;               ///< of points that triangles use alone
  vtkSmartPointer<vtkPolyData> Data; ///< the same with the data of its points and cells
  int WeldedPoints = 0;
};

/// name: what an error calls the data. Throws shape::InvalidInput as shape::WeldedSurface.
Part Read(vtkPolyData* data, const std::string& name, const shape::Progress& progress);

/**
 * Writes the pasted surface with the data of both parts (vtkShapeCarry). Values of the feature's
 * points, if both parts have the array, meet the target's at the loop: shape::BlendAtSeam over
 * `blendWidth` of the feature's depth. The band's cells take what the target has there. The cell
 * array `Part` is 0 on the target, 1 on the band and 2 on the feature.
 */
void Write(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const Part& target, const Part& featurePart, double blendWidth, vtkPolyData* output);

} // namespace vtkShapePastedData
