#pragma once

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <Eigen/Core>

#include <functional>

class vtkPolyData;
class vtkRenderer;
class vtkSMProperty;
class vtkSMSourceProxy;
class vtkStaticCellLocator;

/// A place on a surface, and the unit normal there, which the corners' normals make smooth.
struct pqShapePlace
{
  Eigen::Vector3d Position = Eigen::Vector3d::Zero();
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitZ();
};

/**
 * The surface that goes into a filter, for finding what lies under the mouse.
 *
 * The view cannot be asked: it shows the filter's output, while a place is wanted on the input. So
 * the window keeps a copy of its own, without arrays, which is fetched from the server where there
 * is one, all processes' pieces together. It is fetched again after the input has changed.
 */
class pqShapeSurface
{
public:
  /// `input` is the filter's input property; `outdated` is called when the input has changed.
  pqShapeSurface(vtkSMProperty* input, const std::function<void()>& outdated);
  ~pqShapeSurface();
  pqShapeSurface(const pqShapeSurface&) = delete;
  void operator=(const pqShapeSurface&) = delete;

  /// Fetches what is new, as it is at a time. Returns whether there is a surface.
  bool Update(double time);
  bool IsThere() const { return this->Data != nullptr; }
  double GetTime() const { return this->Time; }    ///< of the last Update
  int GetVersion() const { return this->Version; } ///< another for each surface fetched

  /// The first place that the line of sight through a pixel meets; false where it meets none.
  bool FindUnder(vtkRenderer* renderer, const Eigen::Vector2d& pixel, pqShapePlace& place) const;

  /// The place closest to a point.
  pqShapePlace FindClosest(const Eigen::Vector3d& point) const;

  /// Half the diagonal of the box around the surface.
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
