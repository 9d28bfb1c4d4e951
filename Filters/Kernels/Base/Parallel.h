#pragma once

#include "Base/Progress.h"

#include <functional>

namespace shape
{

/// Threads that kernels use: VTK_SMP_MAX_THREADS where set to a positive number, else every
/// available core.
int GetThreadCount();

/**
 * Lets BLAS use GetThreadCount() threads while it lives, or one where the matrices are so small
 * that waiting for each other would cost the threads more than they gain: its own number is one
 * setting of the whole process, which is put back afterwards.
 */
class BlasThreads
{
public:
  explicit BlasThreads(bool several);
  /// Several where a matrix's shorter side is worth it.
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
 * The chunks do not depend on the number of threads, so a result that each chunk writes to its own
 * place is the same bits for any of them. Runs in an arena of its own and changes no global
 * setting. An exception thrown by a chunk is rethrown here. `progress` is called between batches of
 * chunks, from the calling thread. Throws Aborted.
 */
void ParallelFor(int count, int grain, const std::function<void(int begin, int end)>& body,
  const Progress& progress = {});

} // namespace shape
