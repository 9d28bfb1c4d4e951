#pragma once

#include "Base/Progress.h"
#include "Geometry/SampledSurface.h"

#include <Eigen/Core>

#include <string>
#include <vector>

class vtkPolyData;

/// Point clouds: data without polygons, whose points sample a surface.
namespace vtkShapeCloud
{

/// Returns whether the data are a point cloud: points alone, or vertices and lines. Lines alone are
/// curves.
bool IsPointCloud(vtkPolyData* data);

/// Returns the points with their normals, connected (shape::ConnectSamples). Normals are estimated
/// if the data have none. Throws shape::InvalidInput and shape::Aborted.
shape::SampledSurface Connect(vtkPolyData* data, const shape::Progress& progress);

/// Returns whether the data have normals at points.
bool HasNormals(vtkPolyData* data);

/// Returns the points of the first closed line, each once; empty if there is none.
std::vector<int> FindLoop(vtkPolyData* data);

/// Returns, for each point, the first vertex cell at it, or -1.
Eigen::VectorXi FindVertices(vtkPolyData* data);

/// Replaces the vertices of `output` by one for each point, in order. loop: if not empty, points of
/// a closed line, which replaces the lines.
void WriteCells(const std::vector<int>& loop, vtkPolyData* output);

} // namespace vtkShapeCloud
