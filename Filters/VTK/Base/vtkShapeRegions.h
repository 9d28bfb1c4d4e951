#pragma once

#include <Eigen/Core>

#include <string>

class vtkPolyData;

namespace vtkShapeRegions
{

/// Returns the cell array Regions (m x 2): the labels of the regions on both sides of each
/// triangle; empty if there is none. triangles: m. name: denotes the surface in messages. Throws
/// shape::InvalidInput if the array has not 2 components, or if cells are not triangles.
Eigen::MatrixXi Read(vtkPolyData* surface, Eigen::Index triangles, const std::string& name);

/// Throws shape::InvalidInput if regions of a surface touch: if triangles of its cell array Regions
/// lie between two of them. name: denotes the surface in messages.
void RequireNoneTouch(vtkPolyData* surface, const std::string& name);

} // namespace vtkShapeRegions
