#include "Hex/Fit/Private/Padding.h"

#include <algorithm>

namespace shape
{

std::vector<int> PadQuads(HexMesh& mesh, const Eigen::MatrixXi& quads)
{
  std::vector<int> copyOf(mesh.Points.rows(), -1);
  for (const int point : quads.reshaped())
  {
    copyOf[point] = 0;
  }
  auto count = static_cast<int>(mesh.Points.rows());
  for (int& copy : copyOf)
  {
    copy = copy < 0 ? -1 : count++;
  }
  mesh.Points.conservativeResize(count, 3);
  for (std::size_t point = 0; point < copyOf.size(); ++point)
  {
    if (copyOf[point] >= 0)
    {
      mesh.Points.row(copyOf[point]) = mesh.Points.row(static_cast<Eigen::Index>(point));
    }
  }
  for (int& point : mesh.Hexahedra.reshaped())
  {
    point = copyOf[point] >= 0 ? copyOf[point] : point;
  }
  const Eigen::Index cells = mesh.Hexahedra.rows();
  mesh.Hexahedra.conservativeResize(cells + quads.rows(), 8);
  for (Eigen::Index q = 0; q < quads.rows(); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      mesh.Hexahedra(cells + q, k) = copyOf[quads(q, k)];
      mesh.Hexahedra(cells + q, k + 4) = quads(q, k);
    }
  }
  return copyOf;
}

} // namespace shape
