#include "Search/Private/CellInterpolation.h"

#include "Search/ClosestPoint.h"

#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace shape
{

namespace
{

/// The corners of a cell, one a row.
Eigen::MatrixXd CornersOf(const Cells& cells, int number)
{
  const int first = cells.Offsets(number), count = cells.Offsets(number + 1) - first;
  return cells.Points(cells.Corners.segment(first, count), Eigen::all);
}

/// VTK ends Newton's method a thousandth of a cell from the position: takes two more steps.
void Refine(const Eigen::MatrixXd& corners, const Eigen::RowVector3d& position,
  vtkGenericCell* cell, Eigen::RowVector3d parametric, Eigen::VectorXd& weights)
{
  for (int step = 0; step < 2; ++step)
  {
    // A Newton step for the parametric coordinates of the position.
    const Eigen::RowVector3d rest = position - weights.transpose() * corners;
    Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(corners.rows(), 3);
    cell->InterpolateDerivs(parametric.data(), derivatives.data());
    const Eigen::Matrix3d jacobian = derivatives.transpose() * corners;
    if (jacobian.determinant() == 0.0)
    {
      return;
    }
    const Eigen::RowVector3d next = parametric + rest * jacobian.inverse();
    Eigen::VectorXd refined = Eigen::VectorXd::Zero(corners.rows());
    cell->InterpolateFunctions(next.data(), refined.data());
    if (!((position - refined.transpose() * corners).norm() < rest.norm()))
    {
      return;
    }
    parametric = next;
    weights = refined;
  }
}

} // namespace

void LoadCell(const Cells& cells, int number, vtkGenericCell* cell)
{
  cell->SetCellType(cells.Kinds(number));
  const int first = cells.Offsets(number), count = cells.Offsets(number + 1) - first;
  cell->GetPointIds()->SetNumberOfIds(count);
  cell->GetPoints()->SetDataTypeToDouble();
  cell->GetPoints()->SetNumberOfPoints(count);
  for (int k = 0; k < count; ++k)
  {
    const int point = cells.Corners(first + k);
    const Eigen::RowVector3d position = cells.Points.row(point);
    cell->GetPointIds()->SetId(k, point);
    cell->GetPoints()->SetPoint(k, position.data());
  }
  if (cell->RequiresInitialization())
  {
    cell->Initialize();
  }
}

Eigen::VectorXd ComputeCellWeights(
  const Cells& cells, int number, const Eigen::RowVector3d& position, vtkGenericCell* cell)
{
  LoadCell(cells, number, cell);
  const Eigen::MatrixXd corners = CornersOf(cells, number);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(corners.rows());
  Eigen::RowVector3d closest, parametric;
  int subId = 0;
  double distance2 = 0.0;
  const int state = cell->EvaluatePosition(
    position.data(), closest.data(), subId, parametric.data(), distance2, weights.data());
  if (state < 0)
  {
    return {};
  }
  if (weights.isZero(0.0)) // a voxel that does not contain the position, perhaps by rounding
  {
    cell->InterpolateFunctions(parametric.data(), weights.data());
  }
  Refine(corners, position, cell, parametric, weights);
  // VTK treats positions beyond the slanted face of a wedge as inside and, by rounding, positions
  // on a face as outside. The weights decide once they are known to reproduce the position.
  const double size = (corners.colwise().maxCoeff() - corners.colwise().minCoeff()).norm();
  const bool isPosition = std::abs(weights.sum() - 1.0) <= CellRounding &&
    (position - weights.transpose() * corners).norm() <= 100.0 * CellRounding * size;
  const bool isInside = cell->IsLinear() ? weights.minCoeff() >= -CellRounding : state == 1;
  return isPosition && isInside ? weights : Eigen::VectorXd();
}

PointOnEdges FindClosestPointOnEdges(
  const Cells& cells, int number, const Eigen::RowVector3d& position, vtkGenericCell* cell)
{
  LoadCell(cells, number, cell);
  PointOnEdges best{ std::numeric_limits<double>::infinity(), {}, {} };
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  for (int side = 0; side < cell->GetNumberOfFaces(); ++side)
  {
    cell->GetFace(side)->Triangulate(0, ids, points);
    for (vtkIdType first = 0; first + 2 < ids->GetNumberOfIds(); first += 3)
    {
      Eigen::RowVector3i triangle;
      for (int k = 0; k < 3; ++k)
      {
        triangle(k) = static_cast<int>(ids->GetId(first + k));
      }
      const Eigen::Matrix3d corners = cells.Points(triangle, Eigen::all);
      const Eigen::RowVector3d barycentrics = FindClosestPointInTriangle(corners, position);
      const double distance2 = (barycentrics * corners - position).squaredNorm();
      if (distance2 < best.Distance2)
      {
        best = { distance2, triangle, barycentrics };
      }
    }
  }
  return best;
}

} // namespace shape
