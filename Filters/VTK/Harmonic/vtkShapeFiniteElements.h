#pragma once

#include "Harmonic/FiniteElementMap.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkDataArray;
class vtkIntArray;
class vtkMultiProcessController;
class vtkPolyData;

/**
 * Conversion of volume maps of finite elements to VTK data and back. The points are those of the
 * tetrahedra, with the point array `TargetPosition` (double, 3 components), and `Charge` (double, 3
 * components), which is 0: there are no charges. The cells are the surface of the solid. The field
 * data array `Tetrahedra` (int, 4 components) has the points of each tetrahedron.
 */
namespace vtkShapeFiniteElements
{

/// Whether the data are a map of finite elements, and no charge set.
bool Has(vtkPolyData* data);

/// Reads a map. name: denotes the data in errors. Throws shape::InvalidInput if arrays are missing
/// or do not fit.
shape::FiniteElements Read(vtkPolyData* data, const std::string& name);

/// Copies the map of the first process to every process.
void Share(vtkMultiProcessController* controller, shape::FiniteElements& elements);

///@{
/// The corners of tetrahedra as an array of 4 components, and back.
vtkSmartPointer<vtkIntArray> WriteCorners(
  const Eigen::MatrixXi& tetrahedra, const std::string& name);
Eigen::MatrixXi ReadCorners(vtkDataArray* array);
///@}

/// Writes a map to `output`.
void Write(const shape::FiniteElements& elements, vtkPolyData* output);

} // namespace vtkShapeFiniteElements
