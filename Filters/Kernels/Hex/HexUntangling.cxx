#include "Hex/HexUntangling.h"

#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <vector>

namespace shape
{
namespace
{

constexpr int Rings[] = { 1, 2, 3, 4, 6 };

double MeanEdge(const HexMesh& mesh, Eigen::Index hex)
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
  return sum / 24.0;
}

/// The corners of all hexahedra with a marked point, each beside that of a cube of about its size.
SimplexPatch PatchOf(
  const HexMesh& mesh, const PointConstraint& constraint, const std::vector<char>& marked)
{
  SimplexPatch patch;
  std::vector<char> used(marked.size(), 0);
  for (Eigen::Index hex = 0; hex < mesh.Hexahedra.rows(); ++hex)
  {
    const auto points = mesh.Hexahedra.row(hex);
    if (std::none_of(points.begin(), points.end(), [&](int point) { return marked[point]; }))
    {
      continue;
    }
    const auto gradients = HatGradients(MeanEdge(mesh, hex) * Eigen::Matrix3d::Identity());
    for (int corner = 0; corner < 8; ++corner)
    {
      const int* ends = HexNeighbours[corner];
      patch.Simplices.push_back(
        { { points(corner), points(ends[0]), points(ends[1]), points(ends[2]) }, gradients });
      used[points(corner)] = 1;
    }
  }
  for (int point = 0; point < static_cast<int>(marked.size()); ++point)
  {
    if (marked[point] && used[point] && constraint.Freedom(point) > 0)
    {
      patch.FreePoints.push_back(point);
    }
  }
  return patch;
}

} // namespace

int UntangleHexahedra(HexMesh& mesh, const PointConstraint& constraint, const Progress& progress)
{
  Eigen::VectorXd values = ScaledJacobians(mesh);
  const auto inverted = [&] { return static_cast<int>((values.array() <= 0.0).count()); };
  for (const int& rings : Rings)
  {
    const int before = inverted();
    if (before == 0)
    {
      break;
    }
    std::vector<char> marked(mesh.Points.rows(), 0);
    for (Eigen::Index hex = 0; hex < values.size(); ++hex)
    {
      if (values(hex) <= 0.0)
      {
        const auto points = mesh.Hexahedra.row(hex);
        std::for_each(points.begin(), points.end(), [&](int point) { marked[point] = 1; });
      }
    }
    GrowRings(mesh.Hexahedra, rings - 1, marked);
    const auto done = static_cast<double>(&rings - Rings);
    const double rounds = std::size(Rings);
    const Eigen::MatrixXd kept = mesh.Points;
    LowerEnergy(mesh.Points, PatchOf(mesh, constraint, marked), &constraint, {},
      progress.Part(done / rounds, (done + 1.0) / rounds));
    values = ScaledJacobians(mesh);
    if (inverted() > before)
    {
      mesh.Points = kept;
      values = ScaledJacobians(mesh);
    }
  }
  progress(1.0);
  return inverted();
}

} // namespace shape
