#include "Fill/Private/PatchSelfIntersections.h"

#include "Mesh/CoincidentPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace shape
{
namespace
{

using Box = Eigen::AlignedBox3d;

Box BoxOf(const Mesh& mesh, int triangle)
{
  Box box;
  for (const int corner : mesh.Triangles.row(triangle))
  {
    box.extend(Eigen::Vector3d(mesh.Points.row(corner).transpose()));
  }
  return box;
}

/// A box divided into cells, some of which are marked.
class MarkedCells
{
public:
  explicit MarkedCells(const Box& box)
    : Low(box.min())
    , Size((box.max() - box.min()).maxCoeff() / Count)
    , Marks(Count * Count * Count, false)
  {
  }

  void Mark(const Box& box)
  {
    this->ForEach(box,
      [&](int cell)
      {
        this->Marks[cell] = true;
        return true;
      });
  }
  bool IsMarked(const Box& box) const
  {
    return !this->ForEach(box, [&](int cell) { return !this->Marks[cell]; });
  }

private:
  static constexpr int Count = 24;

  /// Calls body with the cells that a box intersects until it returns false; returns its last
  /// result.
  template <typename Body>
  bool ForEach(const Box& box, const Body& body) const
  {
    std::array<int, 3> first, last;
    for (int k = 0; k < 3; ++k)
    {
      const double begin = box.min()(k) - this->Low(k), end = box.max()(k) - this->Low(k);
      const double maximum = Count * this->Size;
      if (end < 0.0 || begin > maximum)
      {
        return true;
      }
      const auto cell = [&](double at) {
        return this->Size > 0.0 ? std::clamp(static_cast<int>(at / this->Size), 0, Count - 1) : 0;
      };
      first[k] = cell(std::max(begin, 0.0));
      last[k] = cell(std::min(end, maximum));
    }
    for (int x = first[0]; x <= last[0]; ++x)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int z = first[2]; z <= last[2]; ++z)
        {
          if (!body((x * Count + y) * Count + z))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  Eigen::Vector3d Low;
  double Size;
  std::vector<bool> Marks;
};

/// The triangles from `first` on, and the earlier ones near them.
std::vector<int> TrianglesNearby(const Mesh& surface, int first)
{
  Box all;
  for (int t = first; t < static_cast<int>(surface.Triangles.rows()); ++t)
  {
    all.extend(BoxOf(surface, t));
  }
  std::vector<int> near;
  if (all.isEmpty())
  {
    return near;
  }
  MarkedCells cells(all);
  for (int t = first; t < static_cast<int>(surface.Triangles.rows()); ++t)
  {
    cells.Mark(BoxOf(surface, t));
  }
  for (int t = 0; t < static_cast<int>(surface.Triangles.rows()); ++t)
  {
    if (t >= first || cells.IsMarked(BoxOf(surface, t)))
    {
      near.push_back(t);
    }
  }
  return near;
}

} // namespace

std::vector<Crossing> FindPatchSelfIntersections(
  const Mesh& surface, int first, const Progress& progress, int maximum)
{
  progress(0.0);
  std::vector<int> triangles = TrianglesNearby(surface, first);
  std::vector<int> used(3 * triangles.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    used[i] = surface.Triangles(triangles[i / 3], static_cast<Eigen::Index>(i % 3));
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Mesh near{ Eigen::MatrixXd(used.size(), 3), Eigen::MatrixXi(triangles.size(), 3) };
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    near.Points.row(static_cast<Eigen::Index>(i)) = surface.Points.row(used[i]);
  }
  const std::vector<int> position = FindCoincidentPoints(near.Points);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto number =
        std::lower_bound(used.begin(), used.end(), surface.Triangles(triangles[i], k)) -
        used.begin();
      near.Triangles(static_cast<Eigen::Index>(i), k) = position[number];
    }
  }
  // Triangles without area are left out.
  const std::vector<int> flat = FindDegenerateTriangles(near);
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i)
  {
    if (!std::binary_search(flat.begin(), flat.end(), i))
    {
      near.Triangles.row(static_cast<Eigen::Index>(kept.size())) = near.Triangles.row(i).eval();
      kept.push_back(triangles[i]);
    }
  }
  near.Triangles.conservativeResize(static_cast<Eigen::Index>(kept.size()), 3);
  const auto begin =
    static_cast<int>(std::lower_bound(kept.begin(), kept.end(), first) - kept.begin());
  std::vector<Crossing> found =
    FindSelfIntersectionsFrom(std::move(near), begin, maximum, progress);
  for (Crossing& crossing : found)
  {
    crossing.First = kept[crossing.First];
    crossing.Second = kept[crossing.Second];
  }
  return found;
}

} // namespace shape
