#include "Skeleton/Private/BranchGraph.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Path = std::vector<int>;

/// Directions point to a place on the branch that is this number of radii from the junction.
constexpr double DirectionRadii = 2.0;

/// Interpolates rows of values at a length along a branch.
Eigen::RowVectorXd Interpolate(
  const Eigen::MatrixXd& values, const Path& branch, const Eigen::VectorXd& along, double at)
{
  Eigen::Index piece = 1;
  while (piece + 1 < along.size() && along(piece) < at)
  {
    ++piece;
  }
  const double length = along(piece) - along(piece - 1);
  const double share = length > 0.0 ? std::clamp((at - along(piece - 1)) / length, 0.0, 1.0) : 0.0;
  return (1.0 - share) * values.row(branch[piece - 1]) + share * values.row(branch[piece]);
}

class GraphMaker
{
public:
  GraphMaker(const CurveSkeleton& skeleton, double overlap)
    : Skeleton(skeleton)
    , Overlap(overlap)
    , Merged(static_cast<int>(skeleton.Points.rows()))
    , Inner(skeleton.Branches.size(), false)
  {
    for (const Path& branch : skeleton.Branches)
    {
      this->Along.push_back(MeasureAlong(skeleton, branch));
    }
  }

  BranchGraph Make()
  {
    this->MergeJunctions();
    this->NumberNodes();
    double total = 0.0;
    for (std::size_t i = 0; i < this->Inner.size(); ++i)
    {
      total += this->Inner[i] ? 0.0 : this->LengthOf(i);
    }
    // Points alone are compared by their radii.
    total = total > 0.0 ? total : this->Skeleton.Radii.maxCoeff();
    for (std::size_t i = 0; i < this->Inner.size(); ++i)
    {
      if (!this->Inner[i])
      {
        this->AddBranch(static_cast<int>(i), total);
      }
    }
    this->FindDirections();
    return this->Graph;
  }

private:
  double LengthOf(std::size_t branch) const { return this->Along[branch].tail<1>()(0); }

  void MergeJunctions()
  {
    std::vector<std::pair<double, int>> close;
    for (std::size_t i = 0; i < this->Inner.size(); ++i)
    {
      const int a = this->Skeleton.Branches[i].front(), b = this->Skeleton.Branches[i].back();
      if (this->Skeleton.Degrees(a) > 2 && this->Skeleton.Degrees(b) > 2 &&
        this->LengthOf(i) < this->Overlap * (this->Skeleton.Radii(a) + this->Skeleton.Radii(b)))
      {
        close.emplace_back(this->LengthOf(i), static_cast<int>(i));
      }
    }
    std::sort(close.begin(), close.end());
    for (const auto& [length, i] : close)
    {
      const int a = this->Skeleton.Branches[i].front(), b = this->Skeleton.Branches[i].back();
      this->Inner[i] = this->Merged.Find(a) != this->Merged.Find(b);
      this->Merged.Merge(a, b);
    }
  }

  void NumberNodes()
  {
    std::map<int, int> numbers;
    this->Graph.NodeOf.assign(this->Skeleton.Points.rows(), -1);
    for (const Path& branch : this->Skeleton.Branches)
    {
      for (const int point : { branch.front(), branch.back() })
      {
        this->Graph.NodeOf[point] =
          numbers.emplace(this->Merged.Find(point), static_cast<int>(numbers.size())).first->second;
      }
    }
    this->Graph.Nodes.resize(numbers.size());
  }

  void AddBranch(int number, double total)
  {
    const Path& path = this->Skeleton.Branches[number];
    GraphBranch branch;
    branch.Number = number;
    const int begin = path.front(), end = path.back();
    branch.Type = path.size() == 1                         ? GraphBranch::Kind::Point
      : begin == end && this->Skeleton.Degrees(begin) == 2 ? GraphBranch::Kind::Cycle
                                                           : GraphBranch::Kind::Open;
    branch.Nodes = { this->Graph.NodeOf[begin], this->Graph.NodeOf[end] };
    branch.Length =
      (this->LengthOf(number) + this->Skeleton.Radii(begin) + this->Skeleton.Radii(end)) / total;
    for (int k = 0; k < RadiusSamples; ++k)
    {
      const double at = this->LengthOf(number) * k / (RadiusSamples - 1);
      branch.Radii[k] = path.size() == 1
        ? this->Skeleton.Radii(begin) / total
        : Interpolate(this->Skeleton.Radii, path, this->Along[number], at)(0) / total;
    }
    const int index = static_cast<int>(this->Graph.Branches.size());
    this->Graph.Branches.push_back(branch);
    for (int end = 0; end < 2; ++end)
    {
      this->Graph.Nodes[branch.Nodes[end]].Sides.push_back(2 * index + end);
    }
  }

  void FindDirections()
  {
    this->Graph.Directions = Eigen::MatrixXd::Zero(2 * this->Graph.Branches.size(), 3);
    for (const GraphNode& node : this->Graph.Nodes)
    {
      RowVector3d centre = RowVector3d::Zero();
      double radius = 0.0;
      for (const int side : node.Sides)
      {
        const int point = this->PointOf(side);
        centre += this->Skeleton.Points.row(point) / static_cast<double>(node.Sides.size());
        radius = std::max(radius, this->Skeleton.Radii(point));
      }
      for (const int side : node.Sides)
      {
        const int number = this->Graph.Branches[side / 2].Number;
        const double length = this->LengthOf(number);
        const double way = std::min(0.5 * length, DirectionRadii * radius);
        if (this->Skeleton.Branches[number].size() > 1)
        {
          const RowVector3d place = Interpolate(this->Skeleton.Points,
            this->Skeleton.Branches[number], this->Along[number], side % 2 ? length - way : way);
          this->Graph.Directions.row(side) = (place - centre).normalized();
        }
      }
    }
  }

  int PointOf(int side) const
  {
    const Path& path = this->Skeleton.Branches[this->Graph.Branches[side / 2].Number];
    return side % 2 ? path.back() : path.front();
  }

  const CurveSkeleton& Skeleton;
  double Overlap;
  DisjointSets Merged;
  std::vector<bool> Inner; ///< whether a branch is within a node
  std::vector<Eigen::VectorXd> Along;
  BranchGraph Graph;
};

} // namespace

Eigen::VectorXd MeasureAlong(const CurveSkeleton& skeleton, const std::vector<int>& branch)
{
  Eigen::VectorXd along = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(branch.size()));
  for (Eigen::Index i = 1; i < along.size(); ++i)
  {
    along(i) =
      along(i - 1) + (skeleton.Points.row(branch[i]) - skeleton.Points.row(branch[i - 1])).norm();
  }
  return along;
}

BranchGraph MakeBranchGraph(const CurveSkeleton& skeleton, double overlap)
{
  return GraphMaker(skeleton, overlap).Make();
}

} // namespace shape
