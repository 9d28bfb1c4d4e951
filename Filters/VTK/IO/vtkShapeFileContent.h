#pragma once

#include "Mesh/Cells.h"

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace shape
{
struct CADModel;
struct MeditMesh;
struct OFFSurface;
} // namespace shape

/// Files as VTK data sets.
namespace vtkShapeFileContent
{

/// Returns all bytes of a file. Throws shape::InvalidInput if it cannot be read.
std::string Read(const std::string& path);

/// Fills a surface with points, faces and the arrays of vtkShapeOFFReader.
void ToPolyData(const shape::OFFSurface& surface, vtkPolyData* output);

/// Fills a surface with triangles and another one with polylines, and both with the arrays of
/// vtkShapeCADReader.
void ToPolyData(const shape::CADModel& model, vtkPolyData* surface, vtkPolyData* edges);

/// Fills a grid with points, cells and the arrays of vtkShapeMeditReader.
void ToGrid(const shape::MeditMesh& mesh, vtkUnstructuredGrid* output);

} // namespace vtkShapeFileContent
