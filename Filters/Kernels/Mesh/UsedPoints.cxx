#include "Mesh/UsedPoints.h"

namespace shape
{

std::vector<int> FindUsedPoints(const Eigen::MatrixXi& elements, Eigen::Index points)
{
  std::vector<char> isUsed(points, 0);
  for (const int point : elements.reshaped())
  {
    isUsed[point] = 1;
  }
  std::vector<int> used;
  for (int i = 0; i < points; ++i)
  {
    if (isUsed[i])
    {
      used.push_back(i);
    }
  }
  return used;
}

std::vector<int> InvertIndices(const std::vector<int>& kept, Eigen::Index points)
{
  std::vector<int> positions(points, -1);
  for (std::size_t k = 0; k < kept.size(); ++k)
  {
    positions[kept[k]] = static_cast<int>(k);
  }
  return positions;
}

Eigen::MatrixXi RenumberPoints(
  const Eigen::MatrixXi& elements, const std::vector<int>& kept, Eigen::Index points)
{
  const std::vector<int> positions = InvertIndices(kept, points);
  return elements.unaryExpr([&](int point) { return positions[point]; });
}

Mesh ExtractTriangles(const Mesh& mesh, const std::vector<int>& triangles)
{
  const Eigen::MatrixXi chosen = mesh.Triangles(triangles, Eigen::all);
  const std::vector<int> used = FindUsedPoints(chosen, mesh.Points.rows());
  return { mesh.Points(used, Eigen::all), RenumberPoints(chosen, used, mesh.Points.rows()) };
}

Mesh JoinMeshes(const std::vector<Mesh>& meshes)
{
  Eigen::Index points = 0, triangles = 0;
  for (const Mesh& mesh : meshes)
  {
    points += mesh.Points.rows();
    triangles += mesh.Triangles.rows();
  }
  Mesh all{ Eigen::MatrixXd(points, 3), Eigen::MatrixXi(triangles, 3) };
  points = triangles = 0;
  for (const Mesh& mesh : meshes)
  {
    all.Points.middleRows(points, mesh.Points.rows()) = mesh.Points;
    all.Triangles.middleRows(triangles, mesh.Triangles.rows()) =
      mesh.Triangles.array() + static_cast<int>(points);
    points += mesh.Points.rows();
    triangles += mesh.Triangles.rows();
  }
  return all;
}

} // namespace shape
