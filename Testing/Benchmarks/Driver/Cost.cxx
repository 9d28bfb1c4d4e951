#include "Driver/Cost.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace benchmark
{
namespace
{

/// A line of /proc/self/status, in KiB.
long Status(const std::string& key)
{
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
  {
    if (word == key + ":")
    {
      long value = 0;
      file >> value;
      return value;
    }
  }
  return 0;
}

} // namespace

double CpuSeconds()
{
  double seconds = 0.0;
  for (const int who : { RUSAGE_SELF, RUSAGE_CHILDREN })
  {
    rusage usage{};
    getrusage(who, &usage);
    seconds += static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  }
  return seconds;
}

double PeakMiB()
{
  return static_cast<double>(Status("VmHWM")) / 1024.0;
}

Cost Measure(const std::function<void()>& method)
{
  std::ofstream("/proc/self/clear_refs") << 5; // forget the peak of reading and preparing
  const long before = Status("VmRSS");
  const double cpu = CpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  method();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children); // TetGen's process
  const long peak = std::max(Status("VmHWM"), children.ru_maxrss);
  return { CpuSeconds() - cpu, wall.count(), static_cast<double>(peak - before) / 1024.0 };
}

double MeasureMedian(int runs, const std::function<void()>& method)
{
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run)
  {
    const double start = CpuSeconds();
    method();
    seconds.push_back(CpuSeconds() - start);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[runs / 2];
}

} // namespace benchmark
