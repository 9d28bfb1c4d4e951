#include "Skeleton/Private/GraphVariants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

using Path = std::vector<int>;

constexpr std::size_t MostCandidates = 6;
constexpr std::size_t MostOmitted = 3;
/// Junctions merge if the branch between them is shorter than this multiple of their radii.
constexpr double LargestOverlap = 2.0;
/// What a variant costs, in the units of the difference of two skeletons: for each change, for the
/// share of the length that is left out, and for the gap between two balls in parts of their radii.
constexpr double ChangeCost = 0.05;
constexpr double OmissionCost = 10.0;
constexpr double GapCost = 0.5;

/// A branch with an end.
struct Spur
{
  double Reach = 0.0; ///< its length beyond the ball around its junction, as a share of all lengths
  double Share = 0.0; ///< its length as such a share
  int Branch = 0;
};

double LengthOf(const CurveSkeleton& skeleton, const Path& branch)
{
  return MeasureAlong(skeleton, branch).tail<1>()(0);
}

/// Returns the branches between an end and a junction that may be left out, the least first.
std::vector<Spur> FindSpurs(const CurveSkeleton& skeleton, double largestOmission)
{
  double total = 0.0;
  for (const Path& branch : skeleton.Branches)
  {
    total += LengthOf(skeleton, branch);
  }
  std::vector<Spur> spurs;
  for (std::size_t i = 0; i < skeleton.Branches.size(); ++i)
  {
    int root = skeleton.Branches[i].front(), tip = skeleton.Branches[i].back();
    if (skeleton.Degrees(root) == 1)
    {
      std::swap(root, tip);
    }
    const double length = LengthOf(skeleton, skeleton.Branches[i]);
    if (skeleton.Degrees(tip) == 1 && skeleton.Degrees(root) > 2 &&
      length <= largestOmission * total)
    {
      const double reach = length + skeleton.Radii(tip) - skeleton.Radii(root);
      spurs.push_back({ std::max(reach, 0.0) / total, length / total, static_cast<int>(i) });
    }
  }
  std::sort(spurs.begin(), spurs.end(),
    [](const Spur& a, const Spur& b)
    { return std::pair(a.Reach, a.Branch) < std::pair(b.Reach, b.Branch); });
  spurs.resize(std::min(spurs.size(), MostCandidates));
  return spurs;
}

Path Joined(Path first, Path second, int at)
{
  if (first.back() != at)
  {
    std::reverse(first.begin(), first.end());
  }
  if (second.front() != at)
  {
    std::reverse(second.begin(), second.end());
  }
  first.insert(first.end(), second.begin() + 1, second.end());
  return first;
}

/// Joins the two branches at each point where a junction was.
void JoinBranches(GraphVariant& variant)
{
  std::vector<Path>& branches = variant.Skeleton.Branches;
  const auto endsAt = [](const Path& branch, int point)
  { return branch.front() == point || branch.back() == point; };
  for (std::size_t i = 0; i < branches.size(); ++i)
  {
    for (std::size_t j = i + 1; j < branches.size(); ++j)
    {
      for (const int point : { branches[i].front(), branches[i].back() })
      {
        if (variant.Skeleton.Degrees(point) == 2 && endsAt(branches[j], point))
        {
          branches[i] = Joined(branches[i], branches[j], point);
          branches.erase(branches.begin() + static_cast<std::ptrdiff_t>(j));
          variant.Numbers.erase(variant.Numbers.begin() + static_cast<std::ptrdiff_t>(j));
          j = i; // from the next branch on again
          break;
        }
      }
    }
  }
}

