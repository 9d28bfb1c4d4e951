#include "Planar/PlanarLocator.h"

#include "Geometry/Orientation.h"

#include <algorithm>
#include <cmath>

namespace shape
{

using Eigen::RowVector2d;

PlanarLocator::PlanarLocator(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles, const std::vector<int>& leftOut)
  : Points(points)
  , Triangles(triangles)
  , Lower(RowVector2d::Zero())
  , Upper(RowVector2d::Zero())
{
  if (points.rows() > 0)
  {
    this->Lower = points.colwise().minCoeff();
    this->Upper = points.colwise().maxCoeff();
  }
  // About as many square cells as triangles. The bound on the shape limits their number if all
  // points lie nearly on a line.
  const RowVector2d size = this->Upper - this->Lower;
  const double longest = size.maxCoeff();
  if (longest > 0.0)
  {
    const double shape = std::max(size.minCoeff() / longest, 1e-3);
    const double count = std::max(1.0, static_cast<double>(triangles.rows()) / shape);
    this->CellSize = longest / std::ceil(std::sqrt(count));
    for (int k = 0; k < 2; ++k)
    {
      this->Cells[k] = std::max(1, static_cast<int>(std::ceil(size(k) / this->CellSize)));
    }
  }

  std::vector<char> counts(triangles.rows(), 1);
  for (const int triangle : leftOut)
  {
    counts[triangle] = 0;
  }
  const auto corner = [&](Eigen::Index t, int k) -> RowVector2d
  { return this->Points.row(this->Triangles(t, k)); };
  const auto forEachCell = [&](const auto& use)
  {
    for (int t = 0; t < triangles.rows(); ++t)
    {
      if (!counts[t])
      {
        continue;
      }
      const RowVector2d a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
      const std::array<int, 2> low = this->CellOf(a.cwiseMin(b).cwiseMin(c)),
                               high = this->CellOf(a.cwiseMax(b).cwiseMax(c));
      for (int y = low[1]; y <= high[1]; ++y)
      {
        for (int x = low[0]; x <= high[0]; ++x)
        {
          use(y * this->Cells[0] + x, t);
        }
      }
    }
  };
  for (int t = 0; t < triangles.rows(); ++t)
  {
    counts[t] = counts[t] && EvaluateOrientation(corner(t, 0), corner(t, 1), corner(t, 2)) > 0;
  }
  // Triangles are counted for each cell, then listed, cell by cell and ascending.
  this->First.assign(this->Cells[0] * this->Cells[1] + 1, 0);
  forEachCell([&](int cell, int) { ++this->First[cell + 1]; });
  for (std::size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->Inside.resize(this->First.back());
  std::vector<int> next(this->First.begin(), this->First.end() - 1);
  forEachCell([&](int cell, int t) { this->Inside[next[cell]++] = t; });
}

std::array<int, 2> PlanarLocator::CellOf(const RowVector2d& position) const
{
  std::array<int, 2> cell{};
  for (int k = 0; k < 2; ++k)
  {
    const double along = std::floor((position(k) - this->Lower(k)) / this->CellSize);
    cell[k] = static_cast<int>(std::clamp(along, 0.0, this->Cells[k] - 1.0));
  }
  return cell;
}

SurfacePoint PlanarLocator::Find(const RowVector2d& position) const
{
  SurfacePoint found;
  if (!((position - this->Lower).minCoeff() >= 0.0 && (this->Upper - position).minCoeff() >= 0.0))
  {
    return found;
  }
  const auto [x, y] = this->CellOf(position);
  const int cell = y * this->Cells[0] + x;
  for (int i = this->First[cell]; i < this->First[cell + 1]; ++i)
  {
    const int triangle = this->Inside[i];
    const RowVector2d a = this->Points.row(this->Triangles(triangle, 0)),
                      b = this->Points.row(this->Triangles(triangle, 1)),
                      c = this->Points.row(this->Triangles(triangle, 2));
    // Triangles of a cell ascend, so the first that contains the position has the lowest number.
    if (EvaluateOrientation(a, b, position) >= 0 && EvaluateOrientation(b, c, position) >= 0 &&
      EvaluateOrientation(c, a, position) >= 0)
    {
      const auto area = [](const RowVector2d& u, const RowVector2d& v)
      { return std::max(0.0, u(0) * v(1) - u(1) * v(0)); };
      const Eigen::RowVector3d areas(area(b - position, c - position),
        area(c - position, a - position), area(a - position, b - position));
      // The choice of the triangle is exact; the barycentric coordinates are rounded.
      found.Triangle = triangle;
      found.Barycentric = areas / areas.sum();
      return found;
    }
  }
  return found;
}

bool PlanarLocator::AnyNear(
  const RowVector2d& lower, const RowVector2d& upper, const std::function<bool(int)>& use) const
{
  const std::array<int, 2> low = this->CellOf(lower), high = this->CellOf(upper);
  for (int y = low[1]; y <= high[1]; ++y)
  {
    for (int x = low[0]; x <= high[0]; ++x)
    {
      const int cell = y * this->Cells[0] + x;
      for (int i = this->First[cell]; i < this->First[cell + 1]; ++i)
      {
        if (use(this->Inside[i]))
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace shape
