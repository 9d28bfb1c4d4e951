#pragma once

#include <functional>
#include <utility>

namespace shape
{

/**
 * Receives the completed share of a computation, in [0, 1], and may stop it.
 *
 * A kernel calls it from the thread that called the kernel, at least every half second unless a
 * single library call takes longer. The callback returns false to stop; the call then throws
 * Aborted. Without a callback it costs nothing.
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

  /// Returns the progress of a part that covers `begin` to `end` of this one.
  Progress Part(double begin, double end) const;

private:
  std::function<bool(double)> Report;
};

} // namespace shape
