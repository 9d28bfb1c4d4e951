#include "vtkShapeFromOperators.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkShapeFromOperators);

vtkShapeFromOperators::vtkShapeFromOperators()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Operators", PortData::Table, PortUse::Required, { "vtkTable" });
  this->DeclareMovedOutput();
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareMeasures({ "Area", "SideLengths", "Angles", "NormalCurvatures" });
  this->DeclareMemoryRemedy("use operators of fewer eigenpairs");
}

namespace
{

/// Returns the columns name0, name1, ... as a matrix; of the first process, on all processes.
Eigen::MatrixXd ReadOperator(
  vtkTable* table, const std::string& name, vtkMultiProcessController* controller)
{
  Eigen::MatrixXd matrix;
  for (Eigen::Index column = 0;; ++column)
  {
    auto* values = vtkDataArray::SafeDownCast(
      table ? table->GetColumnByName((name + std::to_string(column)).c_str()) : nullptr);
    if (!values)
    {
      break;
    }
    matrix.conservativeResize(values->GetNumberOfTuples(), column + 1);
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    {
      matrix(row, column) = values->GetComponent(row, 0);
    }
  }
  vtkShapeGather::Share(controller, matrix);
  return matrix;
}

/// Returns the angles of triangles (m x 3, in degrees) with given sides (m x 3), opposite each
/// corner; 0 where there is no such triangle.
Eigen::MatrixXd ComputeAngles(const Eigen::MatrixXd& sides)
{
  Eigen::MatrixXd angles = Eigen::MatrixXd::Zero(sides.rows(), 3);
  for (Eigen::Index t = 0; t < sides.rows(); ++t)
  {
    if (2.0 * sides.row(t).maxCoeff() >= sides.row(t).sum())
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      const double a = sides(t, k), b = sides(t, (k + 1) % 3), c = sides(t, (k + 2) % 3);
      const double cosine = (b * b + c * c - a * a) / (2.0 * b * c);
      angles(t, k) = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / M_PI;
    }
  }
  return angles;
}

} // namespace

// 1. Read the operators, which only the first process may have.
// 2. Recover the surface.
void vtkShapeFromOperators::Execute(const shape::Progress& progress)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  vtkMultiProcessController* controller = this->GetController();
  auto* table = vtkTable::SafeDownCast(this->GetInputDataObject(1, 0));
  const auto read = [&](const std::string& name) { return ReadOperator(table, name, controller); };
  shape::SurfaceOperators operators{ read("Area"), read("Conformal"), read("OffsetArea"),
    read("OffsetConformal") };
  Eigen::MatrixXd distance = Eigen::MatrixXd::Zero(1, 1);
  if (table)
  {
    if (auto* given = table->GetFieldData()->GetArray("MapDifference.OffsetDistance"))
    {
      distance(0) = given->GetComponent(0, 0);
    }
  }
  vtkShapeGather::Share(controller, distance);
  operators.OffsetDistance = distance(0);
  if (operators.Area.size() == 0 || operators.Conformal.size() == 0)
  {
    throw shape::InvalidInput("the Operators have no columns Area0 and Conformal0; connect the "
                              "output Operators of Shape Map Difference");
  }

  const shape::Surface first = vtkShapeConvert::ToMesh(whole.Data, "the Input");
  if (operators.OffsetArea.size() > 0 && operators.OffsetDistance == 0.0)
  {
    throw shape::InvalidInput("the Operators have the column OffsetArea0, but no field data "
                              "MapDifference.OffsetDistance; add it, or leave these columns out");
  }
  const shape::RecoveredSurface result =
    shape::RecoverFromOperators(first, operators, this->Options, progress);

  const Eigen::MatrixXd own = vtkShapeConvert::Rows(result.Embedded.Points, whole.OwnPoints);
  vtkDataObject* output = this->GetOutputDataObject(0);
  Eigen::Index at = 0;
  vtkShapeComposite::ForEach(this->GetInputDataObject(0, 0), output,
    vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const Eigen::MatrixXd positions = vtkShapeConvert::ToPoints(from);
      vtkShapeComposite::Move(from, own.middleRows(at, positions.rows()), to);
      at += positions.rows();
      to->GetPointData()->AddArray(vtkShapeConvert::ToArray(positions, "SourcePosition"));
    });
  vtkShapeConvert::AddFact(output, "FromOperators.BrokenTriangles", result.Metric.BrokenTriangles);
  vtkShapeConvert::AddFact(output, "FromOperators.LengthError", result.Embedded.LengthError);
  // Every process has the same metric: one of them outputs it.
  if (!controller || controller->GetLocalProcessId() == 0)
  {
    auto* triangles = vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
    vtkShapeConvert::FromMesh({ result.Embedded.Points, first.Triangles() }, triangles);
    vtkCellData* cells = triangles->GetCellData();
    cells->AddArray(vtkShapeConvert::ToArray(result.Metric.Areas, "Area"));
    cells->AddArray(vtkShapeConvert::ToArray(result.Metric.Sides, "SideLengths"));
    cells->AddArray(vtkShapeConvert::ToArray(ComputeAngles(result.Metric.Sides), "Angles"));
    if (result.Curvatures.size() > 0)
    {
      cells->AddArray(vtkShapeConvert::ToArray(result.Curvatures, "NormalCurvatures"));
    }
  }
}
