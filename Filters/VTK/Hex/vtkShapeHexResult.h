#pragma once

#include "Hex/HexRemesh.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

/// What Shape Hex Remesh puts out, with the arrays and facts that vtkShapeHexRemesh names.
namespace vtkShapeHexResult
{

void WriteHexahedra(const shape::HexFit& fit, vtkUnstructuredGrid* output);

/// The quads of the boundary, then those of the interfaces. innerSurfaces: one for each of these.
void WriteBoundary(const shape::HexRemeshResult& result, const shape::Surface& surface,
  const std::vector<shape::Surface>& innerSurfaces, vtkPolyData* output);

/// Field data. hexahedra: as they are written.
void AddFacts(
  const shape::HexRemeshResult& result, vtkUnstructuredGrid* hexahedra, vtkDataObject* output);

} // namespace vtkShapeHexResult
