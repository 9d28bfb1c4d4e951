#include "Base/Errors.h"
#include "Base/LibraryCall.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{

constexpr double longCall = 1e12; // operations

} // namespace

TEST(LibraryCall, OnlyTheResultsOfALongCallAreSeen)
{
  const pid_t parent = getpid();
  pid_t caller = parent;
  int result = 0, other = 0;
  shape::RunInterruptibly(
    [&]
    {
      caller = getpid();
      result = 7;
      other = 7;
    },
    longCall, { { &caller, sizeof(caller) }, { &result, sizeof(result) } }, {});
  EXPECT_NE(caller, parent);
  EXPECT_EQ(result, 7);
  EXPECT_EQ(other, 0);
}

TEST(LibraryCall, ALargeResultReplacesWhatTheCallRead)
{
  std::vector<double> values(1 << 20);
  std::iota(values.begin(), values.end(), 1.0);
  shape::RunInterruptibly(
    [&]
    {
      for (double& value : values)
      {
        value *= 2.0;
      }
    },
    longCall, { { values.data(), values.size() * sizeof(double) } }, {});
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    ASSERT_EQ(values[i], 2.0 * (i + 1.0));
  }
}

TEST(LibraryCall, AShortCallRunsInThisProcess)
{
  pid_t caller = 0;
  shape::RunInterruptibly([&] { caller = getpid(); }, 1e3, {}, {});
  EXPECT_EQ(caller, getpid());
}

TEST(LibraryCall, AnAbortEndsACallThatNeverReturns)
{
  int reports = 0, result = 0;
  double last = 0.0;
  const shape::Progress progress(
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      return ++reports < 3;
    });
  const auto forever = []
  {
    while (true)
    {
      pause();
    }
  };
  EXPECT_THROW(
    shape::RunInterruptibly(forever, longCall, { { &result, sizeof(result) } }, progress),
    shape::Aborted);
  EXPECT_EQ(reports, 3);
}

TEST(LibraryCall, ACallThatEndsTheProcessIsAFailure)
{
  int result = 0;
  const std::vector<shape::CallResult> results{ { &result, sizeof(result) } };
  EXPECT_THROW(
    shape::RunInterruptibly([] { _exit(0); }, longCall, results, {}), shape::SolveFailure);
  try
  {
    shape::RunInterruptibly([] { std::abort(); }, longCall, results, {});
    FAIL();
  }
  catch (const shape::SolveFailure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("signal 6"), std::string::npos) << failure.what();
  }
}