/// Removes the points that no branch has.
void RemoveUnusedPoints(GraphVariant& variant)
{
  CurveSkeleton& skeleton = variant.Skeleton;
  std::vector<int> number(skeleton.Points.rows(), -1);
  for (const Path& branch : skeleton.Branches)
  {
    for (const int point : branch)
    {
      number[point] = 0;
    }
  }
  int count = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    if (number[i] == 0)
    {
      skeleton.Points.row(count) = skeleton.Points.row(static_cast<Eigen::Index>(i)).eval();
      skeleton.Radii(count) = skeleton.Radii(static_cast<Eigen::Index>(i));
      skeleton.Degrees(count) = skeleton.Degrees(static_cast<Eigen::Index>(i));
      number[i] = count++;
      variant.Points.push_back(static_cast<int>(i));
    }
  }
  skeleton.Points.conservativeResize(count, 3);
  skeleton.Radii.conservativeResize(count);
  skeleton.Degrees.conservativeResize(count);
  for (Path& branch : skeleton.Branches)
  {
    std::transform(
      branch.begin(), branch.end(), branch.begin(), [&](int point) { return number[point]; });
  }
}

GraphVariant WithoutSpurs(const CurveSkeleton& skeleton, const std::vector<Spur>& omitted)
{
  GraphVariant variant{ skeleton, {}, {}, {}, {}, 0.0 };
  for (const Spur& spur : omitted)
  {
    variant.LeftOut.push_back(spur.Branch);
    variant.Cost += ChangeCost + OmissionCost * spur.Reach;
  }
  std::sort(variant.LeftOut.begin(), variant.LeftOut.end());
  variant.Skeleton.Branches.clear();
  for (int i = 0; i < static_cast<int>(skeleton.Branches.size()); ++i)
  {
    const Path& branch = skeleton.Branches[i];
    if (std::binary_search(variant.LeftOut.begin(), variant.LeftOut.end(), i))
    {
      --variant.Skeleton.Degrees(branch.front());
      --variant.Skeleton.Degrees(branch.back());
    }
    else
    {
      variant.Skeleton.Branches.push_back(branch);
      variant.Numbers.push_back(i);
    }
  }
  JoinBranches(variant);
  RemoveUnusedPoints(variant);
  return variant;
}

/// Returns the lengths of the branches between junctions, in parts of their radii, that exceed 1
/// and may be merged; ascending.
std::vector<double> FindOverlaps(const CurveSkeleton& skeleton)
{
  std::vector<double> overlaps;
  for (const Path& branch : skeleton.Branches)
  {
    const int a = branch.front(), b = branch.back();
    if (a != b && skeleton.Degrees(a) > 2 && skeleton.Degrees(b) > 2)
    {
      const double overlap = LengthOf(skeleton, branch) / (skeleton.Radii(a) + skeleton.Radii(b));
      if (overlap >= 1.0 && overlap < LargestOverlap)
      {
        overlaps.push_back(overlap);
      }
    }
  }
  std::sort(overlaps.begin(), overlaps.end());
  return overlaps;
}

/// Adds a variant with each number of merged junctions.
void AddMerged(GraphVariant variant, bool merge, std::vector<GraphVariant>& variants)
{
  variant.Graph = MakeBranchGraph(variant.Skeleton);
  variants.push_back(variant);
  for (const double overlap : merge ? FindOverlaps(variant.Skeleton) : std::vector<double>())
  {
    variant.Graph = MakeBranchGraph(variant.Skeleton, std::nextafter(overlap, INFINITY));
    variant.Cost += ChangeCost + GapCost * (overlap - 1.0);
    variants.push_back(variant);
  }
}

} // namespace

std::vector<GraphVariant> MakeVariants(const CurveSkeleton& skeleton, double largestOmission)
{
  const std::vector<Spur> spurs = FindSpurs(skeleton, largestOmission);
  std::vector<GraphVariant> variants;
  for (unsigned subset = 0; subset < 1U << spurs.size(); ++subset)
  {
    std::vector<Spur> omitted;
    double share = 0.0;
    for (std::size_t i = 0; i < spurs.size(); ++i)
    {
      if ((subset >> i & 1U) != 0)
      {
        omitted.push_back(spurs[i]);
        share += spurs[i].Share;
      }
    }
    if (omitted.size() <= MostOmitted && share <= largestOmission)
    {
      AddMerged(WithoutSpurs(skeleton, omitted), largestOmission > 0.0, variants);
    }
  }
  std::stable_sort(variants.begin(), variants.end(),
    [](const GraphVariant& a, const GraphVariant& b) { return a.Cost < b.Cost; });
  return variants;
}

} // namespace shape
