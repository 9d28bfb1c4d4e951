#include "Parameterize/FlipRepair.h"

#include "Base/DisjointSets.h"
#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"
#include "Parameterize/ConvexCombination.h"

#include <algorithm>

namespace shape
{
namespace
{

constexpr int Rounds = 6;
/// a triangle has no area below this share of its longest squared edge
constexpr double Flat = 1e-14;

/// Returns the triangles that are neither left out nor without area.
std::vector<int> Counted(const Mesh& surface, const std::vector<int>& leftOut)
{
  const Eigen::VectorXd areas = ComputeAreaVectors(surface).rowwise().norm();
  std::vector<char> out(surface.Triangles.rows(), 0);
  for (const int triangle : leftOut)
  {
    out[triangle] = 1;
  }
  std::vector<int> counted;
  for (int t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(surface, t);
    const double longest2 = std::max({ (corners.row(1) - corners.row(0)).squaredNorm(),
      (corners.row(2) - corners.row(1)).squaredNorm(),
      (corners.row(0) - corners.row(2)).squaredNorm() });
    if (!out[t] && areas(t) > Flat * longest2)
    {
      counted.push_back(t);
    }
  }
  return counted;
}

/// Marks points on the boundary, or on an edge with more than two triangles.
std::vector<char> OnLoop(const Eigen::MatrixXi& triangles, Eigen::Index points)
{
  std::vector<char> onLoop(points, 0);
  const std::vector<HalfEdge> sides = SortHalfEdges(triangles, points);
  // Half-edges of one edge follow each other in the sorted list.
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].Low() == sides[begin].Low() &&
      sides[end].High() == sides[begin].High())
    {
      ++end;
    }
    if (end - begin != 2)
    {
      onLoop[sides[begin].Low()] = onLoop[sides[begin].High()] = 1;
    }
  }
  return onLoop;
}

class Mending
{
public:
  Mending(const Mesh& surface, Eigen::MatrixXd& positions, const std::vector<int>& leftOut)
    : Surface(surface)
    , Positions(positions)
    , Triangles(surface.Triangles(Counted(surface, leftOut), Eigen::all))
    , Loop(OnLoop(this->Triangles, surface.Points.rows()))
  {
  }

  std::vector<int> Flipped(const Eigen::MatrixXd& positions) const
  {
    std::vector<int> flipped;
    for (int t = 0; t < this->Triangles.rows(); ++t)
    {
      if (!this->Faces(t, positions))
      {
        flipped.push_back(t);
      }
    }
    return flipped;
  }

  /// Moves the points of the flipped triangles and of `rings` rings of neighbours.
  void Round(const std::vector<int>& flipped, int rings)
  {
    std::vector<char> isFree(this->Surface.Points.rows(), 0);
    for (const int triangle : flipped)
    {
      for (const int point : this->Triangles.row(triangle))
      {
        isFree[point] = 1;
      }
    }
    for (int ring = 0; ring < rings; ++ring)
    {
      std::vector<char> grown = isFree;
      for (const auto& triangle : this->Triangles.rowwise())
      {
        if (isFree[triangle(0)] || isFree[triangle(1)] || isFree[triangle(2)])
        {
          grown[triangle(0)] = grown[triangle(1)] = grown[triangle(2)] = 1;
        }
      }
      isFree.swap(grown);
    }
    for (std::size_t i = 0; i < isFree.size(); ++i)
    {
      isFree[i] = isFree[i] && !this->Loop[i];
    }
    this->Move(isFree);
  }

private:
  bool Faces(Eigen::Index triangle, const Eigen::MatrixXd& positions) const
  {
    return EvaluateOrientation(positions.row(this->Triangles(triangle, 0)),
             positions.row(this->Triangles(triangle, 1)),
             positions.row(this->Triangles(triangle, 2))) > 0;
  }

  void Move(const std::vector<char>& isFree)
  {
    // The triangles around the free points, with compact point numbers.
    std::vector<int> around, used, own(isFree.size(), -1), fixed;
    DisjointSets groups(static_cast<int>(isFree.size()));
    for (int t = 0; t < this->Triangles.rows(); ++t)
    {
      int first = -1;
      for (const int point : this->Triangles.row(t))
      {
        if (isFree[point])
        {
          first = first < 0 ? point : first;
          groups.Merge(point, first);
        }
      }
      if (first < 0)
      {
        continue;
      }
      around.push_back(t);
      for (const int point : this->Triangles.row(t))
      {
        if (own[point] < 0)
        {
          own[point] = static_cast<int>(used.size());
          used.push_back(point);
          if (!isFree[point])
          {
            fixed.push_back(point);
          }
        }
      }
    }
    if (around.empty() || fixed.empty())
    {
      return;
    }
    // Free points become mean value combinations of their neighbours. The other points of the part
    // are fixed.
    const Mesh part{ this->Surface.Points(used, Eigen::all),
      this->Triangles(around, Eigen::all).unaryExpr([&](int point) { return own[point]; }) };
    std::vector<int> ownFixed;
    for (const int point : fixed)
    {
      ownFixed.push_back(own[point]);
    }
    const Eigen::MatrixXd solved = SolveConvexCombination(
      part, CombinationWeights::MeanValue, ownFixed, this->Positions(fixed, Eigen::all));
    Eigen::MatrixXd moved = this->Positions;
    moved(used, Eigen::all) = solved;
    // Groups of connected free points move independently: if one fails, the others still move.
    std::vector<char> fails(isFree.size(), 0);
    for (const int t : around)
    {
      if (!this->Faces(t, moved))
      {
        for (const int point : this->Triangles.row(t))
        {
          fails[groups.Find(point)] = 1;
        }
      }
    }
    for (const int point : used)
    {
      if (isFree[point] && !fails[groups.Find(point)])
      {
        this->Positions.row(point) = moved.row(point);
      }
    }
  }

  const Mesh& Surface;
  Eigen::MatrixXd& Positions;
  Eigen::MatrixXi Triangles; ///< the counted triangles
  std::vector<char> Loop;    ///< n: whether a point is fixed
};

} // namespace

int RepairFlips(const Mesh& surface, Eigen::MatrixXd& positions, const std::vector<int>& leftOut,
  const Progress& progress)
{
  Mending mending(surface, positions, leftOut);
  std::vector<int> flipped = mending.Flipped(positions);
  const auto before = static_cast<int>(flipped.size());
  for (int round = 0; round < Rounds && !flipped.empty(); ++round)
  {
    progress(static_cast<double>(round) / Rounds);
    // Round r frees the points of flipped triangles and r rings around them.
    mending.Round(flipped, round);
    flipped = mending.Flipped(positions);
  }
  progress(1.0);
  return before - static_cast<int>(flipped.size());
}

} // namespace shape
