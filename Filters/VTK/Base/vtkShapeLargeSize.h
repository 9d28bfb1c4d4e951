#pragma once

#include <string>

class vtkPolyData;

/// Warnings about sizes in the panel that are too large for the data, as when units are mixed up.
namespace vtkShapeLargeSize
{

/// Returns a warning if a cell size exceeds a quarter of the longest side of the bounding box;
/// otherwise, an empty text. With fewer than four cells, at most one cell is left between the
/// layers of cells along the surface.
std::string CheckCellSize(const std::string& property, double value, vtkPolyData* surface);

/// The same if the radius of a patch exceeds the diagonal of the bounding box. Such a patch covers
/// most of a simple shape.
std::string CheckRadius(const std::string& property, double value, vtkPolyData* surface);

/// The same if the bound on the volume of a cell exceeds the volume of the solid.
std::string CheckCellVolume(const std::string& property, double value, double solid);

} // namespace vtkShapeLargeSize
