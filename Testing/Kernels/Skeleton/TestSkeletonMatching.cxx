#include "Skeleton/SkeletonMatching.h"

#include "Skeleton/Skeleton.h"
#include "Support/LimbShapes.h"
#include "Support/Refusals.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace
{

using Eigen::RowVector3d;
using shape::CurveSkeleton;
using shape::SkeletonMatchingOptions;

/// A skeleton whose branches run from `centre`, as polylines of 11 points; radii fall from 0.2 by
/// `taper` towards the ends.
CurveSkeleton Spider(const std::vector<RowVector3d>& ends, double taper = 0.0)
{
  CurveSkeleton skeleton;
  const int count = static_cast<int>(ends.size());
  skeleton.Points = Eigen::MatrixXd::Zero(1 + 10 * count, 3);
  skeleton.Radii = Eigen::VectorXd::Constant(1 + 10 * count, 0.2);
  skeleton.Degrees = Eigen::VectorXi::Constant(1 + 10 * count, 2);
  skeleton.Degrees(0) = count;
  for (int i = 0; i < count; ++i)
  {
    std::vector<int> branch = { 0 };
    for (int k = 1; k <= 10; ++k)
    {
      const int point = 10 * i + k;
      skeleton.Points.row(point) = 0.1 * k * ends[i];
      skeleton.Radii(point) -= 0.01 * k * taper;
      branch.push_back(point);
    }
    skeleton.Degrees(branch.back()) = 1;
    skeleton.Branches.push_back(branch);
  }
  skeleton.Components = 1;
  return skeleton;
}

/// The same skeleton with its branches in another order, each reversed.
CurveSkeleton Renumbered(CurveSkeleton skeleton)
{
  std::reverse(skeleton.Branches.begin(), skeleton.Branches.end());
  for (std::vector<int>& branch : skeleton.Branches)
  {
    std::reverse(branch.begin(), branch.end());
  }
  return skeleton;
}

} // namespace

