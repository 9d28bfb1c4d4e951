#pragma once

#include "pqShapeDisplay.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <Eigen/Core>

#include <functional>

class vtkPolyData;
class vtkRenderer;
class vtkSMProperty;
class vtkSMSourceProxy;
class vtkStaticCellLocator;

/// A position on a surface, and the unit normal at this position. The normal is interpolated from
/// the normals at the corners of the triangle.
struct pqShapePlace
{
  Eigen::Vector3d Position = Eigen::Vector3d::Zero();
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitZ();
};

/**
 * The input surface of a filter, for finding the position under the mouse.
 *
 * The view shows the output of the filter, but the position must be on its input. Therefore, the
 * client keeps a copy of the input, without arrays. The copy has the pieces of all processes of the
 * server. It is fetched again when the input has changed.
 */
class pqShapeSurface
{
public:
  /// input: the input property of the filter. outdated: called when the input has changed.
  pqShapeSurface(vtkSMProperty* input, const std::function<void()>& outdated);
  ~pqShapeSurface();
  pqShapeSurface(const pqShapeSurface&) = delete;
  void operator=(const pqShapeSurface&) = delete;

  /// Fetches the input at the given time, unless the copy is up to date. Returns whether there is a
  /// surface.
  bool Update(double time);
  bool IsThere() const { return this->Data != nullptr; }
  double GetTime() const { return this->Time; }    ///< the time of the last Update
  int GetVersion() const { return this->Version; } ///< changes with each fetched surface

  /// Finds the first position on the line of sight through a pixel. Returns false if there is none.
  bool FindUnder(vtkRenderer* renderer, const Eigen::Vector2d& pixel, pqShapePlace& place) const;

  /// Finds the first position on a line of sight, in the coordinates of the surface.
  bool FindAlong(const pqShapeDisplay::Ray& ray, pqShapePlace& place) const;

  /// Returns the position closest to a point.
  pqShapePlace FindClosest(const Eigen::Vector3d& point) const;

  /// Returns the centre, or half the diagonal, of the bounding box of the surface.
  Eigen::Vector3d GetCentre() const;
  double GetSize() const;

private:
  void Observe(vtkSMSourceProxy* source, int port);
  void Fetch(double time);
  pqShapePlace MakeSurfacePoint(vtkIdType cell, const Eigen::Vector3d& position) const;
  void Forget();

  vtkWeakPointer<vtkSMProperty> Input;
  std::function<void()> Outdated;
  vtkWeakPointer<vtkSMSourceProxy> Source;
  int Port = 0;
  unsigned long Observer = 0;
  bool Fresh = false;
  double Time = 0.0;
  int Version = 0;
  vtkSmartPointer<vtkPolyData> Data;
  vtkSmartPointer<vtkStaticCellLocator> Locator;
};
