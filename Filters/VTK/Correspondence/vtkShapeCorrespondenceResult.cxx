#include "vtkShapeCorrespondenceResult.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{

/// A polyline of the base domain's output.
struct BaseLine
{
  Eigen::MatrixXd OnA, OnB;
  int Left, Right, IsCurve, Loop;
};

/// The paths of the base domain, and the loops around handles.
std::vector<BaseLine> BaseLines(
  const shape::CorrespondenceResult& result, const shape::Mesh& a, const shape::Mesh& b)
{
  std::vector<BaseLine> lines;
  for (const shape::BasePath& path : result.Base->Paths)
  {
    lines.push_back({ path.OnA, path.OnB, path.Left, path.Right, path.IsCurve ? 1 : 0, 0 });
  }
  const Eigen::MatrixXd images = shape::PullBack(result.Maps.AToB, b.Triangles, b.Points);
  const std::vector<shape::HandleLoop> loops =
    result.Handles ? result.Handles->LoopsOfA : std::vector<shape::HandleLoop>();
  for (const shape::HandleLoop& loop : loops)
  {
    lines.push_back({ a.Points(loop.Points, Eigen::all), images(loop.Points, Eigen::all), -1, -1, 0,
      loop.IsTunnel ? 2 : 1 });
  }
  return lines;
}

} // namespace

vtkSmartPointer<vtkIdTypeArray> vtkShapeCorrespondenceResult::ToIds(
  const Eigen::VectorXi& values, const std::string& name)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name.c_str());
  ids->SetNumberOfTuples(values.size());
  std::copy(values.begin(), values.end(), ids->GetPointer(0));
  return ids;
}

void vtkShapeCorrespondenceResult::WriteCandidates(const shape::BlendedIntrinsicResult& blended,
  const Eigen::MatrixXi& ofA, const Eigen::MatrixXi& ofB, vtkTable* table)
{
  const std::vector<std::string> places = { "First", "Second", "Third" };
  for (const auto& [points, side] : { std::pair(&ofA, "OfA"), std::pair(&ofB, "OfB") })
  {
    for (int k = 0; k < 3; ++k)
    {
      table->AddColumn(ToIds(points->col(k), places[k] + side));
    }
  }
  table->AddColumn(vtkShapeConvert::ToArray(blended.Weights, "Weight"));
  for (Eigen::Index j = 0; j < blended.Consistency.cols(); ++j)
  {
    table->AddColumn(vtkShapeConvert::ToArray(blended.Consistency.col(j), std::to_string(j)));
  }
}

void vtkShapeCorrespondenceResult::WriteBase(const shape::CorrespondenceResult& result,
  const shape::Mesh& a, const shape::Mesh& b, vtkPolyData* output)
{
  const std::vector<BaseLine> base = BaseLines(result, a, b);
  Eigen::Index count = 0;
  for (const BaseLine& line : base)
  {
    count += line.OnA.rows();
  }
  Eigen::MatrixXd onA(count, 3), onB(count, 3);
  Eigen::VectorXi left(base.size()), right(base.size()), isCurve(base.size()), loop(base.size());
  vtkNew<vtkCellArray> lines;
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < base.size(); ++i)
  {
    const Eigen::Index size = base[i].OnA.rows();
    onA.middleRows(first, size) = base[i].OnA;
    onB.middleRows(first, size) = base[i].OnB;
    lines->InsertNextCell(static_cast<int>(size));
    for (Eigen::Index k = 0; k < size; ++k)
    {
      lines->InsertCellPoint(first + k);
    }
    const auto row = static_cast<Eigen::Index>(i);
    left(row) = base[i].Left;
    right(row) = base[i].Right;
    isCurve(row) = base[i].IsCurve;
    loop(row) = base[i].Loop;
    first += size;
  }
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(onA, "Points"));
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(vtkShapeConvert::ToArray(onB, "TargetPosition"));
  output->GetCellData()->AddArray(ToIds(left, "LeftPatch"));
  output->GetCellData()->AddArray(ToIds(right, "RightPatch"));
  output->GetCellData()->AddArray(ToIds(isCurve, "IsCurve"));
  output->GetCellData()->AddArray(ToIds(loop, "HandleLoop"));
}
