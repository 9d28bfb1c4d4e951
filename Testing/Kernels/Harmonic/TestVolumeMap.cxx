#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/VolumeMap.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

namespace
{

/// The unit ball, stretched along z.
shape::VolumeMapConditions Stretched()
{
  shape::VolumeMapConditions conditions;
  conditions.Boundary = shapetest::Icosphere(2);
  conditions.Targets = conditions.Boundary.Points();
  conditions.Targets.col(2) = conditions.Targets.col(2).array() * 1.5 +
    0.2 * conditions.Boundary.Points().col(0).array().square();
  return conditions;
}

shape::Mesh Core()
{
  shape::Mesh core = shapetest::Icosphere(2);
  core.Points *= 0.5;
  return core;
}

} // namespace

TEST(VolumeMap, IsOneHarmonicMapUnlessMoreIsAskedFor)
{
  const shape::VolumeMapConditions conditions = Stretched();
  const shape::VolumeMapResult result = shape::ComputeVolumeMap(conditions);
  const shape::HarmonicVolumeMapResult one =
    shape::ComputeHarmonicVolumeMap(conditions.Boundary, conditions.Targets);
  ASSERT_EQ(result.Map.Charges.Maps.size(), 1u);
  EXPECT_EQ(result.Map.Charges.Maps[0].Points, one.Map.Points);
  EXPECT_EQ(result.Map.Charges.Maps[0].Charges, one.Map.Charges);
  EXPECT_EQ(result.Map.Borders[0].RMSEInside, one.Levels.back().RMSEInside);
  EXPECT_EQ(result.Targets, conditions.Targets);
  EXPECT_EQ(result.SlidShare, 0.0);
  EXPECT_EQ(result.TargetDistance, 0.0) << "there is no Target";
}

TEST(VolumeMap, HasARegionForEachExactSurface)
{
  shape::VolumeMapConditions conditions = Stretched();
  const shape::Mesh core = Core();
  conditions.Surfaces = { { core, 0.8 * core.Points, "the core" } };
  shape::VolumeMapOptions options;
  options.Exact = true;
  const shape::VolumeMapResult result = shape::ComputeVolumeMap(conditions, options);
  const shape::PiecewiseVolumeMapResult layered =
    shape::ComputePiecewiseVolumeMap(conditions.Boundary, conditions.Targets, conditions.Surfaces);
  ASSERT_EQ(result.Map.Charges.Maps.size(), 2u);
  for (int r = 0; r < 2; ++r)
  {
    EXPECT_EQ(result.Map.Charges.Maps[r].Charges, layered.Charges.Maps[r].Charges) << r;
  }
  EXPECT_EQ(result.Map.Charges.Farthest, layered.Charges.Farthest);
}

TEST(VolumeMap, MeasuresHowFarTheImagesAreFromTheTarget)
{
  shape::VolumeMapConditions conditions = Stretched();
  shape::Mesh target{ conditions.Targets, conditions.Boundary.Triangles() };
  conditions.Target = target;
  EXPECT_LT(shape::ComputeVolumeMap(conditions).TargetDistance, 1e-15);
  target.Points.col(0).array() += 0.1;
  conditions.Target = target;
  const double distance = shape::ComputeVolumeMap(conditions).TargetDistance;
  EXPECT_GT(distance, 0.01);
  EXPECT_LE(distance, 0.1 / shape::ComputeLongestBoxEdge(target.Points));
}

TEST(VolumeMap, RefusesToSlideWithoutATarget)
{
  shape::VolumeMapOptions options;
  options.FreeBoundary = true;
  EXPECT_THROW(shape::ComputeVolumeMap(Stretched(), options), shape::InvalidInput);
}
