#include "vtkShapeCloud.h"

#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

bool vtkShapeCloud::IsPointCloud(vtkPolyData* data)
{
  return data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0 &&
    (data->GetNumberOfLines() == 0 || data->GetNumberOfVerts() > 0);
}

shape::SampledSurface vtkShapeCloud::Connect(vtkPolyData* data, const shape::Progress& progress)
{
  return shape::ConnectSamples(vtkShapeConvert::ToPoints(data),
    HasNormals(data) ? vtkShapeCarry::GetTuples(vtkShapeCarry::GetNormals(data->GetPointData()))
                     : Eigen::MatrixXd(0, 3),
    {}, progress);
}

bool vtkShapeCloud::HasNormals(vtkPolyData* data)
{
  return vtkShapeCarry::GetNormals(data->GetPointData()) != nullptr;
}

std::vector<int> vtkShapeCloud::FindLoop(vtkPolyData* data)
{
  for (std::vector<int> line : vtkShapeConvert::ToLines(data))
  {
    if (line.size() > 3 && line.front() == line.back())
    {
      line.pop_back();
      return line;
    }
  }
  return {};
}

Eigen::VectorXi vtkShapeCloud::FindVertices(vtkPolyData* data)
{
  Eigen::VectorXi vertices =
    Eigen::VectorXi::Constant(static_cast<Eigen::Index>(data->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfVerts(); ++cell)
  {
    data->GetVerts()->GetCellAtId(cell, corners);
    for (const vtkIdType point : *corners)
    {
      vertices(point) = vertices(point) < 0 ? static_cast<int>(cell) : vertices(point);
    }
  }
  return vertices;
}

void vtkShapeCloud::WriteCells(const std::vector<int>& loop, vtkPolyData* output)
{
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    vertices->InsertNextCell(1, &point);
  }
  output->SetVerts(vertices);
  if (!loop.empty())
  {
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
    for (const int point : loop)
    {
      lines->InsertCellPoint(point);
    }
    lines->InsertCellPoint(loop.front());
    output->SetLines(lines);
  }
}
