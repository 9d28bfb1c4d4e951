#pragma once

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

/// What the handles need of a view: pixels and places, and things drawn at a size in pixels.
namespace pqShapeDisplay
{

/// The line of sight through a pixel: from a place on the near plane into a direction of length 1.
/// It goes on behind both planes, which depend on what else is shown, but not behind the viewer,
/// who is at First (in the direction, from the place; a parallel projection has him infinitely far
/// away).
struct Ray
{
  Eigen::Vector3d Near, Direction;
  double First;
};
Ray ToRay(vtkRenderer* renderer, const Eigen::Vector2d& pixel);

/// The pixel where a place is seen.
Eigen::Vector2d ToPixel(vtkRenderer* renderer, const Eigen::Vector3d& position);

/// How many pixels of a dense screen are one of a usual one.
double PixelScale(vtkRenderer* renderer);

/// How long a pixel of a usual screen is in the model's units at a place.
double PixelLength(vtkRenderer* renderer, const Eigen::Vector3d& position);

/// Whether a plane through a place is seen from its front.
bool FacesViewer(
  vtkRenderer* renderer, const Eigen::Vector3d& position, const Eigen::Vector3d& normal);

/// A ball of radius 1 around the origin; PlaceBall moves and scales it.
vtkSmartPointer<vtkActor> MakeBall();
void PlaceBall(vtkActor* ball, const Eigen::Vector3d& centre, double radius);

/// A line through the points of `curve`, or dots at its vertices; SetWidth takes pixels of a usual
/// screen.
vtkSmartPointer<vtkActor> MakeCurve(vtkPolyData* curve);
void SetWidth(vtkActor* curve, vtkRenderer* renderer, double width);

/// Makes `curve` one polyline through places.
void SetCurve(vtkPolyData* curve, const std::vector<Eigen::Vector3d>& positions);

/// Makes `marks` separate places.
void SetMarks(vtkPolyData* marks, const std::vector<Eigen::Vector3d>& positions);

} // namespace pqShapeDisplay
