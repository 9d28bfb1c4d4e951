#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using shape::Surface;

namespace
{

struct Kept
{
  int Value;
};

} // namespace

TEST(Surface, MakesEachQuantityOnceForAllCopiesAndThreads)
{
  const Surface surface = shapetest::Icosphere(1);
  std::atomic<int> made = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
  {
    threads.emplace_back([&made, surface]()
      { EXPECT_EQ(surface.Cached<Kept>([&]() { return Kept{ ++made }; })->Value, 1); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(made, 1);
}

TEST(Surface, KeepsNothingOfWhatThrew)
{
  const Surface surface = shapetest::Icosphere(1);
  EXPECT_THROW(
    surface.Cached<Kept>([]() -> Kept { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(surface.Cached<Kept>([]() { return Kept{ 7 }; })->Value, 7);
}

TEST(Surface, MovedPointsShareWhatFollowsFromTheTriangles)
{
  const Surface surface = shapetest::Icosphere(1);
  const int edges = surface.Topology().EulerNumber;
  const Surface moved = surface.WithPoints(2.0 * surface.Points());
  EXPECT_EQ(&moved.Twins(), &surface.Twins());
  EXPECT_EQ(&moved.HalfEdges(), &surface.HalfEdges());
  EXPECT_EQ(&moved.Topology(), &surface.Topology());
  EXPECT_EQ(moved.Topology().EulerNumber, edges);
  EXPECT_TRUE(moved.AreaVectors().isApprox(4.0 * surface.AreaVectors(), 1e-15));
  EXPECT_NE(&moved.AreaVectors(), &surface.AreaVectors());
}

TEST(Surface, MovedPointsAreValidatedForThemselves)
{
  const Surface surface = shapetest::Icosphere(1);
  shape::RequireClosedSurface(surface, "the surface");
  EXPECT_THROW(
    shape::RequireClosedSurface(surface.WithPoints(0.0 * surface.Points()), "the surface"),
    shape::InvalidInput);
  EXPECT_THROW(surface.WithPoints(surface.Points().topRows(3)), shape::InvalidInput);
}
