#include "Hex/Private/HarmonicExtension.h"

#include "Mesh/HexMesh.h"

namespace shape
{

HarmonicExtension::HarmonicExtension(const std::vector<std::pair<int, int>>& edges,
  const std::vector<char>& isGiven, const Progress& progress)
{
  std::vector<int> given;
  for (int point = 0; point < static_cast<int>(isGiven.size()); ++point)
  {
    (isGiven[point] ? given : this->Others).push_back(point);
  }
  if (this->Others.empty())
  {
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, b] : edges)
  {
    for (const auto& [row, column] : { std::pair(a, b), std::pair(b, a) })
    {
      entries.emplace_back(row, row, 1.0);
      entries.emplace_back(row, column, -1.0);
    }
  }
  const auto count = static_cast<Eigen::Index>(isGiven.size());
  this->Stiffness.resize(count, count);
  this->Stiffness.setFromTriplets(entries.begin(), entries.end());
  this->Problem = std::make_unique<DirichletProblem>(this->Stiffness, given, progress);
}

void HarmonicExtension::Extend(Eigen::MatrixXd& values, const Progress& progress) const
{
  for (const int point : this->Others)
  {
    values.row(point).setZero();
  }
  if (this->Problem)
  {
    this->Problem->Solve(values, Eigen::MatrixXd::Zero(values.rows(), values.cols()), progress);
  }
}

std::vector<std::pair<int, int>> ListHexEdges(const Eigen::MatrixXi& hexahedra)
{
  std::vector<std::pair<int, int>> edges;
  for (Eigen::Index hex = 0; hex < hexahedra.rows(); ++hex)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      for (const int other : HexNeighbours[corner])
      {
        if (corner < other)
        {
          edges.emplace_back(hexahedra(hex, corner), hexahedra(hex, other));
        }
      }
    }
  }
  return edges;
}

} // namespace shape
