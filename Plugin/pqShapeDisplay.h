#pragma once

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

/// Conversion between pixels and positions in a view, and actors with sizes in pixels.
namespace pqShapeDisplay
{

/// The line of sight through a pixel. Near is its position on the near plane, and Direction a unit
/// vector. The near and far planes do not limit the line, because they depend on other data in the
/// view. It starts at the viewer, whose position is Near + First * Direction. In parallel
/// projection, First is minus infinity.
struct Ray
{
  Eigen::Vector3d Near, Direction;
  double First;
};
Ray ToRay(vtkRenderer* renderer, const Eigen::Vector2d& pixel);

/// Returns the pixel at which a position appears.
Eigen::Vector2d ToPixel(vtkRenderer* renderer, const Eigen::Vector3d& position);

/// Returns the number of pixels of this screen that are as long as one pixel of a standard screen.
double PixelScale(vtkRenderer* renderer);

/// Returns the length, in the units of the model, that covers one pixel of a standard screen at a
/// position.
double PixelLength(vtkRenderer* renderer, const Eigen::Vector3d& position);

/// Returns whether the viewer is in front of the plane through `position` with the normal `normal`.
bool FacesViewer(
  vtkRenderer* renderer, const Eigen::Vector3d& position, const Eigen::Vector3d& normal);

/// Makes a ball of radius 1 around the origin; PlaceBall moves and scales it.
vtkSmartPointer<vtkActor> MakeBall();
void PlaceBall(vtkActor* ball, const Eigen::Vector3d& centre, double radius);

/// Makes an actor that draws the lines of `curve`, and dots at its vertices. SetWidth sets the
/// width of the lines, in pixels of a standard screen.
vtkSmartPointer<vtkActor> MakeCurve(vtkPolyData* curve);
void SetWidth(vtkActor* curve, vtkRenderer* renderer, double width);

/// Replaces the content of `curve` by one polyline through the positions.
void SetCurve(vtkPolyData* curve, const std::vector<Eigen::Vector3d>& positions);

/// Replaces the content of `lines` by separate lines between pairs of the positions.
void SetLines(vtkPolyData* lines, const std::vector<Eigen::Vector3d>& positions,
  const std::vector<std::pair<int, int>>& ends);

/// Replaces the content of `marks` by one vertex at each position.
void SetMarks(vtkPolyData* marks, const std::vector<Eigen::Vector3d>& positions);

} // namespace pqShapeDisplay
