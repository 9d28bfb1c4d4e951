#include "Base/Errors.h"
#include "Geometry/FeatureCurves.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

/// A quarter of a circle, at `count` places that are not even.
shape::Curve Arc(double radius, int count)
{
  shape::Curve curve(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double share = static_cast<double>(i) / (count - 1);
    const double angle = 0.5 * M_PI * share * share;
    curve.row(i) << radius * std::cos(angle), radius * std::sin(angle), 1.0;
  }
  return curve;
}

} // namespace

TEST(FeatureCurves, PointsGoToTheSameShareOfTheLength)
{
  // Angles are shares of an arc: a circle of another radius, sampled otherwise, keeps them.
  const auto matched = shape::MatchCurves({ Arc(1.0, 400) }, { Arc(3.0, 700) }, 1.0, "the feature");
  ASSERT_EQ(matched.Points.rows(), 400);
  for (Eigen::Index i = 0; i < matched.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = matched.Points.row(i), q = matched.Targets.row(i);
    EXPECT_NEAR(std::atan2(p(1), p(0)), std::atan2(q(1), q(0)), 1e-5);
    EXPECT_NEAR(q.head<2>().norm(), 3.0, 1e-4);
  }
}

TEST(FeatureCurves, LongStepsAreDividedEvenlyAndSayWhereTheyLie)
{
  shape::Curve line(3, 3), target(2, 3);
  line << 0, 0, 0, 1, 0, 0, 1.5, 0, 0;
  target << 0, 0, 0, 0, 3, 0;
  const auto matched =
    shape::MatchCurves({ target, line }, { target, target }, 0.25, "the feature");
  ASSERT_EQ(matched.Points.rows(), 13 + 7);
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_EQ(matched.Curves(13 + i), 1);
    EXPECT_NEAR(matched.Points(13 + i, 0), 0.25 * i, 1e-15);
    EXPECT_NEAR(matched.Targets(13 + i, 1), 0.5 * i, 1e-14);
    EXPECT_NEAR(matched.Positions(13 + i), i < 4 ? 0.25 * i : 1.0 + 0.5 * (i - 4), 1e-15);
  }
}

TEST(FeatureCurves, AClosedCurveHasEachPointOnce)
{
  shape::Curve loop(5, 3);
  loop << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0;
  const auto matched = shape::MatchCurves({ loop }, { 2.0 * loop }, 10.0, "the feature");
  ASSERT_EQ(matched.Points.rows(), 4);
  EXPECT_LT((matched.Targets - 2.0 * matched.Points).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(FeatureCurves, RefusesWhatCannotBePaired)
{
  using Curves = std::vector<shape::Curve>;
  const auto match = [](const Curves& sources, const Curves& targets)
  { return shape::MatchCurves(sources, targets, 1.0, "feature 2"); };
  const shape::Curve arc = Arc(1.0, 9);
  EXPECT_REFUSED(match({ arc, arc }, { arc }), "feature 2 has 2 curves and its target has 1");
  EXPECT_REFUSED(match({ arc }, { shape::Curve::Ones(4, 3) }),
    "curve 0 of the target of feature 2 has no length");
  shape::Curve broken = arc;
  broken(3, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(match({ broken }, { arc }), "curve 0 of feature 2");
  const shape::Curve large = 1e12 * arc;
  EXPECT_REFUSED(match({ arc, large }, { arc, arc }),
    "curve 1 of feature 2 is far longer than the shape it belongs to");
  EXPECT_NO_THROW(match({ arc }, { large }));
}
