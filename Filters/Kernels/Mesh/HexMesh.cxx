#include "Mesh/HexMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shape
{

Eigen::MatrixXi FindBoundaryQuads(const HexMesh& mesh)
{
  // The sorted corners of a face, and its index.
  struct Face
  {
    std::array<int, 4> Corners;
    int Index;
  };
  // Equal faces have the same lowest corner: faces are put in bins by it, and compared there.
  std::vector<int> begin(mesh.Hexahedra.size() > 0 ? mesh.Hexahedra.maxCoeff() + 2 : 1, 0);
  std::vector<Face> faces(6 * mesh.Hexahedra.rows()), binned(faces.size());
  for (int i = 0; i < static_cast<int>(faces.size()); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      faces[i].Corners[k] = mesh.Hexahedra(i / 6, HexFaces[i % 6][k]);
    }
    std::sort(faces[i].Corners.begin(), faces[i].Corners.end());
    faces[i].Index = i;
    ++begin[faces[i].Corners[0] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> next = begin;
  for (const Face& face : faces)
  {
    binned[next[face.Corners[0]]++] = face;
  }
  std::vector<int> alone;
  for (std::size_t bin = 0; bin + 1 < begin.size(); ++bin)
  {
    const auto first = binned.begin() + begin[bin], last = binned.begin() + begin[bin + 1];
    std::for_each(first, last,
      [&](const Face& face)
      {
        if (std::count_if(
              first, last, [&](const Face& other) { return other.Corners == face.Corners; }) == 1)
        {
          alone.push_back(face.Index);
        }
      });
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
