#pragma once

#include <functional>

namespace benchmark
{

/// The time and memory that a run took.
struct Cost
{
  double Cpu = 0.0; ///< seconds: CpuSeconds
  /// seconds
  double Wall = 0.0;
  double MiB = 0.0; ///< peak above the start, or that of the largest child process if it is more
};

/// Returns the CPU time in seconds of all threads and of child processes that have ended.
double CpuSeconds();

/// Returns the peak of this process's memory in MiB, since Measure last forgot it.
double PeakMiB();

/// Runs the method and returns its cost.
Cost Measure(const std::function<void()>& method);

/// The median of the CPU seconds of several runs.
double MeasureMedian(int runs, const std::function<void()>& method);

} // namespace benchmark