TEST(SkeletonMatching, FindsTheBranchesOfARenumberedCopy)
{
  const CurveSkeleton spider = Spider({ { 2, 0, 0 }, { 0, 3, 0 }, { -4, 0, 1 } });
  const shape::SkeletonMatching matching = shape::MatchSkeletons(spider, Renumbered(spider));
  EXPECT_EQ(matching.Branches, (std::vector<int>{ 2, 1, 0 }));
  EXPECT_EQ(matching.Reversed, (std::vector<bool>{ true, true, true }));
  EXPECT_NEAR(matching.Difference, 0.0, 1e-12);
  EXPECT_LT((matching.TargetPositions - spider.Points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SkeletonMatching, DoesNotDependOnScaleAndPlace)
{
  const CurveSkeleton spider = Spider({ { 2, 0, 0 }, { 0, 3, 0 }, { -4, 0, 1 } });
  CurveSkeleton moved = Renumbered(spider);
  moved.Points = (50.0 * moved.Points).rowwise() + RowVector3d(1, 2, 3);
  moved.Radii *= 50.0;
  const shape::SkeletonMatching matching = shape::MatchSkeletons(spider, moved);
  EXPECT_EQ(matching.Branches, (std::vector<int>{ 2, 1, 0 }));
  EXPECT_LT((matching.TargetPositions - moved.Points).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(SkeletonMatching, RefusesASymmetricStarAndNamesItsBranches)
{
  const CurveSkeleton star = Spider({ { 2, 0, 0 }, { -1, 1.7321, 0 }, { -1, -1.7321, 0 } });
  EXPECT_REFUSED(shape::MatchSkeletons(star, star), "ambiguous", "0, 1 and 2", "Ambiguous");
  SkeletonMatchingOptions options;
  options.Ambiguous = SkeletonMatchingOptions::AmbiguityType::First;
  const shape::SkeletonMatching first = shape::MatchSkeletons(star, star, options);
  EXPECT_EQ(first.Branches, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(first.Ambiguous, (std::vector<int>{ 0, 1, 2 }));
}

TEST(SkeletonMatching, NamesOnlyTheBranchesThatCanBeExchanged)
{
  const CurveSkeleton spider = Spider({ { 2, 0, 0 }, { 0, 4, 0 }, { -2, 0, 0.1 } });
  EXPECT_REFUSED(shape::MatchSkeletons(spider, spider), "branches 0 and 2 of");
}

TEST(SkeletonMatching, RadiiTellTheEndsOfABranch)
{
  CurveSkeleton cone = Spider({ { 4, 0, 0 } }, 1.0);
  cone.Degrees(0) = 1;
  const shape::SkeletonMatching matching = shape::MatchSkeletons(cone, Renumbered(cone));
  EXPECT_TRUE(matching.Reversed[0]);
  CurveSkeleton cylinder = Spider({ { 4, 0, 0 } });
  cylinder.Degrees(0) = 1;
  EXPECT_REFUSED(shape::MatchSkeletons(cylinder, cylinder), "branches 0 of");
}

TEST(SkeletonMatching, TellsLeftFromRightWhereBranchesTurn)
{
  // Neck, spine and two equal legs far from one plane: only the sense of turning tells which is
  // which.
  const RowVector3d neck(3, 0, 0), spine(-5, 0, 0), left(0, 1.5, -1.5), right(0, -1.5, -1.5);
  const CurveSkeleton a = Spider({ neck, spine, left, right }),
                      b = Spider({ right, neck, left, spine });
  EXPECT_EQ(shape::MatchSkeletons(a, b).Branches, (std::vector<int>{ 1, 3, 2, 0 }));
  // The mirror image has left and right exchanged.
  CurveSkeleton mirrored = b;
  mirrored.Points.col(1) *= -1.0;
  EXPECT_EQ(shape::MatchSkeletons(a, mirrored).Branches, (std::vector<int>{ 1, 3, 0, 2 }));
}

TEST(SkeletonMatching, LeavesOutAShortBranchThatOneSkeletonHas)
{
  const std::vector<RowVector3d> ends = { { 2, 0, 0 }, { 0, 3, 0 }, { -4, 0, 1 } };
  std::vector<RowVector3d> more = ends;
  more.emplace_back(0, 0, 0.6);
  const CurveSkeleton three = Spider(ends), four = Spider(more);
  const shape::SkeletonMatching matching = shape::MatchSkeletons(four, three);
  EXPECT_EQ(matching.LeftOut, (std::vector<int>{ 3 }));
  EXPECT_EQ(matching.Branches, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(matching.Skeleton.Points.rows(), three.Points.rows());
  EXPECT_LT((matching.TargetPositions - three.Points).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(shape::MatchSkeletons(three, four).TargetLeftOut, (std::vector<int>{ 3 }));
  SkeletonMatchingOptions options;
  options.LargestOmission = 0.0;
  EXPECT_REFUSED(shape::MatchSkeletons(four, three, options), "different graphs", "4 branch");
}

TEST(SkeletonMatching, JoinsTheBranchesWhereOneIsLeftOut)
{
  // A line of 10 with radii that fall, and a short branch in its middle.
  CurveSkeleton cross = Spider({ { 4, 0, 0 }, { -6, 0, 0 }, { 0, 0.5, 0 } });
  CurveSkeleton line = Spider({ { 10, 0, 0 } });
  line.Degrees(0) = 1;
  line.Points.col(0).array() -= 6.0;
  for (CurveSkeleton* skeleton : { &cross, &line })
  {
    skeleton->Radii = 0.3 + 0.02 * skeleton->Points.col(0).array();
  }
  const shape::SkeletonMatching matching = shape::MatchSkeletons(cross, line);
  EXPECT_EQ(matching.LeftOut, (std::vector<int>{ 2 }));
  EXPECT_EQ(matching.Skeleton.Branches.size(), 1U);
  EXPECT_EQ(matching.Skeleton.Points.rows(), 21);
  EXPECT_EQ(matching.Skeleton.Degrees.maxCoeff(), 2);
  EXPECT_LT((matching.TargetPositions - matching.Skeleton.Points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SkeletonMatching, NumbersAndDirectionsDoNotMatter)
{
  const CurveSkeleton bent = shape::ExtractCurveSkeleton(shapetest::Hand(0.9, 0.05)),
                      flat = shape::ExtractCurveSkeleton(shapetest::Hand(0.0, 0.05));
  const shape::SkeletonMatching matching = shape::MatchSkeletons(flat, bent),
                                other = shape::MatchSkeletons(Renumbered(flat), Renumbered(bent));
  ASSERT_EQ(matching.TargetPositions.rows(), other.TargetPositions.rows());
  EXPECT_LT((matching.TargetPositions - other.TargetPositions).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_NEAR(matching.Difference, other.Difference, 1e-10);
}

TEST(SkeletonMatching, RefusesOtherGraphsAndOtherProportions)
{
  const CurveSkeleton three = Spider({ { 2, 0, 0 }, { 0, 3, 0 }, { -4, 0, 1 } }),
                      four = Spider({ { 2, 0, 0 }, { 0, 3, 0 }, { -4, 0, 1 }, { 0, -5, 0 } }),
                      other = Spider({ { 2, 0, 0 }, { 0, 3, 0 }, { -40, 0, 1 } });
  EXPECT_REFUSED(shape::MatchSkeletons(three, four), "different graphs", "3 branch", "4 branch");
  EXPECT_REFUSED(shape::MatchSkeletons(three, other), "differ by", "choose another target");
  SkeletonMatchingOptions options;
  options.Tolerance = 0.0;
  EXPECT_REFUSED(shape::MatchSkeletons(three, three, options), "Tolerance is 0");
}

TEST(SkeletonMatching, FindsTheFingersOfABentHand)
{
  const CurveSkeleton flat = shape::ExtractCurveSkeleton(shapetest::Hand(0.0, 0.04)),
                      bent = shape::ExtractCurveSkeleton(shapetest::Hand(0.9, 0.04));
  const shape::SkeletonMatching matching = shape::MatchSkeletons(flat, bent);
  // The tips of a finger have the same direction from the wrist in the plane z = 0.
  const double angles[] = { 2.7, 2.1, 1.6, 1.1, 0.5 };
  const auto finger = [&](const RowVector3d& tip)
  {
    const double angle = std::atan2(tip(1), tip(0));
    return std::min_element(std::begin(angles), std::end(angles),
             [&](double a, double b) { return std::abs(a - angle) < std::abs(b - angle); }) -
      std::begin(angles);
  };
  int tips = 0;
  for (Eigen::Index p = 0; p < flat.Points.rows(); ++p)
  {
    if (flat.Degrees(p) == 1 && flat.Points(p, 1) > 0.0)
    {
      EXPECT_EQ(finger(flat.Points.row(p)), finger(matching.TargetPositions.row(p)));
      ++tips;
    }
  }
  EXPECT_EQ(tips, 5);
}
