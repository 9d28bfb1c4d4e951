#include "Hex/Optimize/Private/HexUntangling.h"

#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The sizes of the patches: points beyond stay, so a patch that is too small may have no solution.
constexpr int Rings[] = { 1, 2, 3, 4, 6 };
/// After this many rounds with little progress the rest is left inverted.
constexpr int MaximumIdleSteps = 2;

/// The hexahedra around each point.
std::vector<std::vector<int>> HexahedraAround(const HexMesh& mesh)
{
  std::vector<std::vector<int>> around(mesh.Points.rows());
  for (int hex = 0; hex < static_cast<int>(mesh.Hexahedra.rows()); ++hex)
  {
    for (const int point : mesh.Hexahedra.row(hex))
    {
      around[point].push_back(hex);
    }
  }
  return around;
}

/// Splits the hexahedra with a marked point into sets connected by marked points.
std::vector<std::vector<int>> Pieces(
  const HexMesh& mesh, const std::vector<std::vector<int>>& around, const std::vector<char>& marked)
{
  std::vector<std::vector<int>> pieces;
  std::vector<char> seen(mesh.Hexahedra.rows(), 0);
  for (std::size_t point = 0; point < marked.size(); ++point)
  {
    if (!marked[point] || around[point].empty() || seen[around[point][0]])
    {
      continue;
    }
    std::vector<int> piece = { around[point][0] };
    seen[piece[0]] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      for (const int corner : mesh.Hexahedra.row(piece[i]))
      {
        for (const int hex : around[corner])
        {
          if (marked[corner] && !seen[hex])
          {
            seen[hex] = 1;
            piece.push_back(hex);
          }
        }
      }
    }
    std::sort(piece.begin(), piece.end());
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// The corners of hexahedra, each with the corner of a cube of similar size as its reference.
SimplexPatch PatchOf(const HexMesh& mesh, const std::vector<int>& hexahedra,
  const PointConstraint& constraint, const std::vector<char>& marked)
{
  SimplexPatch patch;
  for (const int hex : hexahedra)
  {
    const auto points = mesh.Hexahedra.row(hex);
    // The size of the reference is the hexahedron's, because the energy's volume term keeps the
    // volume.
    const auto gradients =
      ComputeHatGradients(ComputeMeanEdgeLength(mesh, hex) * Eigen::Matrix3d::Identity());
    for (int corner = 0; corner < 8; ++corner)
    {
      const int* ends = HexNeighbours[corner];
      patch.Simplices.push_back(
        { { points(corner), points(ends[0]), points(ends[1]), points(ends[2]) }, gradients });
      if (marked[points(corner)] && constraint.Freedom(points(corner)) > 0)
      {
        patch.FreePoints.push_back(points(corner));
      }
    }
  }
  std::sort(patch.FreePoints.begin(), patch.FreePoints.end());
  patch.FreePoints.erase(
    std::unique(patch.FreePoints.begin(), patch.FreePoints.end()), patch.FreePoints.end());
  return patch;
}

int CountInverted(const HexMesh& mesh, const std::vector<int>& hexahedra)
{
  const Eigen::VectorXd values =
    ComputeScaledJacobians({ mesh.Points, mesh.Hexahedra(hexahedra, Eigen::all) });
  return static_cast<int>((values.array() <= 0.0).count());
}

/// Lowers the energy of a patch; undone if more hexahedra are inverted afterwards.
void Untangle(HexMesh& mesh, const std::vector<int>& hexahedra, const PointConstraint& constraint,
  const std::vector<char>& marked, int steps, const Progress& progress)
{
  const SimplexPatch patch = PatchOf(mesh, hexahedra, constraint, marked);
  constexpr std::size_t maximum = 20000;
  if (patch.FreePoints.empty() || patch.FreePoints.size() > maximum)
  {
    return;
  }
  const int before = CountInverted(mesh, hexahedra);
  const Eigen::MatrixXd kept = mesh.Points(patch.FreePoints, Eigen::all);
  PatchOptions options;
  options.MaximumSteps = steps;
  MinimizeEnergy(mesh.Points, patch, &constraint, options, progress);
  if (CountInverted(mesh, hexahedra) > before)
  {
    mesh.Points(patch.FreePoints, Eigen::all) = kept;
  }
}

} // namespace

// In each round the inverted hexahedra and some rings around them are split into connected patches,
// and the energy of Garanzha et al. 2021 is minimised in each. The next round takes more rings.
int UntangleHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, int steps, const Progress& progress)
{
  const std::vector<std::vector<int>> around = HexahedraAround(mesh);
  Eigen::VectorXd values = ComputeScaledJacobians(mesh);
  const auto inverted = [&] { return static_cast<int>((values.array() <= 0.0).count()); };
  int idle = 0; // rounds with little progress
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
    const double done = static_cast<double>(&rings - Rings) / std::size(Rings);
    const std::vector<std::vector<int>> pieces = Pieces(mesh, around, marked);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const double share = 1.0 / static_cast<double>(std::size(Rings) * pieces.size());
      const double begin = done + static_cast<double>(i) * share;
      Untangle(mesh, pieces[i], constraint, marked, steps, progress.Part(begin, begin + share));
    }
    values = ComputeScaledJacobians(mesh);
    // Less than a fifth of the inverted hexahedra repaired: little progress.
    constexpr double worthwhile = 0.8;
    idle = inverted() > worthwhile * before ? idle + 1 : 0;
    if (idle == MaximumIdleSteps)
    {
      break;
    }
  }
  progress(1.0);
  return inverted();
}

} // namespace shape
