#pragma once

#include "CutPaste/PasteFeature.h"
#include "Transfer/PreciseArrays.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// The result of Shape Paste Feature as data.
namespace vtkShapePastedData
{

/// A surface and its triangles, seams closed (shape::WeldedSurface).
struct Part
{
  vtkSmartPointer<vtkPolyData> Data;
  shape::NumberedSurface Triangles; ///< of points that triangles use alone
  std::vector<int> Points;          ///< of each of these: the one of Data
  int WeldedPoints = 0;
};

/// name: what an error calls the data. Throws shape::InvalidInput as shape::WeldedSurface.
Part Read(vtkPolyData* data, const std::string& name, const shape::Progress& progress);

/**
 * Writes the pasted surface with the arrays of points and cells of both parts. Where only one part
 * has an array, the other has zeros; arrays of the same name but of another type or number of
 * components count as different, and the target's is kept. Floating-point numbers and colours
 * (unsigned char) of the feature's points meet the target's at the loop: shape::BlendAtSeam over
 * `blendWidth` of the feature's depth. The band's cells take what the target has there. `Normals`
 * are left out. The cell array `Part` is 0 on the target, 1 on the band and 2 on the feature.
 */
void Write(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const Part& target, const Part& featurePart, double blendWidth, vtkPolyData* output);

} // namespace vtkShapePastedData
