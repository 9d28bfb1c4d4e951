#include "Mesh/HexMesh.h"

#include <algorithm>
#include <array>

namespace shape
{

Eigen::MatrixXi FindBoundaryQuads(const HexMesh& mesh)
{
  // The sorted corners of each face, and its index: equal faces become adjacent.
  std::vector<std::array<int, 5>> faces;
  faces.reserve(6 * mesh.Hexahedra.rows());
  for (int hex = 0; hex < mesh.Hexahedra.rows(); ++hex)
  {
    for (int face = 0; face < 6; ++face)
    {
      std::array<int, 5> key{};
      for (int k = 0; k < 4; ++k)
      {
        key[k] = mesh.Hexahedra(hex, HexFaces[face][k]);
      }
      std::sort(key.begin(), key.begin() + 4);
      key[4] = 6 * hex + face;
      faces.push_back(key);
    }
  }
  std::sort(faces.begin(), faces.end());
  const auto same = [&](std::size_t i, std::size_t j)
  { return std::equal(faces[i].begin(), faces[i].begin() + 4, faces[j].begin()); };
  std::vector<int> alone;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if ((i == 0 || !same(i, i - 1)) && (i + 1 == faces.size() || !same(i, i + 1)))
    {
      alone.push_back(faces[i][4]);
    }
  }
  std::sort(alone.begin(), alone.end());
  Eigen::MatrixXi quads(alone.size(), 4);
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      quads(static_cast<Eigen::Index>(i), k) =
        mesh.Hexahedra(alone[i] / 6, HexFaces[alone[i] % 6][k]);
    }
  }
  return quads;
}

Eigen::MatrixXi SplitQuads(const Eigen::MatrixXi& quads)
{
  Eigen::MatrixXi triangles(2 * quads.rows(), 3);
  for (Eigen::Index q = 0; q < quads.rows(); ++q)
  {
    triangles.row(2 * q) << quads(q, 0), quads(q, 1), quads(q, 2);
    triangles.row(2 * q + 1) << quads(q, 0), quads(q, 2), quads(q, 3);
  }
  return triangles;
}

Eigen::MatrixXd ComputeQuadCentres(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads)
{
  Eigen::MatrixXd centres(quads.rows(), 3);
  for (Eigen::Index q = 0; q < quads.rows(); ++q)
  {
    centres.row(q) = points(quads.row(q), Eigen::all).colwise().mean();
  }
  return centres;
}

double ComputeMeanEdgeLength(const HexMesh& mesh, Eigen::Index hex)
{
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (const int end : HexNeighbours[corner])
    {
      sum +=
        (mesh.Points.row(mesh.Hexahedra(hex, corner)) - mesh.Points.row(mesh.Hexahedra(hex, end)))
          .norm();
    }
  }
  // 12 edges, each of them counted at both ends.
  return sum / 24.0;
}

void GrowRings(const Eigen::MatrixXi& hexahedra, int rings, std::vector<char>& marked)
{
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<char> before = marked;
    for (const auto hex : hexahedra.rowwise())
    {
      if (std::any_of(hex.begin(), hex.end(), [&](int point) { return before[point]; }))
      {
        std::for_each(hex.begin(), hex.end(), [&](int point) { marked[point] = 1; });
      }
    }
  }
}

} // namespace shape
