#pragma once

#include "Core/Mesh.h"

class vtkPolyData;

namespace shape
{

/// A new vtkPolyData with the points (double) and triangles of `mesh`. The caller owns its one
/// reference (vtkSmartPointer's Take).
vtkPolyData* NewPolyData(const Mesh& mesh);

/// The points and triangles of `data`; its other cells are left out.
Mesh MeshFromPolyData(vtkPolyData* data);

} // namespace shape
