#pragma once

#include "Correspondence/CommonBase/SurfaceCurves.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include "vtkType.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

class vtkIdList;
class vtkUnstructuredGrid;

/// The landmarks as they are given: points, their positions on SurfaceB, and lines.
class vtkShapeGivenLandmarks
{
public:
  /// targets: a row for each point. Throws shape::InvalidInput otherwise.
  vtkShapeGivenLandmarks(vtkUnstructuredGrid* grid, const Eigen::MatrixXd& targets);

  /// Pairs all points, and positions between them along lines. Lines are sampled at the mean edge
  /// length of the surface. Coarser samples would leave points between them unconstrained, and
  /// finer samples would have the same nearest points.
  shape::Landmarks PairAll(const shape::Surface& a, const shape::Surface& b) const;
  /// Pairs the points along each line, in order, with the same step.
  std::vector<shape::Landmarks> PairCurves(const shape::Surface& a, const shape::Surface& b) const;
  /// Pairs the points that no line passes: those of no line, of vertices, and at ends of lines.
  shape::Landmarks PairEnds(const shape::Surface& a, const shape::Surface& b) const;
  /// Returns the curve of each line along edges of both surfaces.
  std::vector<shape::CurvePair> TraceCurves(const shape::Surface& a, const shape::Surface& b) const;

private:
  struct Partners;
  void AddPoint(vtkIdType point, Partners& partners) const;
  /// Adds positions between two points, at the distance `step` on SurfaceA.
  void AddBetween(vtkIdType p, vtkIdType q, double step, Partners& partners) const;
  void AddLine(vtkIdList* points, double step, Partners& partners) const;
  /// Calls `use` with the point indices of each line.
  void ForEachLine(const std::function<void(vtkIdList*)>& use) const;

  vtkUnstructuredGrid* Grid;
  Eigen::MatrixXd Positions, Targets;
};
