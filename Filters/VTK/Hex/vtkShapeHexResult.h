#pragma once

#include "Hex/HexRemesh.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

/// Conversion of the result of Shape Hex Remesh to VTK data, with the arrays and facts that
/// vtkShapeHexRemesh documents.
namespace vtkShapeHexResult
{

/// Writes the hexahedra with their arrays.
void WriteHexahedra(
  const shape::HexFit& fit, const shape::HexGrid& grid, vtkUnstructuredGrid* output);

/// Writes the grid whose cells became the hexahedra.
void WriteGrid(const shape::HexFit& fit, const shape::HexGrid& grid, vtkUnstructuredGrid* output);

/// Writes the quads of the boundary, then the quads of each interface. innerSurfaces: the inner
/// surface of each interface; empty if `surface` has the interfaces, too.
void WriteBoundary(const shape::HexRemeshResult& result, const shape::Surface& surface,
  const std::vector<shape::Surface>& innerSurfaces, vtkPolyData* output);

/// Adds the facts. hexahedra: the output of WriteHexahedra.
void AddFacts(
  const shape::HexRemeshResult& result, vtkUnstructuredGrid* hexahedra, vtkDataObject* output);

} // namespace vtkShapeHexResult
