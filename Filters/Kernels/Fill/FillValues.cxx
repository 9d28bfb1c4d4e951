#include "Fill/FillValues.h"

#include "Laplacian/Membrane.h"
#include "Search/PointTree.h"

#include <map>

namespace shape
{

std::vector<FillSources> FindFillSources(const Mesh& surface, const std::vector<FilledHole>& holes)
{
  std::vector<int> triangleAt(surface.Points.rows(), -1);
  const int count = holes.empty() ? 0 : holes.front().FirstTriangle;
  for (int t = count - 1; t >= 0; --t)
  {
    for (const int point : surface.Triangles.row(t))
    {
      triangleAt[point] = t;
    }
  }
  std::vector<FillSources> sources;
  for (const FilledHole& hole : holes)
  {
    Eigen::MatrixXd loop(hole.Loop.size(), 3);
    for (std::size_t i = 0; i < hole.Loop.size(); ++i)
    {
      loop.row(static_cast<Eigen::Index>(i)) = surface.Points.row(hole.Loop[i]);
    }
    const PointTree tree(loop);
    const auto nearest = [&](const Eigen::RowVector3d& position)
    { return hole.Loop[tree.Nearest(position, 1).front()]; };
    FillSources& own = sources.emplace_back();
    for (int i = hole.FirstPoint; i < hole.FirstPoint + hole.Points; ++i)
    {
      own.Points.push_back(nearest(surface.Points.row(i)));
    }
    for (int t = hole.FirstTriangle; t < hole.FirstTriangle + hole.Triangles; ++t)
    {
      own.Triangles.push_back(triangleAt[nearest(GetCorners(surface, t).colwise().mean())]);
    }
  }
  return sources;
}

Eigen::MatrixXd ExtendValuesOntoFill(
  const Mesh& surface, const FilledHole& hole, const Eigen::MatrixXd& values)
{
  std::map<int, int> rows; // of the patch: the rim, then the fill's own points
  std::vector<int> points;
  for (const int point : hole.Loop)
  {
    if (rows.insert({ point, static_cast<int>(points.size()) }).second)
    {
      points.push_back(point);
    }
  }
  const auto loop = static_cast<Eigen::Index>(points.size());
  for (int i = 0; i < hole.Points; ++i)
  {
    rows[hole.FirstPoint + i] = static_cast<int>(points.size());
    points.push_back(hole.FirstPoint + i);
  }
  Mesh patch{ surface.Points(points, Eigen::all),
    surface.Triangles.middleRows(hole.FirstTriangle, hole.Triangles) };
  for (int& corner : patch.Triangles.reshaped())
  {
    corner = rows.at(corner);
  }
  const Eigen::MatrixXd loopValues =
    values(std::vector<int>(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(loop)),
      Eigen::all);
  return SolveHarmonicValues(patch, loopValues).bottomRows(hole.Points);
}

} // namespace shape
