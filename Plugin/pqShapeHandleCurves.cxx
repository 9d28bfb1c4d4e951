#include "pqShapeHandleCurves.h"

#include "pqShapeDisplay.h"
#include "pqShapeFetch.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMSourceProxy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace
{

/// A sample closer to the axis of its part than this share of the radius has no clear direction.
constexpr double ClearDirection = 0.1;

vtkSmartPointer<vtkPolyData> FetchPolyData(vtkSMSourceProxy* filter, int port, double time)
{
  if (filter->GetDataInformation(static_cast<unsigned int>(port))->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  // With the built-in server, the output is in this process.
  auto* algorithm = vtkAlgorithm::SafeDownCast(filter->GetClientSideObject());
  return vtkPolyData::SafeDownCast(algorithm ? algorithm->GetOutputDataObject(port)
                                             : pqShapeFetch::Fetch(filter, port, time).Get());
}

} // namespace

void pqShapeHandleCurves::Fetch(vtkSMSourceProxy* filter, int port, double time)
{
  this->Samples.clear();
  this->Segments.clear();
  this->Parts.clear();
  const vtkSmartPointer<vtkPolyData> data = FetchPolyData(filter, port, time);
  const auto get = [&](const char* name)
  { return data ? data->GetPointData()->GetArray(name) : nullptr; };
  vtkDataArray* normals = get("TargetNormal");
  vtkDataArray* rest = get("SourcePosition");
  vtkDataArray* turns = get("FrameTurn");
  vtkDataArray* parts = get("Part");
  if (!normals || !rest || !turns || !parts)
  {
    return;
  }
  int count = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Sample sample;
    data->GetPoint(i, sample.Position.data());
    normals->GetTuple(i, sample.Normal.data());
    rest->GetTuple(i, sample.Rest.data());
    turns->GetTuple(i, sample.Turn.data());
    sample.Part = static_cast<int>(parts->GetComponent(i, 0));
    count = std::max(count, sample.Part + 1);
    this->Samples.push_back(sample);
  }
  vtkNew<vtkIdList> ends;
  vtkCellArray* lines = data->GetLines();
  for (lines->InitTraversal(); lines->GetNextCell(ends);)
  {
    this->Segments.emplace_back(static_cast<int>(ends->GetId(0)), static_cast<int>(ends->GetId(1)));
  }
  for (int part = 0; part < count; ++part)
  {
    this->Parts.push_back(this->MakePart(part));
  }
}

/// The centre is defined as in shape::ComputePartCentre.
pqShapeHandleCurves::Part pqShapeHandleCurves::MakePart(int number) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), mean = sum, area = sum, normal = sum;
  double length = 0.0, count = 0.0;
  for (const auto& [a, b] : this->Segments)
  {
    const Eigen::Vector3d &from = this->Samples[a].Position, &to = this->Samples[b].Position;
    const double own = this->Samples[a].Part == number ? (to - from).norm() : 0.0;
    sum += own * 0.5 * (from + to);
    length += own;
  }
  for (const Sample& sample : this->Samples)
  {
    if (sample.Part == number)
    {
      mean += sample.Position;
      normal += sample.Normal;
      count += 1.0;
    }
  }
  Part part;
  part.Centre = length > 0.0 ? Eigen::Vector3d(sum / length) : Eigen::Vector3d(mean / count);
  for (const auto& [a, b] : this->Segments)
  {
    if (this->Samples[a].Part == number)
    {
      area +=
        (this->Samples[a].Position - part.Centre).cross(this->Samples[b].Position - part.Centre);
    }
  }
  // A surface lies to the left of its boundary, so that this normal points away from it. A curve
  // that encloses no area has the mean normal of the shape.
  normal = area.norm() > 1e-6 * length * length ? Eigen::Vector3d(-area) : normal;
  normal = normal.norm() > 0.0 ? normal.normalized() : Eigen::Vector3d::UnitZ();
  part.Radius = 0.0;
  for (const Sample& sample : this->Samples)
  {
    part.Radius += sample.Part == number ? (sample.Position - part.Centre).norm() / count : 0.0;
  }
  Eigen::Vector3d first = normal.unitOrthogonal();
  for (const Sample& sample : this->Samples)
  {
    Eigen::Vector3d way = sample.Position - part.Centre;
    way -= way.dot(normal) * normal;
    if (sample.Part == number && way.norm() > ClearDirection * part.Radius)
    {
      first = way.normalized();
      break;
    }
  }
  part.Axes << first, normal.cross(first), normal;
  return part;
}

int pqShapeHandleCurves::FindAtRest(const Eigen::Vector3d& position) const
{
  const auto closest = std::min_element(this->Samples.begin(), this->Samples.end(),
    [&](const Sample& a, const Sample& b)
    { return (a.Rest - position).squaredNorm() < (b.Rest - position).squaredNorm(); });
  return static_cast<int>(closest - this->Samples.begin());
}

int pqShapeHandleCurves::FindUnder(
  vtkRenderer* renderer, const Eigen::Vector2d& pixel, double reach) const
{
  const double scale = pqShapeDisplay::PixelScale(renderer);
  const pqShapeDisplay::Ray ray = pqShapeDisplay::ToRay(renderer, pixel);
  int found = -1;
  double nearest = reach, depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const Eigen::Vector3d& position = this->Samples[i].Position;
    const double distance = (pqShapeDisplay::ToPixel(renderer, position) - pixel).norm() / scale;
    const double along = ray.Direction.dot(position - ray.Near);
    // Half a pixel decides nothing.
    if (distance < nearest - 0.5 ||
      (distance < nearest + 0.5 && distance <= reach && along < depth))
    {
      found = static_cast<int>(i);
      nearest = std::min(nearest, distance);
      depth = along;
    }
  }
  return found;
}
