#pragma once

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

/// Conversion between pixels and positions in a view, and actors whose size is given in pixels.
namespace pqShapeDisplay
{

/// The line of sight through a pixel: a position on the near plane and a unit direction. It is not
/// limited by the near and far planes, because they depend on other data in the view. It starts at
/// the viewer, at distance First from Near along Direction (minus infinity for parallel
/// projection).
struct Ray
{
  Eigen::Vector3d Near, Direction;
  double First;
};
Ray ToRay(vtkRenderer* renderer, const Eigen::Vector2d& pixel);

/// Returns the pixel at which a position is seen.
Eigen::Vector2d ToPixel(vtkRenderer* renderer, const Eigen::Vector3d& position);

/// Returns the number of pixels of this screen for one pixel of a screen of standard density.
double PixelScale(vtkRenderer* renderer);

/// Returns the length of a pixel of a standard screen at a position, in the model's units.
double PixelLength(vtkRenderer* renderer, const Eigen::Vector3d& position);

/// Returns whether the plane through a position with a normal is seen from its front.
bool FacesViewer(
  vtkRenderer* renderer, const Eigen::Vector3d& position, const Eigen::Vector3d& normal);

/// Makes a ball of radius 1 around the origin; PlaceBall moves and scales it.
vtkSmartPointer<vtkActor> MakeBall();
void PlaceBall(vtkActor* ball, const Eigen::Vector3d& centre, double radius);

/// Makes an actor that draws the lines of `curve`, and dots at its vertices. The width is in pixels
/// of a standard screen.
vtkSmartPointer<vtkActor> MakeCurve(vtkPolyData* curve);
void SetWidth(vtkActor* curve, vtkRenderer* renderer, double width);

/// Makes `curve` one polyline through the positions.
void SetCurve(vtkPolyData* curve, const std::vector<Eigen::Vector3d>& positions);

/// Makes `marks` one vertex at each position.
void SetMarks(vtkPolyData* marks, const std::vector<Eigen::Vector3d>& positions);

} // namespace pqShapeDisplay
