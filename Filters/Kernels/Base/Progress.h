#pragma once

#include <functional>
#include <memory>

namespace shape
{

/**
 * Receives the completed share of a computation, in [0, 1], and its stage, and may stop it.
 *
 * A kernel reports progress from the thread that called the kernel, at least every half second
 * unless a single library call takes longer. If the callback returns false, the report throws
 * Aborted, which stops the kernel. Without a callback, a report costs nothing.
 */
class Progress
{
public:
  /// `stage` says what is being done, in a few words for a user, or is empty. It is a string
  /// literal: the pointer remains valid, and differs only if the stage does.
  using Callback = std::function<bool(double fraction, const char* stage)>;

  Progress() = default;
  Progress(Callback report);
  Progress(std::function<bool(double)> report);

  /// Reports the completed share `fraction`. Throws Aborted.
  void operator()(double fraction) const;

  /// Returns the Progress of a part of the computation. The part covers the range from `begin` to
  /// `end` of this Progress, within [0, 1]. `stage` names what the part does, in lower case; it is
  /// a string literal. A part without a stage has that of the whole.
  Progress Part(double begin, double end, const char* stage = nullptr) const;

private:
  std::shared_ptr<const Callback> Report;
  double Begin = 0.0;
  double End = 1.0;
  const char* Stage = "";
};

} // namespace shape
