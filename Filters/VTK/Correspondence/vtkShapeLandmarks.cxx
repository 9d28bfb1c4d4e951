#include "vtkShapeLandmarks.h"

#include "vtkShapeConvert.h"
#include "vtkShapePositions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cstddef>

vtkStandardNewMacro(vtkShapeLandmarks);

namespace
{

enum LandmarkPort
{
  OnA,
  OnB,
  Between
};

/// Replaces the points of `output`, and makes a cell of each `size` points in order.
void FillLandmarks(vtkPolyData* output, const Eigen::MatrixXd& positions, int size)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    if (i % size == 0)
    {
      cells->InsertNextCell(size);
    }
    const Eigen::Vector3d position = positions.row(i);
    cells->InsertCellPoint(points->InsertNextPoint(position.data()));
  }
  output->SetPoints(points);
  (size == 1) ? output->SetVerts(cells) : output->SetLines(cells);
}

} // namespace

vtkShapeLandmarks::vtkShapeLandmarks()
{
  this->DeclareInput("SurfaceA", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("SurfaceB", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
}

void vtkShapeLandmarks::SetNumberOfPointsA(int count)
{
  if (vtkShapePositions::Resize(this->PointsA, count))
  {
    this->Modified();
  }
}

void vtkShapeLandmarks::SetPointsA(int index, double x, double y, double z)
{
  if (vtkShapePositions::Set(this->PointsA, index, x, y, z))
  {
    this->Modified();
  }
}

void vtkShapeLandmarks::SetPointsA(const std::vector<double>& values)
{
  this->PointsA = values;
  this->Modified();
}

void vtkShapeLandmarks::SetNumberOfPointsB(int count)
{
  if (vtkShapePositions::Resize(this->PointsB, count))
  {
    this->Modified();
  }
}

void vtkShapeLandmarks::SetPointsB(int index, double x, double y, double z)
{
  if (vtkShapePositions::Set(this->PointsB, index, x, y, z))
  {
    this->Modified();
  }
}

void vtkShapeLandmarks::SetPointsB(const std::vector<double>& values)
{
  this->PointsB = values;
  this->Modified();
}

void vtkShapeLandmarks::SetNumberOfNames(int count)
{
  this->Names.resize(static_cast<std::size_t>(std::max(count, 0)));
  this->Modified();
}

void vtkShapeLandmarks::SetNames(int index, const std::string& name)
{
  if (index >= 0)
  {
    const auto i = static_cast<std::size_t>(index);
    this->Names.resize(std::max(this->Names.size(), i + 1));
    this->Names[i] = name;
    this->Modified();
  }
}

void vtkShapeLandmarks::Label(vtkDataSetAttributes* attributes) const
{
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (std::size_t i = 0; i < this->PointsA.size() / 3; ++i)
  {
    const bool isNamed = i < this->Names.size() && !this->Names[i].empty();
    names->InsertNextValue(isNamed ? this->Names[i] : std::to_string(i + 1));
    numbers->InsertNextValue(static_cast<int>(i) + 1);
  }
  attributes->AddArray(names);
  attributes->AddArray(numbers);
}

Eigen::MatrixXd vtkShapeLandmarks::Project(int port, const shape::Progress& progress)
{
  const std::string side = port == OnA ? "A" : "B";
  const std::string name = "Surface " + side;
  const shape::LandmarksResult result = shape::ProjectLandmarks(
    shape::Surface(vtkShapeConvert::ToMesh(this->GetGatheredInput(port).Data, name)),
    vtkShapePositions::ToRows(port == OnA ? this->PointsA : this->PointsB), name, this->Options,
    progress);
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(port));
  FillLandmarks(output, result.Positions, 1);
  this->Label(output->GetPointData());
  vtkShapeConvert::AddFact(
    this->GetOutputDataObject(OnA), "Landmarks.LargestDistanceFrom" + side, result.LargestDistance);
  return result.Positions;
}

void vtkShapeLandmarks::Execute(const shape::Progress& progress)
{
  // Every process has the complete surfaces, and one of them has the landmarks.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  const std::size_t countA = this->PointsA.size() / 3, countB = this->PointsB.size() / 3;
  const bool isPaired = this->GetNumberOfInputConnections(OnB) > 0;
  if (!isPaired && countB > 0)
  {
    throw shape::InvalidInput("Points B has " + std::to_string(countB) +
      " positions, and there is no Surface B; connect it, or remove them");
  }
  if (isPaired && countA != countB)
  {
    throw shape::InvalidInput("Points A has " + std::to_string(countA) +
      " positions, and Points B has " + std::to_string(countB) +
      "; give equally many, because they are paired by order");
  }
  const Eigen::MatrixXd a =
    this->Project(OnA, progress.Part(0.0, isPaired ? 0.5 : 1.0, "projecting the landmarks"));
  if (!isPaired)
  {
    return;
  }
  const Eigen::MatrixXd b = this->Project(OnB, progress.Part(0.5, 1.0, "projecting the landmarks"));
  const auto addTargets = [this](int port, const Eigen::MatrixXd& targets)
  {
    vtkPolyData::SafeDownCast(this->GetOutputDataObject(port))
      ->GetPointData()
      ->AddArray(vtkShapeConvert::ToArray(targets, "TargetPosition"));
  };
  addTargets(OnA, b);
  addTargets(OnB, a);
  Eigen::MatrixXd ends(2 * a.rows(), 3);
  for (Eigen::Index i = 0; i < a.rows(); ++i)
  {
    ends.row(2 * i) = a.row(i);
    ends.row(2 * i + 1) = b.row(i);
  }
  auto* lines = vtkPolyData::SafeDownCast(this->GetOutputDataObject(Between));
  FillLandmarks(lines, ends, 2);
  this->Label(lines->GetCellData());
}
