#pragma once

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkIdList;
class vtkPolyData;

/// The triangles of a surface, and the polygon or strip of each: strips follow the polygons.
struct vtkShapeTriangulation
{
  /**
   * Triangulates the polygons as vtkTriangleFilter does. A polygon may have sides of length 0, as
   * ParaView's Clip makes them where it cuts through points. Its repeated corners (FindRepeated)
   * are left out, and become corners of triangles without area, so that neighbours stay connected.
   * Throws shape::InvalidInput if a polygon cannot be triangulated. `name` denotes the surface in
   * the message.
   */
  static vtkShapeTriangulation Of(vtkPolyData* surface, const std::string& name);

  /// Returns, for each corner of a polygon, whether it is at the position of the corner before it,
  /// to 1e-5 of the polygon's size.
  static std::vector<bool> FindRepeated(vtkPolyData* surface, vtkIdList* corners);

  std::vector<std::array<vtkIdType, 3>> Triangles; ///< points, in order
  std::vector<int> CellOf;

  void Add(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
  {
    this->Triangles.push_back({ a, b, c });
    this->CellOf.push_back(static_cast<int>(cell));
  }
};
