#include "vtkShapeSeams.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "Transfer/TextureSeams.h"

#include <numeric>

std::vector<int> vtkShapeSeams::Split(vtkPolyData* receiver, const std::string& array,
  const shape::Surface& giver, const Eigen::MatrixXd& texture, const Eigen::MatrixXd& positions,
  const shape::Progress& progress)
{
  std::vector<std::vector<int>> polygons;
  vtkNew<vtkIdList> corners;
  vtkCellArray* given = receiver->GetPolys();
  for (vtkIdType cell = 0; cell < given->GetNumberOfCells(); ++cell)
  {
    given->GetCellAtId(cell, corners);
    polygons.emplace_back(corners->begin(), corners->end());
  }
  if (polygons.empty())
  {
    return {};
  }
  const shape::SplitPolygons split = shape::SplitAtSeams(giver, texture, polygons, positions,
    vtkShapeConvert::ToPointArray(receiver, array, 2, "the Input"), progress);
  if (split.Copied.empty())
  {
    return {};
  }
  const vtkIdType before = receiver->GetNumberOfPoints();
  const auto after = before + static_cast<vtkIdType>(split.Copied.size());
  vtkNew<vtkIdList> from, to;
  for (vtkIdType point = 0; point < after; ++point)
  {
    from->InsertNextId(point < before ? point : split.Copied[point - before]);
    to->InsertNextId(point);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(receiver->GetPoints()->GetDataType());
  points->SetNumberOfPoints(after);
  points->InsertPoints(to, from, receiver->GetPoints());
  vtkNew<vtkPointData> data;
  data->CopyAllOn();
  data->CopyAllocate(receiver->GetPointData(), after);
  data->CopyData(receiver->GetPointData(), from, to);
  vtkNew<vtkCellArray> polys;
  for (const std::vector<int>& polygon : split.Polygons)
  {
    polys->InsertNextCell(static_cast<int>(polygon.size()));
    for (const int corner : polygon)
    {
      polys->InsertCellPoint(corner);
    }
  }
  receiver->SetPoints(points);
  receiver->SetPolys(polys);
  receiver->GetPointData()->ShallowCopy(data);
  vtkDataArray* coordinates = receiver->GetPointData()->GetArray(array.c_str());
  for (vtkIdType point = before; point < after; ++point)
  {
    for (int k = 0; k < 2; ++k)
    {
      coordinates->SetComponent(point, k, split.Texture(point, k));
    }
  }
  return split.Copied;
}
