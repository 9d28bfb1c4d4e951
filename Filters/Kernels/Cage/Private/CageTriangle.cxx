#include "Cage/Private/CageTriangle.h"

#include "Base/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace shape
{

std::vector<CageTriangle> MakeCageTriangles(const Mesh& cage)
{
  std::vector<CageTriangle> triangles(cage.Triangles.rows());
  for (Eigen::Index t = 0; t < cage.Triangles.rows(); ++t)
  {
    CageTriangle& triangle = triangles[t];
    std::array<Eigen::Vector3d, 3> edges;
    for (int k = 0; k < 3; ++k)
    {
      triangle.Corners[k] = cage.Triangles(t, k);
      triangle.Points[k] = cage.Points.row(triangle.Corners[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      edges[k] = triangle.Points[(k + 2) % 3] - triangle.Points[(k + 1) % 3];
      triangle.Lengths[k] = edges[k].norm();
    }
    const Eigen::Vector3d area = edges[0].cross(edges[1]);
    triangle.TwiceArea = area.norm();
    const double longest = *std::max_element(triangle.Lengths.begin(), triangle.Lengths.end());
    if (!(triangle.TwiceArea > 1e-10 * longest * longest))
    {
      throw InvalidInput("triangle " + std::to_string(t) +
        " of the Cage has no area; merge coincident points with Clean, or remesh there");
    }
    triangle.Normal = area / triangle.TwiceArea;
    for (int k = 0; k < 3; ++k)
    {
      triangle.Tangents[k] = edges[k] / triangle.Lengths[k];
      triangle.Inward[k] = triangle.Normal.cross(triangle.Tangents[k]);
      for (int i = 0; i < 3; ++i)
      {
        triangle.EdgeProducts(k, i) = edges[k].dot(edges[i]);
      }
    }
  }
  return triangles;
}

} // namespace shape
