#pragma once

#include "CutPaste/PasteFeature.h"
#include "Transfer/PreciseArrays.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// Conversion of the result of Shape Paste Feature to data.
namespace vtkShapePastedData
{

/// A surface and its triangles, with closed seams (shape::WeldedSurface).
struct Part
{
  vtkSmartPointer<vtkPolyData> Data;
  shape::NumberedSurface Triangles; ///< over points that triangles use only
  std::vector<int> Points;          ///< for each of these points, the point of Data
  int WeldedPoints = 0;
};

/// Reads a surface. name: denotes the data in errors. Throws shape::InvalidInput as
/// shape::WeldedSurface does.
Part Read(vtkPolyData* data, const std::string& name, const shape::Progress& progress);

/**
 * Writes the pasted surface with the arrays of points and cells of both parts. If only one part has
 * an array, it is 0 on the other one. Arrays with the same name but different types or numbers of
 * components are different arrays, of which the target's is kept. Floating-point numbers and
 * colours (unsigned char) at the feature's points are blended to agree with the target's at the
 * loop: shape::BlendAtSeam over `blendWidth` of the feature's depth. The band's cells get the
 * target's values there. `Normals` are left out. The cell array `Part` is 0 on the target, 1 on the
 * band and 2 on the feature.
 */
void Write(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const Part& target, const Part& featurePart, double blendWidth, vtkPolyData* output);

} // namespace vtkShapePastedData
