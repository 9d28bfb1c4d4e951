#pragma once

#include "Base/Progress.h"

#include <functional>

namespace shape
{

/// Returns the number of threads for kernels: VTK_SMP_MAX_THREADS if set to a positive number, else
/// all available cores.
int GetThreadCount();

/**
 * Sets the number of BLAS threads for its lifetime: GetThreadCount(), or one for matrices so small
 * that synchronisation would cost more than the threads gain. BLAS has one setting for the whole
 * process, which is restored afterwards.
 */
class BlasThreads
{
public:
  explicit BlasThreads(bool several);
  /// Whether a matrix with this shorter side is worth several threads.
  static bool WorthSharing(int shorterSide) { return shorterSide >= 512; }
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

private:
  int Before;
};

/**
 * Calls body(begin, end) for the chunks [0, grain), [grain, 2 grain), ... of [0, count).
 *
 * The chunks do not depend on the number of threads. So results that each chunk writes to a
 * separate location are the same bits for any number. It runs in its own arena and changes no
 * global setting. An exception thrown by a chunk is rethrown here. `progress` is called between
 * batches of chunks, from the calling thread. Throws Aborted.
 */
void ParallelFor(int count, int grain, const std::function<void(int begin, int end)>& body,
  const Progress& progress = {});

} // namespace shape
