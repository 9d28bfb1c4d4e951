#include "Tetrahedra/Private/SetsBetweenSurfaces.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// A face of a tetrahedron, or a part of a surface if Tetrahedron is -1.
struct Face
{
  std::array<int, 3> Points; ///< sorted
  int Tetrahedron;
};

/// Returns all faces; equal ones are adjacent, those of surfaces before those of tetrahedra.
std::vector<Face> SortFaces(
  const Eigen::MatrixXi& tetrahedra, const Eigen::MatrixXi& onSurfaces, const Progress& progress)
{
  std::vector<Face> faces;
  faces.reserve(4 * tetrahedra.rows() + onSurfaces.rows());
  const auto add = [&](int a, int b, int c, int tetrahedron)
  {
    faces.push_back({ { a, b, c }, tetrahedron });
    std::sort(faces.back().Points.begin(), faces.back().Points.end());
  };
  for (int i = 0; i < tetrahedra.rows(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      add(tetrahedra(i, k), tetrahedra(i, (k + 1) % 4), tetrahedra(i, (k + 2) % 4), i);
    }
    ReportEvery(i, tetrahedra.rows(), progress.Part(0.0, 0.3));
  }
  for (Eigen::Index t = 0; t < onSurfaces.rows(); ++t)
  {
    add(onSurfaces(t, 0), onSurfaces(t, 1), onSurfaces(t, 2), -1);
  }
  // By their first points at once, then among those of each: no single call sorts them all.
  std::vector<std::size_t> first(2 + std::max(tetrahedra.maxCoeff(), onSurfaces.maxCoeff()), 0);
  for (const Face& face : faces)
  {
    ++first[face.Points[0] + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Face> sorted(faces.size());
  std::vector<std::size_t> next = first;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    sorted[next[faces[i].Points[0]]++] = faces[i];
    ReportEvery(i, faces.size(), progress.Part(0.3, 0.6));
  }
  for (std::size_t point = 0; point + 1 < first.size(); ++point)
  {
    std::sort(sorted.begin() + first[point], sorted.begin() + first[point + 1],
      [](const Face& a, const Face& b)
      { return a.Points != b.Points ? a.Points < b.Points : a.Tetrahedron < b.Tetrahedron; });
    ReportEvery(point, first.size(), progress.Part(0.6, 1.0));
  }
  return sorted;
}

} // namespace

Eigen::VectorXi FindSetsBetweenSurfaces(
  const Eigen::MatrixXi& tetrahedra, const Eigen::MatrixXi& onSurfaces, const Progress& progress)
{
  const std::vector<Face> faces = SortFaces(tetrahedra, onSurfaces, progress.Part(0.0, 0.6));
  DisjointSets connected(static_cast<int>(tetrahedra.rows()));
  int missing = 0, open = 0;
  Eigen::Index visited = 0;
  for (std::size_t i = 0; i < faces.size();)
  {
    // A face of two tetrahedra connects them unless it lies on a surface. One that lies on a
    // surface without a tetrahedron is missing; one of a single tetrahedron that lies on no surface
    // is open.
    const bool onSurface = faces[i].Tetrahedron == -1;
    const std::size_t first = i + onSurface;
    std::size_t next = first;
    while (next < faces.size() && faces[next].Points == faces[i].Points)
    {
      ++next;
    }
    missing += next == first;
    open += !onSurface && next != first + 2;
    if (!onSurface && next == first + 2)
    {
      connected.Merge(faces[first].Tetrahedron, faces[first + 1].Tetrahedron);
    }
    ReportEvery(visited++, faces.size(), progress.Part(0.6, 0.9));
    i = next;
  }
  if (missing + open > 0)
  {
    throw SolveFailure("TetGen's tetrahedra do not contain " + std::to_string(missing) +
      " triangles of the surface, and their boundary has " + std::to_string(open) +
      " faces off the surface; remesh where triangles are thin, or change PreserveBoundary");
  }
  // Numbered in the order of their first tetrahedra.
  int sets = 0;
  std::vector<int> number(tetrahedra.rows(), -1);
  Eigen::VectorXi set(tetrahedra.rows());
  for (int i = 0; i < static_cast<int>(tetrahedra.rows()); ++i)
  {
    int& known = number[connected.Find(i)];
    known = known == -1 ? sets++ : known;
    set(i) = known;
    ReportEvery(i, tetrahedra.rows(), progress.Part(0.9, 1.0));
  }
  return set;
}

} // namespace shape
