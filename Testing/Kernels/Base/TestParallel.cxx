#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Support/ProgressChecks.h"

#include <gtest/gtest.h>

#include <cblas.h>
#include <cstdlib>
#include <vector>

TEST(Parallel, EveryIndexIsVisitedOnceInFixedChunks)
{
  std::vector<int> visits(1003, 0), begins(1003, -1);
  shape::ParallelFor(1003, 10,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        ++visits[i];
        begins[i] = begin;
      }
    });
  for (int i = 0; i < 1003; ++i)
  {
    EXPECT_EQ(visits[i], 1);
    EXPECT_EQ(begins[i], i / 10 * 10);
  }
}

TEST(Parallel, AnExceptionInAChunkReachesTheCaller)
{
  EXPECT_THROW(shape::ParallelFor(100, 1,
                 [](int begin, int)
                 {
                   if (begin == 57)
                   {
                     throw shape::SolveFailure("57");
                   }
                 }),
    shape::SolveFailure);
}

TEST(Parallel, ProgressRisesToOneAndCanStop)
{
  shapetest::ExpectProgressRises(
    [](const shape::Progress& progress)
    {
      shape::ParallelFor(
        1000, 1, [](int, int) {}, progress);
    });
  EXPECT_THROW(shape::ParallelFor(
                 10, 1, [](int, int) {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}

TEST(Parallel, PartsMapToTheirRange)
{
  std::vector<double> seen;
  const shape::Progress whole(
    [&](double fraction)
    {
      seen.push_back(fraction);
      return true;
    });
  whole.Part(0.5, 1.0).Part(0.0, 0.5)(1.0);
  EXPECT_EQ(seen, std::vector<double>{ 0.75 });
}

TEST(Parallel, TheEnvironmentLimitsTheThreads)
{
  setenv("VTK_SMP_MAX_THREADS", "3", 1);
  EXPECT_EQ(shape::GetThreadCount(), 3);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_GE(shape::GetThreadCount(), 1);
}

TEST(Parallel, BlasUsesAsManyThreadsAndThenAsBefore)
{
  const int before = openblas_get_num_threads();
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  {
    const shape::BlasThreads threads(true);
    EXPECT_EQ(openblas_get_num_threads(), 1);
  }
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  {
    const shape::BlasThreads threads(shape::BlasThreads::WorthSharing(1000));
    EXPECT_EQ(openblas_get_num_threads(), 2);
    const shape::BlasThreads few(shape::BlasThreads::WorthSharing(100));
    EXPECT_EQ(openblas_get_num_threads(), 1);
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(openblas_get_num_threads(), before);
}
