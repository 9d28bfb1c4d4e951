#include "vtkShapeRepair.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "Geometry/SheetRepair.h"

#include <utility>

namespace
{

std::string Count(int count, const char* one, const char* several)
{
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

std::string Describe(const shape::RepairedSheets& repaired, const std::string& name)
{
  std::vector<std::string> parts;
  if (repaired.NonManifoldEdges > 0)
  {
    parts.push_back(Count(repaired.NonManifoldEdges, "edge", "edges") +
      " with three or more triangles (first at point " + std::to_string(repaired.FirstNonManifold) +
      ")");
  }
  if (repaired.SplitPoints > 0)
  {
    parts.push_back(Count(repaired.SplitPoints, "copy of a point", "copies of points") +
      " added (first of " + std::to_string(repaired.FirstSplit) + ")");
  }
  if (repaired.RemovedTriangles() > 0)
  {
    parts.push_back(Count(repaired.RemovedTriangles(), "triangle", "triangles") +
      " left out (first " + std::to_string(repaired.FirstRemoved) + ")");
  }
  std::string all;
  for (const std::string& part : parts)
  {
    all += (all.empty() ? "" : ", ") + part;
  }
  if (!repaired.IsChanged())
  {
    return name + " has " + all +
      ": sheets are connected there as by a covering surface; Shape Solidify repairs the data";
  }
  return name + " was repaired to compute: " + all + "; Shape Solidify or Clean repairs the data";
}

/// Builds the repaired surface with the arrays of the given one. cellOf: see
/// vtkShapeTriangulation::CellOf.
vtkShapeRepaired Build(
  vtkPolyData* data, shape::RepairedSheets repaired, const std::vector<int>& cellOf)
{
  vtkShapeRepaired result;
  result.Data = vtkSmartPointer<vtkPolyData>::New();
  vtkShapeConvert::FromMesh(repaired.Surface, result.Data);
  result.Data->SetVerts(data->GetVerts());
  result.Data->SetLines(data->GetLines());
  result.Data->GetFieldData()->ShallowCopy(data->GetFieldData());

  const auto points = static_cast<vtkIdType>(repaired.Points.size());
  vtkPointData* ofPoints = result.Data->GetPointData();
  ofPoints->CopyAllocate(data->GetPointData(), points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    ofPoints->CopyData(data->GetPointData(), repaired.Points[i], i);
  }
  // The order of vtkPolyData's cell ids: vertices, lines, polygons.
  const auto before = static_cast<int>(data->GetNumberOfVerts() + data->GetNumberOfLines());
  for (int cell = 0; cell < before; ++cell)
  {
    result.Cells.push_back(cell);
  }
  for (const int triangle : repaired.Triangles)
  {
    result.Cells.push_back(before + cellOf[triangle]);
  }
  vtkCellData* ofCells = result.Data->GetCellData();
  ofCells->CopyAllocate(data->GetCellData(), static_cast<vtkIdType>(result.Cells.size()));
  for (std::size_t cell = 0; cell < result.Cells.size(); ++cell)
  {
    ofCells->CopyData(data->GetCellData(), result.Cells[cell], static_cast<vtkIdType>(cell));
  }
  result.Points = std::move(repaired.Points);
  result.Triangles = std::move(repaired.Triangles);
  result.Representatives = std::move(repaired.Representatives);
  return result;
}

} // namespace

Eigen::VectorXi vtkShapeRepaired::ToGiven(
  const std::vector<int>& list, const Eigen::VectorXi& indices)
{
  return list.empty() ? indices
                      : Eigen::VectorXi(indices.unaryExpr(
                          [&](int index) { return index < 0 ? index : list[index]; }));
}

vtkShapeRepaired vtkShapeRepair::Apply(vtkPolyData* data, const std::string& name, bool separate)
{
  vtkShapeRepaired result;
  result.Data = data;
  if (!data->GetPoints() || data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    return result;
  }
  if (separate && data->GetCellData()->HasArray("Regions"))
  {
    return result; // interfaces meet at edges with three or more triangles
  }
  const std::array<vtkMTimeType, 3> times = { data->GetPoints()->GetMTime(),
    data->GetPolys()->GetMTime(), data->GetStrips()->GetMTime() };
  if (this->SoundPoints == data->GetPoints() && this->SoundPolys == data->GetPolys() &&
    this->SoundStrips == data->GetStrips() && this->Times == times && this->IsSeparated == separate)
  {
    return result;
  }
  std::vector<int> cellOf;
  const shape::Mesh mesh = vtkShapeConvert::ToMesh(data, name, &cellOf);
  if (!mesh.Points.allFinite())
  {
    return result;
  }
  shape::RepairedSheets repaired = shape::RepairSheets(mesh, { separate });
  if (repaired.Triangles.empty())
  {
    return result; // nothing would be left: the kernel says why
  }
  if (!repaired.IsChanged() && repaired.SharedEdges == 0)
  {
    this->IsSeparated = separate;
    this->SoundPoints = data->GetPoints();
    this->SoundPolys = data->GetPolys();
    this->SoundStrips = data->GetStrips();
    this->Times = times;
    return result;
  }
  std::string description = Describe(repaired, name);
  const int split = repaired.SplitPoints, removed = repaired.RemovedTriangles();
  if (repaired.IsChanged())
  {
    result = Build(data, std::move(repaired), cellOf);
  }
  result.SplitPoints = split;
  result.RemovedTriangles = removed;
  result.Description = std::move(description);
  return result;
}
