#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;

/// A surface on which a filter computes instead of the gathered one (shape::RepairSheets).
struct vtkShapeRepaired
{
  /// Its first points are those of the gathered surface; its polygons are triangles. The same
  /// object if there was nothing to repair; then the lists are empty.
  vtkSmartPointer<vtkPolyData> Data;
  std::vector<int> Points;    ///< for each point, the gathered point at its position
  std::vector<int> Triangles; ///< for each triangle, the triangle of the gathered surface
  std::vector<int> Cells;     ///< for each cell, the gathered cell
  /// For each gathered point, the point that represents it: usually itself.
  std::vector<int> Representatives;
  int SplitPoints = 0, RemovedTriangles = 0;
  std::string Description; ///< what was done, for a warning; empty if nothing

  /// Returns the indices (-1: none), each replaced by its entry in one of the lists. An empty list
  /// changes nothing.
  static Eigen::VectorXi ToGiven(const std::vector<int>& list, const Eigen::VectorXi& indices);
};

/// The repair of the surfaces of one input. Repeated calls with an unchanged sound surface only
/// compare modification times, as during a drag.
class vtkShapeRepair
{
public:
  /// name: denotes the surface in texts. separate: see shape::SheetRepairOptions. Surfaces without
  /// polygons, and with coordinates that are not finite, are returned as they are. Throws
  /// shape::InvalidInput if a polygon cannot be triangulated.
  vtkShapeRepaired Apply(vtkPolyData* data, const std::string& name, bool separate);

private:
  vtkSmartPointer<vtkPoints> SoundPoints;
  vtkSmartPointer<vtkCellArray> SoundPolys, SoundStrips;
  std::array<vtkMTimeType, 3> Times{};
  bool IsSeparated = false;
};
