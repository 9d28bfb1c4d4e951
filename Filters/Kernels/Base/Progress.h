#pragma once

#include <functional>
#include <utility>

namespace shape
{

/**
 * Receives the completed share of a computation, in [0, 1], and may stop it.
 *
 * A kernel reports progress from the thread that called the kernel, at least every half second
 * unless a single library call takes longer. If the callback returns false, the report throws
 * Aborted, which stops the kernel. Without a callback, a report costs nothing.
 */
class Progress
{
public:
  Progress() = default;
  Progress(std::function<bool(double)> report)
    : Report(std::move(report))
  {
  }

  /// Reports the completed share `fraction`. Throws Aborted.
  void operator()(double fraction) const;

  /// Returns the Progress of a part of the computation. The part covers the range from `begin` to
  /// `end` of this Progress, within [0, 1].
  Progress Part(double begin, double end) const;

private:
  std::function<bool(double)> Report;
};

} // namespace shape
