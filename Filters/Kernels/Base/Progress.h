#pragma once

#include <functional>
#include <utility>

namespace shape
{

/**
 * Receives how much of a computation is done, in [0, 1], and may stop it.
 *
 * A kernel calls it from the thread that called the kernel, at least every half second where no
 * single library call takes longer. The callback returns false to stop: the call then throws
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

  /// States that the share `fraction` is done. Throws Aborted.
  void operator()(double fraction) const;

  /// The progress of a part that takes this one from `begin` to `end`.
  Progress Part(double begin, double end) const;

private:
  std::function<bool(double)> Report;
};

} // namespace shape
