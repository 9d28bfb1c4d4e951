#pragma once

#include "Base/Progress.h"

#include <functional>

namespace shape
{

/// Returns the number of threads that kernels use: the environment variable VTK_SMP_MAX_THREADS if
/// it is a positive number, otherwise the number of available cores.
int GetThreadCount();

/**
 * While an object of this class exists, BLAS uses GetThreadCount() threads if `several` is true,
 * and otherwise one thread. One thread is faster for small matrices, because it needs no
 * synchronisation. BLAS has one setting for the entire process, which the destructor restores.
 */
class BlasThreads
{
public:
  explicit BlasThreads(bool several);
  /// Whether several threads are faster for a matrix. shorterSide: the minimum of its numbers of
  /// rows and columns.
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
 * The chunks do not depend on the number of threads. So if each chunk writes its results to a
 * separate location, the results are the same bits for any number of threads. The loop runs in an
 * arena of ShapeMap and changes no global setting. An exception that a chunk throws is rethrown
 * here. `progress` is called from the calling thread, between batches of chunks. Throws Aborted.
 */
void ParallelFor(int count, int grain, const std::function<void(int begin, int end)>& body,
  const Progress& progress = {});

} // namespace shape
