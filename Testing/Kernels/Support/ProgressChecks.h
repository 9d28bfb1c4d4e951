#pragma once

#include "Base/Errors.h"
#include "Base/Progress.h"

#include <gtest/gtest.h>

#include <functional>

// What the tests of reported progress share.
namespace shapetest
{

using ReportingCall = std::function<void(const shape::Progress&)>;

/// The fractions that a call reports never fall, and the last one is 1. Returns how many there are.
inline int ExpectProgressRises(const ReportingCall& call)
{
  double last = 0.0;
  int count = 0;
  call(shape::Progress(
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return ++count > 0;
    }));
  EXPECT_EQ(last, 1.0);
  return count;
}

/// A call that is told to stop at its `report`th report is aborted.
inline void ExpectStopsAt(int report, const ReportingCall& call)
{
  EXPECT_THROW(call(shape::Progress([&](double) { return --report > 0; })), shape::Aborted);
}

} // namespace shapetest
