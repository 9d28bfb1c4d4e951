#pragma once

#include "CutPaste/PasteFeature.h"
#include "Geometry/SampledSurface.h"
#include "Mesh/Mesh.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

/// Conversion of the inputs of Shape Paste Feature to kernel types, and of its result to VTK data.
namespace vtkShapePastedData
{

/// A surface of triangles with closed seams (shape::WeldedSurface), or a point cloud with its local
/// triangles (shape::ConnectSamples), and its data.
struct Part
{
  shape::Mesh Surface;               ///< without points that no triangle uses
  vtkSmartPointer<vtkPolyData> Data; ///< the same surface with its point and cell data
  int WeldedPoints = 0;
  shape::SampledSurface Samples; ///< of a point cloud
};

/// Converts `data` and closes its seams. name: denotes the data in errors. Throws the exceptions of
/// shape::WeldedSurface.
Part Read(vtkPolyData* data, const std::string& name, const shape::Progress& progress);

/// Converts a point cloud. Throws the exceptions of shape::ConnectSamples.
Part ReadCloud(vtkPolyData* data, const shape::Progress& progress);

/// Samples a surface that Read converted, no coarser than `spacing` (shape::SampleTriangles).
Part SamplePart(const Part& part, double spacing, const shape::Progress& progress);

/// Returns unit normals at the points of a part: those of the point cloud, or of the surface, as
/// SamplePart would have them. Throws shape::Aborted.
Eigen::MatrixXd NormalsOf(const Part& part, const shape::Progress& progress);

/**
 * Writes the pasted surface with the data of target and feature (vtkShapeCarry). If both have a
 * point array of the same name, its values on the feature are changed to agree with the target's
 * values at the loop (shape::BlendAtSeam). blendWidth: the width of the band in which values are
 * changed, divided by the depth of the feature. The cells of the seam band get the values of the
 * target at the loop. The cell array `Part` is 0 on the target, 1 on the seam band and 2 on the
 * feature. Normals are dropped; a point cloud gets those of its points.
 */
void Write(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const Part& target, const Part& featurePart, double blendWidth, vtkPolyData* output);

/// Writes the loop of the feature on the target as lines, which are a Boundary of vtkShapeDeform:
/// with the point arrays `SourcePosition`, `SourceNormal`, `TargetNormal`, `FrameRotation` and
/// `FrameSet`.
void WriteLoop(
  const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature, vtkPolyData* output);

} // namespace vtkShapePastedData
