#include "Correspondence/Evaluate/InvertMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/VertexNormals.h"
#include "Search/ClosestPoint.h"
#include "Search/TriangleTree.h"

#include <cmath>
#include <memory>
#include <vector>

namespace shape
{
namespace
{

/// Beside the position, the scaled normal: opposite sheets are as far apart as a tenth of the root
/// of the area, even where they touch.
Eigen::MatrixXd PositionsAndNormals(const Surface& surface)
{
  constexpr double share = 0.05;
  Eigen::MatrixXd rows(surface.Points().rows(), 6);
  rows << surface.Points(), share * std::sqrt(ComputeArea(surface)) * GetVertexNormals(surface);
  return rows;
}

struct KeptTree
{
  TriangleTree Tree; ///< of the positions and normals
};

void RequireTriangles(const Surface& surface)
{
  if (surface.Triangles().rows() == 0)
  {
    throw InvalidInput("a map can only be inverted between surfaces with triangles");
  }
}

} // namespace

MapInverse::MapInverse(const Surface& surface, const SurfacePoints& images, const Surface& target)
  : Target(target)
{
  RequireTriangles(surface);
  RequireTriangles(target);
  this->Rows = PositionsAndNormals(target);
  this->MovedRows = PullBack(images, target.Triangles(), this->Rows);
  this->Moved = surface.WithPoints(this->MovedRows.leftCols(3));
}

SurfacePoints MapInverse::FindRows(const Eigen::MatrixXd& rows, const Progress& progress) const
{
  const Eigen::MatrixXi& triangles = this->Moved.Triangles();
  SurfacePoints inverse = SurfaceLocator(this->Moved).Find(rows.leftCols(3), progress);
  const Eigen::MatrixXd found = PullBack(inverse, triangles, this->MovedRows);
  std::vector<int> opposite; // positions whose nearest sheet faces the other way
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    if (found.row(i).tail(3).dot(rows.row(i).tail(3)) < 0.0)
    {
      opposite.push_back(static_cast<int>(i));
    }
  }
  if (opposite.empty())
  {
    return inverse;
  }
  const std::shared_ptr<const KeptTree> kept = this->Moved.Cached<KeptTree>(
    [&] { return KeptTree{ TriangleTree(triangles, this->MovedRows) }; });
  constexpr int grain = 256;
  ParallelFor(static_cast<int>(opposite.size()), grain,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        const int i = opposite[k];
        const NearestTriangle nearest = kept->Tree.Find(rows.row(i), 0);
        inverse.Triangles(i) = nearest.Triangle;
        inverse.Barycentrics.row(i) = nearest.Barycentric;
      }
    });
  return inverse;
}

SurfacePoints MapInverse::Find(const SurfacePoints& positions, const Progress& progress) const
{
  return this->FindRows(PullBack(positions, this->Target.Triangles(), this->Rows), progress);
}

SurfacePoints MapInverse::FindAll(const Progress& progress) const
{
  return this->FindRows(this->Rows, progress);
}

SurfacePoints InvertMap(const Surface& surface, const SurfacePoints& images, const Surface& target,
  const Progress& progress)
{
  return MapInverse(surface, images, target).FindAll(progress);
}

} // namespace shape
