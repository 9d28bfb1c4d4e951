#include "pqShapeDisplay.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace pqShapeDisplay
{

namespace
{

Eigen::Vector3d ToWorld(vtkRenderer* renderer, const Eigen::Vector3d& display)
{
  renderer->SetDisplayPoint(display.x(), display.y(), display.z());
  renderer->DisplayToWorld();
  Eigen::Vector4d world;
  renderer->GetWorldPoint(world.data());
  return world.head<3>() / world.w();
}

/// Makes an actor that is drawn in front of all others: half of a handle is below the surface.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyDataMapper* mapper)
{
  constexpr double front = -66000.0;
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, front);
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, front);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(front);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

Eigen::Vector3d ToDisplay(vtkRenderer* renderer, const Eigen::Vector3d& position)
{
  renderer->SetWorldPoint(position.x(), position.y(), position.z(), 1.0);
  renderer->WorldToDisplay();
  Eigen::Vector3d display;
  renderer->GetDisplayPoint(display.data());
  return display;
}

} // namespace

Ray ToRay(vtkRenderer* renderer, const Eigen::Vector2d& pixel)
{
  Ray ray;
  ray.Near = ToWorld(renderer, { pixel.x(), pixel.y(), 0.0 });
  ray.Direction = (ToWorld(renderer, { pixel.x(), pixel.y(), 1.0 }) - ray.Near).normalized();
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d viewer(camera->GetPosition());
  ray.First = camera->GetParallelProjection() ? -std::numeric_limits<double>::infinity()
                                              : ray.Direction.dot(viewer - ray.Near);
  return ray;
}

Eigen::Vector2d ToPixel(vtkRenderer* renderer, const Eigen::Vector3d& position)
{
  return ToDisplay(renderer, position).head<2>();
}

double PixelScale(vtkRenderer* renderer)
{
  constexpr double usual = 72.0; // the density for which Qt and VTK have a pixel ratio of 1
  return std::max(1.0, renderer->GetRenderWindow()->GetDPI() / usual);
}

double PixelLength(vtkRenderer* renderer, const Eigen::Vector3d& position)
{
  const Eigen::Vector3d display = ToDisplay(renderer, position);
  const Eigen::Vector3d beside = ToWorld(renderer, display + Eigen::Vector3d::UnitX());
  return PixelScale(renderer) * (beside - ToWorld(renderer, display)).norm();
}

bool FacesViewer(
  vtkRenderer* renderer, const Eigen::Vector3d& position, const Eigen::Vector3d& normal)
{
  return normal.dot(ToRay(renderer, ToPixel(renderer, position)).Direction) < 0.0;
}

vtkSmartPointer<vtkActor> MakeBall()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(24);
  source->SetPhiResolution(16);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkSmartPointer<vtkActor> ball = MakeActor(mapper);
  ball->GetProperty()->SetAmbient(0.3);
  return ball;
}

void PlaceBall(vtkActor* ball, const Eigen::Vector3d& centre, double radius)
{
  ball->SetPosition(centre.x(), centre.y(), centre.z());
  ball->SetScale(radius);
}

vtkSmartPointer<vtkActor> MakeCurve(vtkPolyData* curve)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(curve);
  vtkSmartPointer<vtkActor> actor = MakeActor(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->RenderPointsAsSpheresOn();
  return actor;
}

void SetWidth(vtkActor* curve, vtkRenderer* renderer, double width)
{
  const auto pixels = static_cast<float>(PixelScale(renderer) * width);
  curve->GetProperty()->SetLineWidth(pixels);
  curve->GetProperty()->SetPointSize(pixels);
}

void SetCurve(vtkPolyData* curve, const std::vector<Eigen::Vector3d>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(positions.size()));
  for (const Eigen::Vector3d& position : positions)
  {
    lines->InsertCellPoint(points->InsertNextPoint(position.data()));
  }
  curve->SetPoints(points);
  curve->SetLines(lines);
}

void SetLines(vtkPolyData* lines, const std::vector<Eigen::Vector3d>& positions,
  const std::vector<std::pair<int, int>>& ends)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& [from, to] : ends)
  {
    cells->InsertNextCell({ from, to });
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
}

void SetMarks(vtkPolyData* marks, const std::vector<Eigen::Vector3d>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const Eigen::Vector3d& position : positions)
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(points->InsertNextPoint(position.data()));
  }
  marks->SetPoints(points);
  marks->SetVerts(vertices);
}

} // namespace pqShapeDisplay
