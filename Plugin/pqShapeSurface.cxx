#include "pqShapeSurface.h"

#include "pqShapeFetch.h"

#include "vtkAppendPolyData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkStaticCellLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

/// Returns the surface, or the surfaces of all blocks as one.
vtkSmartPointer<vtkPolyData> ToSurface(vtkDataObject* data)
{
  vtkNew<vtkAppendPolyData> append;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> block;
    block.TakeReference(blocks->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      if (auto* surface = vtkPolyData::SafeDownCast(block->GetCurrentDataObject()))
      {
        append->AddInputData(surface);
      }
    }
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    append->AddInputData(surface);
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(append->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff(); // the filters keep the orientation of the triangles, too
  normals->Update();
  vtkPolyData* surface = normals->GetOutput();
  return surface->GetNumberOfPolys() > 0 ? surface : nullptr;
}

} // namespace

pqShapeSurface::pqShapeSurface(vtkSMProperty* input, const std::function<void()>& outdated)
  : Input(input)
  , Outdated(outdated)
{
}

pqShapeSurface::~pqShapeSurface()
{
  this->Observe(nullptr, 0);
}

void pqShapeSurface::Observe(vtkSMSourceProxy* source, int port)
{
  if (this->Source)
  {
    this->Source->RemoveObserver(this->Observer);
  }
  this->Source = source;
  this->Port = port;
  this->Fresh = false;
  if (source)
  {
    this->Observer =
      source->AddObserver(vtkCommand::UpdateDataEvent, this, &pqShapeSurface::Forget);
  }
}

void pqShapeSurface::Forget()
{
  this->Fresh = false;
  this->Outdated();
}

bool pqShapeSurface::Update(double time)
{
  if (!this->Input)
  {
    return false;
  }
  // Before the first Apply, the input may only be chosen in the panel.
  vtkSMPropertyHelper helper(this->Input);
  helper.SetUseUnchecked(!helper.GetAsProxy());
  auto* source = vtkSMSourceProxy::SafeDownCast(helper.GetAsProxy());
  const int port = static_cast<int>(helper.GetOutputPort());
  if (source != this->Source || port != this->Port)
  {
    this->Observe(source, port);
  }
  // Data from the cache of an animation return without an event of their source.
  if (!this->Fresh || time != this->Time)
  {
    this->Data = nullptr;
    if (source)
    {
      this->Fetch(time);
    }
    this->Fresh = true;
    this->Time = time;
    ++this->Version;
  }
  return this->IsThere();
}

void pqShapeSurface::Fetch(double time)
{
  const vtkSmartPointer<vtkSMSourceProxy> bare =
    pqShapeFetch::NewFilter("PassArrays", this->Source, this->Port);
  bare->UpdateVTKObjects();
  bare->UpdatePipeline(time);
  this->Data = ToSurface(pqShapeFetch::Fetch(bare, 0, time));
  if (this->Data)
  {
    this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    this->Locator->SetDataSet(this->Data);
    this->Locator->BuildLocator();
  }
}

bool pqShapeSurface::FindUnder(
  vtkRenderer* renderer, const Eigen::Vector2d& pixel, pqShapePlace& place) const
{
  return this->FindAlong(pqShapeDisplay::ToRay(renderer, pixel), place);
}

bool pqShapeSurface::FindAlong(const pqShapeDisplay::Ray& ray, pqShapePlace& place) const
{
  const double middle = ray.Direction.dot(this->GetCentre() - ray.Near);
  const double first = std::max(ray.First, middle - this->GetSize());
  const double last = middle + this->GetSize();
  if (first >= last)
  {
    return false; // the surface is behind the viewer
  }
  const Eigen::Vector3d from = ray.Near + first * ray.Direction;
  const Eigen::Vector3d to = ray.Near + last * ray.Direction;
  vtkNew<vtkGenericCell> cell;
  Eigen::Vector3d position;
  double parameters[3];
  double along = 0.0;
  int part = 0;
  vtkIdType id = -1;
  // Without a tolerance, a line through an edge can pass between its triangles.
  const double tolerance = 1e-9 * this->GetSize();
  if (!this->Locator->IntersectWithLine(
        from.data(), to.data(), tolerance, along, position.data(), parameters, part, id, cell))
  {
    return false;
  }
  place = this->MakeSurfacePoint(id, position);
  return true;
}

pqShapePlace pqShapeSurface::FindClosest(const Eigen::Vector3d& point) const
{
  vtkNew<vtkGenericCell> cell;
  Eigen::Vector3d closest;
  vtkIdType id = -1;
  int part = 0;
  double squared = 0.0;
  this->Locator->FindClosestPoint(point.data(), closest.data(), cell, id, part, squared);
  if (id < 0)
  {
    id = 0; // the position is not finite: use the first point of the surface
    this->Data->GetCell(id, cell);
    cell->GetPoints()->GetPoint(0, closest.data());
  }
  return this->MakeSurfacePoint(id, closest);
}

Eigen::Vector3d pqShapeSurface::GetCentre() const
{
  return Eigen::Vector3d(this->Data->GetCenter());
}

double pqShapeSurface::GetSize() const
{
  return 0.5 * this->Data->GetLength();
}

pqShapePlace pqShapeSurface::MakeSurfacePoint(vtkIdType cell, const Eigen::Vector3d& position) const
{
  pqShapePlace place;
  place.Position = position;
  vtkNew<vtkGenericCell> polygon;
  this->Data->GetCell(cell, polygon);
  Eigen::Vector3d closest;
  double parameters[3];
  double squared = 0.0;
  int part = 0;
  std::vector<double> weights(static_cast<std::size_t>(polygon->GetNumberOfPoints()));
  polygon->EvaluatePosition(
    position.data(), closest.data(), part, parameters, squared, weights.data());
  vtkDataArray* normals = this->Data->GetPointData()->GetNormals();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (vtkIdType i = 0; i < polygon->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d corner;
    normals->GetTuple(polygon->GetPointId(i), corner.data());
    normal += weights[static_cast<std::size_t>(i)] * corner;
  }
  if (normal.norm() > 1e-6)
  {
    place.Normal = normal.normalized();
  }
  return place;
}
