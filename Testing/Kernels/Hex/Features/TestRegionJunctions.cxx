#include "Hex/Features/Private/RegionJunctions.h"

#include <gtest/gtest.h>

namespace
{

/// A network of straight curves between points on the x axis.
struct Line
{
  shape::RegionNetwork Network;
  Eigen::MatrixXd Points = Eigen::MatrixXd::Zero(4, 3);

  void AddCorner(double x, const std::vector<int>& labels)
  {
    const auto corner = static_cast<int>(this->Network.Corners.size());
    this->Points(corner, 0) = x;
    this->Network.Corners.push_back(corner);
    this->Network.CornerLabels.push_back(labels);
  }

  void AddCurve(int first, int second, const std::vector<int>& labels)
  {
    this->Network.Curves.push_back({ { first, second }, false, labels });
  }
};

/// Two corners with the same labels, a quarter apart: two regions meet twice.
Line Lens()
{
  Line line;
  line.AddCorner(0.0, { 1, 2, 4, 5 });
  line.AddCorner(0.25, { 1, 2, 4, 5 });
  line.AddCorner(9.0, { 0, 1, 2, 4 });
  line.AddCurve(0, 1, { 1, 4, 5 });
  line.AddCurve(0, 1, { 2, 4, 5 });
  line.AddCurve(1, 2, { 1, 2, 4 });
  return line;
}

/// Three corners at the ends of short curves of a point where five regions meet.
Line Fan()
{
  Line line;
  line.AddCorner(0.0, { 0, 1, 2, 3 });
  line.AddCorner(1.0, { 1, 2, 3, 4 });
  line.AddCorner(2.0, { 0, 1, 2, 4 });
  line.AddCurve(0, 1, { 1, 2, 3 });
  line.AddCurve(1, 2, { 1, 2, 4 });
  return line;
}

} // namespace

TEST(RegionJunctions, CornersOfASmallLensAreOneJunction)
{
  const Line lens = Lens();
  const shape::RegionJunctions one(lens.Network, lens.Points, 1.0);
  EXPECT_EQ(one.Corners, (std::vector<std::vector<int>>{ { 0, 1 }, { 2 } }));
  EXPECT_EQ(one.Labels, (std::vector<std::vector<int>>{ { 1, 2, 4, 5 }, { 0, 1, 2, 4 } }));
  EXPECT_EQ(one.IsInside, (std::vector<char>{ 1, 1, 0 }));
  EXPECT_EQ(one.Middles(0, 0), 0.125);
  const shape::RegionJunctions two(lens.Network, lens.Points, 0.2);
  EXPECT_EQ(two.Corners.size(), 3U);
  EXPECT_EQ(two.IsInside, (std::vector<char>{ 0, 0, 0 }));
}

TEST(RegionJunctions, CurvesOfFourRegionsAreInsideHoweverLong)
{
  Line line;
  line.AddCorner(0.0, { 0, 1, 2, 3, 4 });
  line.AddCorner(9.0, { 0, 1, 2, 3, 5 });
  line.AddCurve(0, 1, { 0, 1, 2, 3 });
  const shape::RegionJunctions junctions(line.Network, line.Points, 1.0);
  EXPECT_EQ(junctions.Labels, (std::vector<std::vector<int>>{ { 0, 1, 2, 3, 4, 5 } }));
}

TEST(RegionJunctions, OneJunctionGetsTheClosestOfTheSurfaces)
{
  Line own, wanted;
  own.AddCorner(1.0, { 0, 1, 2, 3 });
  wanted.AddCorner(9.0, { 0, 1, 2, 3 });
  wanted.AddCorner(2.0, { 0, 1, 2, 3 });
  wanted.AddCorner(1.0, { 0, 1, 2, 4 });
  const shape::JunctionMatch match =
    shape::MatchJunctions(own.Network, own.Points, wanted.Network, wanted.Points, 1.0);
  EXPECT_EQ(match.WantedOf, (std::map<int, int>{ { 0, 1 } }));
}

TEST(RegionJunctions, CornersWithoutAPartnerAreJoined)
{
  const Line own = Fan();
  Line wanted;
  wanted.AddCorner(1.0, { 0, 1, 2, 3, 4 });
  const shape::JunctionMatch match =
    shape::MatchJunctions(own.Network, own.Points, wanted.Network, wanted.Points, 1.0);
  EXPECT_EQ(match.WantedOf, (std::map<int, int>{ { 0, 0 } }));
  EXPECT_EQ(match.Own.Corners, (std::vector<std::vector<int>>{ { 0, 1, 2 } }));
  // In cells of a tenth of the size the curves are long.
  const shape::JunctionMatch none =
    shape::MatchJunctions(own.Network, own.Points, wanted.Network, wanted.Points, 0.1);
  EXPECT_TRUE(none.WantedOf.empty());
  EXPECT_EQ(none.Own.Corners.size(), 3U);
}

TEST(RegionJunctions, CornersWithAPartnerAreNotJoined)
{
  const Line own = Fan();
  const shape::JunctionMatch match =
    shape::MatchJunctions(own.Network, own.Points, own.Network, own.Points, 1.0);
  EXPECT_EQ(match.WantedOf, (std::map<int, int>{ { 0, 0 }, { 1, 1 }, { 2, 2 } }));
}
