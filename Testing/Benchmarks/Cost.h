#pragma once

#include <functional>

namespace benchmark
{

/// What running something took.
struct Cost
{
  double Cpu = 0.0; ///< seconds: CpuSeconds
  double Wall = 0.0;
  double MiB = 0.0; ///< the peak above the start; of the largest child process if that is more
};

/// Of all threads and of child processes that have ended.
double CpuSeconds();

Cost Measure(const std::function<void()>& method);

} // namespace benchmark
