#include "Hex/FacePatches.h"

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

} // namespace shape
