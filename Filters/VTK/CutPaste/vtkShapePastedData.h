#pragma once

#include "CutPaste/PasteFeature.h"
#include "Transfer/PreciseArrays.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// Conversion of the inputs of Shape Paste Feature to kernel types, and of its result to VTK data.
namespace vtkShapePastedData
{

/// A surface and its triangles, with closed seams (shape::WeldedSurface).
struct Part
{
  vtkSmartPointer<vtkPolyData> Data;
  shape::NumberedSurface Triangles; ///< has only the points that a triangle uses
  std::vector<int> Points;          ///< for each point of Triangles, its index in Data
  int WeldedPoints = 0;
};

/// Reads a surface. name: denotes the data in errors. Throws the exceptions of
/// shape::WeldedSurface.
Part Read(vtkPolyData* data, const std::string& name, const shape::Progress& progress);

/**
 * Writes the pasted surface with the point and cell arrays of target and feature. If only one of
 * them has an array, its values are 0 on the other. If arrays with the same name have different
 * types or numbers of components, only the array of the target is kept. Floating-point values and
 * colours (unsigned char) at the points of the feature are changed to agree with the target at the
 * loop (shape::BlendAtSeam). blendWidth: the width of the changed band, as a share of the depth of
 * the feature. The cells of the seam band get the values of the target at the loop. `Normals` are
 * dropped. The cell array `Part` is 0 on the target, 1 on the seam band and 2 on the feature.
 */
void Write(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const Part& target, const Part& featurePart, double blendWidth, vtkPolyData* output);

} // namespace vtkShapePastedData
