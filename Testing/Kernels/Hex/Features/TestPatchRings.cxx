#include "Hex/Features/PatchRings.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace
{

/// A torus of n x n quads; that of column i and row j is i n + j.
shape::QuadSurface TorusQuads(int n)
{
  Eigen::MatrixXi quads(n * n, 4);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int right = (i + 1) % n, up = (j + 1) % n;
      quads.row(i * n + j) << i * n + j, right * n + j, right * n + up, i * n + up;
    }
  }
  return shape::QuadSurface(std::move(quads));
}

constexpr int Side = 6;

/// Patch 1 left of the middle and patch 2 right of it, in patch 0; with quads between them.
Eigen::VectorXi Touching()
{
  Eigen::VectorXi patchOf = Eigen::VectorXi::Zero(Side * Side);
  patchOf(1 * Side + 2) = patchOf(2 * Side + 2) = 1;
  patchOf(3 * Side + 3) = patchOf(4 * Side + 3) = 2;
  return patchOf;
}

} // namespace

TEST(PatchRings, ThePinchesClosestArcJoinsItsNeighbour)
{
  const shape::QuadSurface quads = TorusQuads(Side);
  for (const int closest : { 2 * Side + 2, 3 * Side + 3 })
  {
    Eigen::VectorXi patchOf = Touching();
    shape::SplitPinches(
      quads, {}, [&](int quad, int) { return quad == closest ? 0.5 : 1.0; }, patchOf);
    EXPECT_EQ((patchOf - Touching()).cwiseAbs().maxCoeff(), Touching()(closest));
    EXPECT_EQ((patchOf.array() != Touching().array()).count(), 1);
    EXPECT_EQ(patchOf(closest), 0);
  }
}

TEST(QuadSurface, KnowsTheQuadsAcrossEdgesAndAroundPoints)
{
  const shape::QuadSurface torus = TorusQuads(Side);
  EXPECT_EQ(torus.Edges().size(), 4U * Side * Side);
  for (int quad = 0; quad < Side * Side; ++quad)
  {
    const int i = quad / Side, j = quad % Side;
    const int below = i * Side + (j + Side - 1) % Side, left = (i + Side - 1) % Side * Side + j;
    EXPECT_EQ(torus.Across(quad, 0), below);
    EXPECT_EQ(torus.Across(quad, 3), left);
    // Counter-clockwise around the lower left corner.
    const int both = (i + Side - 1) % Side * Side + (j + Side - 1) % Side;
    EXPECT_EQ(torus.QuadsAround(quad, quad), (std::vector<int>{ quad, left, both, below }));
  }
}

TEST(PatchRings, CornersWhereAPatchIsPassedTwiceStay)
{
  const shape::QuadSurface quads = TorusQuads(Side);
  Eigen::VectorXi patchOf = Touching();
  const shape::PatchRing corner = shape::BuildPatchRing({ 0, 1, 0, 2 });
  shape::SplitPinches(
    quads, { corner }, [](int, int) { return 1.0; }, patchOf);
  EXPECT_EQ(patchOf, Touching());
  // And where no patch is passed twice, nothing happens.
  Eigen::VectorXi halves = Eigen::VectorXi::Zero(Side * Side);
  halves.head(Side * Side / 2).setOnes();
  Eigen::VectorXi same = halves;
  shape::SplitPinches(
    quads, {}, [](int, int) { return 1.0; }, same);
  EXPECT_EQ(same, halves);
}
