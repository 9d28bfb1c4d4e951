#pragma once

#include "Base/Progress.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace shape
{

/// Memory that a library call writes.
struct CallResult
{
  void* Data;
  std::size_t Bytes;
};

/**
 * Runs a library call that cannot be interrupted in a child process (ChildProcess), so that an
 * abort ends it immediately. What the call writes into `results` is copied into this process.
 * Nothing else that it changes is seen here. A short call runs in this process. If the call does
 * not complete, the results are undefined: meanwhile only the child holds their memory.
 *
 * call: must not use threads of this process, and must not throw. operations: the number of its
 * floating-point operations, from which its time is estimated for progress. results: allocated
 * before the call. Throws SolveFailure if the child cannot be started or ends early, and Aborted.
 */
void RunInterruptibly(const std::function<void()>& call, double operations,
  const std::vector<CallResult>& results, const Progress& progress);

} // namespace shape
