#pragma once

#include "Hex/HexRemesh.h"

class vtkDataObject;
class vtkUnstructuredGrid;

/// What Shape Hex Remesh says about its hexahedra.
namespace vtkShapeHexFacts
{

/// Adds Verdict's measures of each hexahedron as cell arrays: those that vtkShapeHexRemesh names.
void AddMeasures(vtkUnstructuredGrid* hexahedra);

/// Field data: the facts of vtkShapeHexRemesh, and of each measure of `hexahedra` the least, the
/// mean and the greatest.
void AddFacts(
  const shape::HexRemeshResult& result, vtkUnstructuredGrid* hexahedra, vtkDataObject* output);

} // namespace vtkShapeHexFacts
