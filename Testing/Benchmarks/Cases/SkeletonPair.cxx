// The curve skeletons of two models, matched.
#include "Cases/ModelFile.h"
#include "Driver/Case.h"
#include "Driver/Cost.h"

#include "Base/Errors.h"
#include "Skeleton/Skeleton.h"
#include "Skeleton/SkeletonMatching.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage =
  R"(MODEL TARGET [renumberings=10] [Tolerance=] [LargestDifference=] [LargestOmission=]

Extracts the curve skeletons of two closed surfaces and matches them by the kernel. Then matches them
again with the branches of both in other orders, half of them reversed, and their points renumbered.

Figures: outcome (matched, or the kernel's reason for refusing), branches of both, leftout (branches of
both), difference, changed (renumberings with another outcome), outside (points outside the surfaces),
ends and to (x, y, z of each end that is matched and of its place on the target's skeleton, the first of
equally good ones), sure (for each of them, 0 if it is ambiguous), targetends, cost. Positions are those
of models with the longest side 1 around the origin.)";

using shape::CurveSkeleton;
using shape::SkeletonMatching;

/// A skeleton with other numbers of points and branches, half of which are reversed.
CurveSkeleton Renumber(const CurveSkeleton& skeleton, std::mt19937& generator)
{
  CurveSkeleton result = skeleton;
  std::vector<int> after(skeleton.Points.rows());
  std::iota(after.begin(), after.end(), 0);
  std::shuffle(after.begin(), after.end(), generator);
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    const auto before = static_cast<Eigen::Index>(i);
    result.Points.row(after[i]) = skeleton.Points.row(before);
    result.Radii(after[i]) = skeleton.Radii(before);
    result.Degrees(after[i]) = skeleton.Degrees(before);
  }
  std::shuffle(result.Branches.begin(), result.Branches.end(), generator);
  for (std::vector<int>& branch : result.Branches)
  {
    std::transform(
      branch.begin(), branch.end(), branch.begin(), [&](int point) { return after[point]; });
    if (generator() % 2 == 1)
    {
      std::reverse(branch.begin(), branch.end());
    }
  }
  return result;
}

/// A matching, or the words up to the first number of the reason why there is none: what follows
/// names branches.
struct Outcome
{
  std::string Reason;
  SkeletonMatching Matching;
};

Outcome Match(const CurveSkeleton& skeleton, const CurveSkeleton& target,
  const shape::SkeletonMatchingOptions& options)
{
  try
  {
    return { "matched", shape::MatchSkeletons(skeleton, target, options) };
  }
  catch (const shape::InvalidInput& error)
  {
    return { error.what(), {} };
  }
}

std::string WithoutNumbers(const std::string& reason)
{
  return reason.substr(0, reason.find_first_of("0123456789"));
}

/// Whether both have the same outcome and take each point to the same place. Points are the same if
/// their positions are.
bool IsSame(const Outcome& first, const Outcome& other)
{
  const Eigen::MatrixXd &points = first.Matching.Skeleton.Points,
                        &others = other.Matching.Skeleton.Points;
  if (WithoutNumbers(first.Reason) != WithoutNumbers(other.Reason) ||
    points.rows() != others.rows())
  {
    return false;
  }
  double largest = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    Eigen::Index same = 0;
    const double gap = (others.rowwise() - points.row(i)).rowwise().norm().minCoeff(&same);
    largest = std::max({ largest, gap,
      (other.Matching.TargetPositions.row(same) - first.Matching.TargetPositions.row(i)).norm() });
  }
  return largest < 1e-9;
}

/// For each end, 1 if its branch is not ambiguous, otherwise 0.
std::vector<double> FindSureEnds(const SkeletonMatching& matching)
{
  std::vector<bool> sure(matching.Skeleton.Points.rows(), false);
  for (std::size_t i = 0; i < matching.Skeleton.Branches.size(); ++i)
  {
    for (const int point : matching.Skeleton.Branches[i])
    {
      sure[point] = std::find(matching.Ambiguous.begin(), matching.Ambiguous.end(),
                      matching.Numbers[i]) == matching.Ambiguous.end();
    }
  }
  std::vector<double> ends;
  for (std::size_t p = 0; p < sure.size(); ++p)
  {
    if (matching.Skeleton.Degrees(static_cast<Eigen::Index>(p)) == 1)
    {
      ends.push_back(sure[p] ? 1.0 : 0.0);
    }
  }
  return ends;
}

std::vector<double> Ends(const CurveSkeleton& skeleton, const Eigen::MatrixXd& places)
{
  std::vector<double> numbers;
  for (Eigen::Index i = 0; i < places.rows(); ++i)
  {
    if (skeleton.Degrees(i) == 1)
    {
      numbers.insert(numbers.end(), { places(i, 0), places(i, 1), places(i, 2) });
    }
  }
  return numbers;
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const shape::Surface model = benchmark::ReadModel(arguments.NextWord());
  const shape::Surface target = benchmark::ReadModel(arguments.NextWord());
  const int count = arguments.Setting("renumberings", 10);
  shape::SkeletonMatchingOptions options;
  options.Tolerance = arguments.Setting("Tolerance", options.Tolerance);
  options.LargestDifference = arguments.Setting("LargestDifference", options.LargestDifference);
  options.LargestOmission = arguments.Setting("LargestOmission", options.LargestOmission);
  arguments.RequireAllRead();
  CurveSkeleton own, other;
  Outcome outcome;
  const benchmark::Cost cost = benchmark::Measure(
    [&]()
    {
      own = shape::ExtractCurveSkeleton(model);
      other = shape::ExtractCurveSkeleton(target);
      outcome = Match(own, other, options);
    });
  options.Ambiguous = shape::SkeletonMatchingOptions::AmbiguityType::First;
  const SkeletonMatching first = Match(own, other, options).Matching;
  options.Ambiguous = shape::SkeletonMatchingOptions::AmbiguityType::Refuse;
  std::mt19937 generator(1);
  int changed = 0;
  for (int i = 0; i < count; ++i)
  {
    const CurveSkeleton a = Renumber(own, generator), b = Renumber(other, generator);
    changed += !IsSame(outcome, Match(a, b, options));
  }
  figures.Print(benchmark::Row()
                  .Add("outcome", outcome.Reason)
                  .Add("branches", own.Branches.size())
                  .Add("targetbranches", other.Branches.size())
                  .Add("leftout", first.LeftOut.size() + first.TargetLeftOut.size())
                  .Add("difference", first.Difference)
                  .Add("changed", changed)
                  .Add("outside", own.OutsidePoints + other.OutsidePoints)
                  .Add("ends", Ends(first.Skeleton, first.Skeleton.Points))
                  .Add("sure", FindSureEnds(first))
                  .Add("to", Ends(first.Skeleton, first.TargetPositions))
                  .Add("targetends", Ends(other, other.Points))
                  .Add(cost));
}

const benchmark::Entry SkeletonPair("skeleton_pair", { Usage, Run });

} // namespace
