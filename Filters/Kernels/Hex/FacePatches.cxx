#include "Hex/FacePatches.h"

#include "Search/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <map>

namespace shape
{

Eigen::MatrixXi FindFacePatches(
  const HexMesh& solid, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patches)
{
  using Quad = std::array<int, 4>;
  const auto sorted = [](Quad quad)
  {
    std::sort(quad.begin(), quad.end());
    return quad;
  };
  std::map<Quad, int> patchOf;
  for (Eigen::Index i = 0; i < quads.rows(); ++i)
  {
    patchOf[sorted({ quads(i, 0), quads(i, 1), quads(i, 2), quads(i, 3) })] = patches(i);
  }
  Eigen::MatrixXi result = Eigen::MatrixXi::Constant(solid.Hexahedra.rows(), 6, -1);
  for (Eigen::Index hex = 0; hex < result.rows(); ++hex)
  {
    for (int face = 0; face < 6; ++face)
    {
      Quad quad;
      for (int k = 0; k < 4; ++k)
      {
        quad[k] = solid.Hexahedra(hex, HexFaces[face][k]);
      }
      const auto found = patchOf.find(sorted(quad));
      if (found != patchOf.end())
      {
        result(hex, face) = found->second;
      }
    }
  }
  return result;
}

Eigen::VectorXi FindNearestPatches(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads,
  const Surface& surface, const Eigen::VectorXi& given)
{
  return given(SurfaceLocator(surface).Find(ComputeQuadCentres(points, quads)).Triangles);
}

Eigen::VectorXi TakeMostFrequent(const Eigen::VectorXi& values, const Eigen::VectorXi& patches)
{
  std::map<int, std::map<int, int>> counts; // of each value in each patch
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    ++counts[patches(i)][values(i)];
  }
  std::map<int, int> valueOf;
  for (const auto& [patch, own] : counts)
  {
    valueOf[patch] = std::max_element(own.begin(), own.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  }
  return patches.unaryExpr([&](int patch) { return valueOf.at(patch); });
}

} // namespace shape
