#include "vtkShapeGivenLandmarks.h"

#include "vtkShapeConvert.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/LandmarkPairs.h"
#include "Mesh/Extent.h"

#include "vtkCell.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace
{

Eigen::MatrixXd AsRows(const std::vector<Eigen::RowVector3d>& positions)
{
  Eigen::MatrixXd rows(positions.size(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    rows.row(static_cast<Eigen::Index>(i)) = positions[i];
  }
  return rows;
}

} // namespace

/// Corresponding positions, one in each row.
struct vtkShapeGivenLandmarks::Partners
{
  std::vector<Eigen::RowVector3d> OnA, OnB;

  shape::Landmarks Paired(const shape::Surface& a, const shape::Surface& b) const
  {
    return shape::PairLandmarks(a, AsRows(this->OnA), b, AsRows(this->OnB));
  }
};

vtkShapeGivenLandmarks::vtkShapeGivenLandmarks(
  vtkUnstructuredGrid* grid, const Eigen::MatrixXd& targets)
  : Grid(grid)
  , Positions(vtkShapeConvert::ToPoints(grid))
  , Targets(targets)
{
  if (this->Positions.rows() != targets.rows())
  {
    throw shape::InvalidInput("Landmarks has " + std::to_string(this->Positions.rows()) +
      " points, and TargetLandmarks has " + std::to_string(targets.rows()) +
      "; connect equally many, because they are paired by order");
  }
}

void vtkShapeGivenLandmarks::AddPoint(vtkIdType point, Partners& partners) const
{
  partners.OnA.emplace_back(this->Positions.row(point));
  partners.OnB.emplace_back(this->Targets.row(point));
}

void vtkShapeGivenLandmarks::AddBetween(
  vtkIdType p, vtkIdType q, double step, Partners& partners) const
{
  constexpr double maximum = 10000.0; // points on a segment
  const int pieces = static_cast<int>(std::clamp(
    std::ceil((this->Positions.row(q) - this->Positions.row(p)).norm() / step), 1.0, maximum));
  for (int k = 1; k < pieces; ++k)
  {
    const double t = static_cast<double>(k) / pieces;
    partners.OnA.emplace_back((1.0 - t) * this->Positions.row(p) + t * this->Positions.row(q));
    partners.OnB.emplace_back((1.0 - t) * this->Targets.row(p) + t * this->Targets.row(q));
  }
}

void vtkShapeGivenLandmarks::AddLine(vtkIdList* points, double step, Partners& partners) const
{
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    if (i > 0)
    {
      this->AddBetween(points->GetId(i - 1), points->GetId(i), step, partners);
    }
    this->AddPoint(points->GetId(i), partners);
  }
}

void vtkShapeGivenLandmarks::ForEachLine(const std::function<void(vtkIdList*)>& use) const
{
  for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
  {
    if (this->Grid->GetCell(cell)->GetCellDimension() == 1)
    {
      use(this->Grid->GetCell(cell)->GetPointIds());
    }
  }
}

shape::Landmarks vtkShapeGivenLandmarks::PairAll(
  const shape::Surface& a, const shape::Surface& b) const
{
  const double step = shape::ComputeMeanEdgeLength(a);
  Partners partners;
  for (Eigen::Index i = 0; i < this->Positions.rows(); ++i)
  {
    this->AddPoint(i, partners);
  }
  this->ForEachLine(
    [&](vtkIdList* points)
    {
      for (vtkIdType i = 1; i < points->GetNumberOfIds(); ++i)
      {
        this->AddBetween(points->GetId(i - 1), points->GetId(i), step, partners);
      }
    });
  return partners.Paired(a, b);
}

std::vector<shape::Landmarks> vtkShapeGivenLandmarks::PairCurves(
  const shape::Surface& a, const shape::Surface& b) const
{
  const double step = shape::ComputeMeanEdgeLength(a);
  std::vector<shape::Landmarks> curves;
  this->ForEachLine(
    [&](vtkIdList* points)
    {
      Partners curve;
      this->AddLine(points, step, curve);
      curves.push_back(curve.Paired(a, b));
    });
  return curves;
}

shape::Landmarks vtkShapeGivenLandmarks::PairEnds(
  const shape::Surface& a, const shape::Surface& b) const
{
  std::vector<bool> isPassed(this->Positions.rows(), false);
  this->ForEachLine(
    [&](vtkIdList* points)
    {
      for (vtkIdType i = 1; i + 1 < points->GetNumberOfIds(); ++i)
      {
        isPassed[points->GetId(i)] = true;
      }
    });
  this->ForEachLine(
    [&](vtkIdList* points) {
      isPassed[points->GetId(0)] = isPassed[points->GetId(points->GetNumberOfIds() - 1)] = false;
    });
  for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
  {
    vtkIdList* points = this->Grid->GetCell(cell)->GetPointIds();
    for (vtkIdType i = 0;
         this->Grid->GetCell(cell)->GetCellDimension() == 0 && i < points->GetNumberOfIds(); ++i)
    {
      isPassed[points->GetId(i)] = false;
    }
  }
  Partners partners;
  for (Eigen::Index i = 0; i < this->Positions.rows(); ++i)
  {
    if (!isPassed[i])
    {
      this->AddPoint(i, partners);
    }
  }
  return partners.Paired(a, b);
}

std::vector<shape::CurvePair> vtkShapeGivenLandmarks::TraceCurves(
  const shape::Surface& a, const shape::Surface& b) const
{
  // The step that is short enough on both surfaces.
  const double step = shape::ComputeMeanEdgeLength(a),
               stretch = std::sqrt(shape::ComputeArea(b) / shape::ComputeArea(a)),
               shorter = std::min(step, shape::ComputeMeanEdgeLength(b) / stretch);
  std::vector<shape::CurvePair> curves;
  this->ForEachLine(
    [&](vtkIdList* points)
    {
      Partners curve;
      this->AddLine(points, shorter, curve);
      curves.push_back({ shape::TraceEdgeCurve(a, AsRows(curve.OnA), "SurfaceA"),
        shape::TraceEdgeCurve(b, AsRows(curve.OnB), "SurfaceB") });
    });
  return curves;
}
