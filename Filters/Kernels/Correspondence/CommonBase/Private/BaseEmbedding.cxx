#include "Correspondence/CommonBase/Private/BaseEmbedding.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"
#include "Parameterize/ConvexCombination.h"

#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

Eigen::RowVector2d OnGrid(const Eigen::RowVector2d& position)
{
  return (position / BaseGridStep).array().round() * BaseGridStep;
}

/// The share of a path's length at each of its points.
std::vector<double> SharesOf(const Mesh& surface, const std::vector<int>& path)
{
  std::vector<double> lengths{ 0.0 };
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    lengths.push_back(
      lengths.back() + (surface.Points.row(path[i]) - surface.Points.row(path[i - 1])).norm());
  }
  for (double& length : lengths)
  {
    length = std::round(length / lengths.back() / BaseGridStep) * BaseGridStep;
  }
  return lengths;
}

/// The half-edges between each pair of points.
std::map<std::pair<int, int>, int> SidesOfPaths(const PatchedSurface& surface)
{
  std::map<std::pair<int, int>, int> sides;
  for (const std::vector<int>& path : surface.Paths)
  {
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      sides[{ path[i - 1], path[i] }] = -1;
      sides[{ path[i], path[i - 1] }] = -1;
    }
  }
  const Eigen::MatrixXi& triangles = surface.Surface.Triangles;
  for (int side = 0; side < 3 * static_cast<int>(triangles.rows()); ++side)
  {
    const auto found =
      sides.find({ triangles(side / 3, side % 3), triangles(side / 3, (side + 1) % 3) });
    if (found != sides.end())
    {
      found->second = side;
    }
  }
  return sides;
}

class PatchEmbedding
{
public:
  PatchEmbedding(const BaseDomain& domain, const PatchedSurface& surface)
    : Domain(domain)
    , Patched(surface)
    , Sides(SidesOfPaths(surface))
  {
    for (const std::vector<int>& path : surface.Paths)
    {
      this->Shares.push_back(SharesOf(surface.Surface, path));
    }
    this->Number();
  }

  /// Maps one patch.
  void Embed(int patch, CombinationWeights weights, const Progress& progress)
  {
    std::vector<int> fixed;
    std::vector<Eigen::RowVector2d> places;
    const Eigen::Matrix<double, 3, 2> ends =
      (Eigen::Matrix<double, 3, 2>() << 0, 0, 1, 0, 0, 1).finished();
    for (int k = 0; k < 3; ++k)
    {
      const int side = this->Domain.Patches[patch][k];
      const std::vector<int>& path = this->Patched.Paths[side / 2];
      const std::vector<double>& shares = this->Shares[side / 2];
      const auto last = static_cast<int>(path.size()) - 1;
      for (int i = 0; i < last; ++i)
      {
        const bool isForward = side % 2 == 0;
        const int from = path[isForward ? i : last - i],
                  to = path[isForward ? i + 1 : last - i - 1];
        const double share = isForward ? shares[i] : 1.0 - shares[last - i];
        fixed.push_back(this->Result.RowOf(this->Sides.at({ from, to })));
        places.emplace_back(ends.row(k) + share * (ends.row((k + 1) % 3) - ends.row(k)));
      }
    }
    Eigen::MatrixXd positions(places.size(), 2);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      positions.row(static_cast<Eigen::Index>(i)) = places[i];
    }
    Mesh& flat = this->Result.Patches[patch];
    flat.Points.setZero(this->Solids[patch].Points.rows(), 3);
    const Eigen::MatrixXd plane =
      SolveConvexCombination(this->Solids[patch], weights, fixed, positions, progress);
    for (Eigen::Index i = 0; i < plane.rows(); ++i)
    {
      flat.Points.row(i).head<2>() = OnGrid(plane.row(i));
    }
  }

  std::size_t CountInverted(int patch) const
  {
    const Mesh& flat = this->Result.Patches[patch];
    return FindInvertedTriangles(flat.Triangles, flat.Points.leftCols(2)).size();
  }

  BaseEmbedding Result;

private:
  /// Numbers the points of each patch: corners are the same point if edges off the paths join them.
  void Number()
  {
    const Mesh& mesh = this->Patched.Surface;
    const std::vector<int> twins = FindTwins(mesh.Triangles, mesh.Points.rows());
    const auto sides = static_cast<int>(twins.size());
    std::vector<bool> isOnPath(sides, false);
    for (const auto& [ends, side] : this->Sides)
    {
      isOnPath[side] = true;
    }
    DisjointSets sets(sides);
    for (int side = 0; side < sides; ++side)
    {
      if (!isOnPath[side])
      {
        sets.Merge(side, NextHalfEdge(twins[side]));
        sets.Merge(NextHalfEdge(side), twins[side]);
      }
    }
    const std::size_t patches = this->Domain.Patches.size();
    this->Result.Patches.resize(patches);
    this->Result.Triangles.resize(patches);
    this->Result.RowOf = Eigen::VectorXi::Constant(sides, -1);
    std::vector<std::vector<int>> points(patches);
    Eigen::VectorXi rows = Eigen::VectorXi::Constant(sides, -1);
    for (int side = 0; side < sides; ++side)
    {
      const int patch = this->Patched.Patches(side / 3), set = sets.Find(side);
      if (rows(set) < 0)
      {
        rows(set) = static_cast<int>(points[patch].size());
        points[patch].push_back(mesh.Triangles(side / 3, side % 3));
      }
      this->Result.RowOf(side) = rows(set);
      if (side % 3 == 0)
      {
        this->Result.Triangles[patch].push_back(side / 3);
      }
    }
    for (std::size_t patch = 0; patch < patches; ++patch)
    {
      const std::vector<int>& triangles = this->Result.Triangles[patch];
      Eigen::MatrixXi corners(triangles.size(), 3);
      for (std::size_t t = 0; t < triangles.size(); ++t)
      {
        corners.row(static_cast<Eigen::Index>(t)) =
          this->Result.RowOf.segment<3>(3 * triangles[t]).transpose();
      }
      this->Result.Patches[patch].Triangles = corners;
      this->Solids.push_back({ mesh.Points(points[patch], Eigen::all), corners });
    }
  }

  const BaseDomain& Domain;
  const PatchedSurface& Patched;
  std::map<std::pair<int, int>, int> Sides;
  std::vector<std::vector<double>> Shares;
  std::vector<Mesh> Solids; ///< the patches in space
};

} // namespace

BaseEmbedding EmbedPatches(const BaseDomain& domain, const PatchedSurface& surface,
  const std::string& name, const Progress& progress)
{
  PatchEmbedding embedding(domain, surface);
  const auto patches = static_cast<int>(domain.Patches.size());
  for (int patch = 0; patch < patches; ++patch)
  {
    embedding.Embed(patch, CombinationWeights::MeanValue,
      progress.Part(static_cast<double>(patch) / patches, (patch + 1.0) / patches));
    const std::size_t inverted = embedding.CountInverted(patch);
    if (inverted > 0)
    {
      throw SolveFailure(name + ": " + std::to_string(inverted) + " triangles of patch " +
        std::to_string(patch) +
        " are too small for double precision; give a landmark at the end of each protrusion");
    }
  }
  return std::move(embedding.Result);
}

} // namespace shape
