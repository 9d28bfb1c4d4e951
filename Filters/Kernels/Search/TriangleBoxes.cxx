#include "Search/TriangleBoxes.h"

#include "Mesh/SurfaceWork.h"

#include <Eigen/Geometry>

#include <numeric>
#include <vector>

namespace shape
{

std::shared_ptr<const BoxTree> GetTriangleBoxes(const Surface& surface)
{
  return surface.Cached<BoxTree>(
    [&surface]()
    {
      SurfaceWork::Note(SurfaceWork::Kind::SearchTree, surface.Points());
      std::vector<int> triangles(surface.Triangles().rows());
      std::iota(triangles.begin(), triangles.end(), 0);
      std::vector<Eigen::AlignedBox3d> boxes;
      boxes.reserve(triangles.size());
      for (const int t : triangles)
      {
        const Eigen::Matrix3d corners = GetCorners(surface, t);
        boxes.emplace_back(corners.colwise().minCoeff(), corners.colwise().maxCoeff());
      }
      BoxTree tree;
      tree.init(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
      return tree;
    });
}

} // namespace shape
