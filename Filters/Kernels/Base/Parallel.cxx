#include "Base/Parallel.h"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cblas.h>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>

namespace shape
{

namespace
{

/// Arenas are kept, because to make one wakes all threads, which takes longer than a short loop.
oneapi::tbb::task_arena& GetArena(int threads)
{
  static std::mutex mutex;
  static std::map<int, oneapi::tbb::task_arena> arenas;
  const std::lock_guard<std::mutex> lock(mutex);
  return arenas.try_emplace(threads, threads).first->second;
}

} // namespace

int GetThreadCount()
{
  const char* limit = std::getenv("VTK_SMP_MAX_THREADS");
  const int asked = limit ? std::atoi(limit) : 0;
  return asked > 0 ? asked : oneapi::tbb::info::default_concurrency();
}

BlasThreads::BlasThreads(bool several)
  : Before(openblas_get_num_threads())
{
  openblas_set_num_threads(several ? GetThreadCount() : 1);
}

BlasThreads::~BlasThreads()
{
  openblas_set_num_threads(this->Before);
}

void ParallelFor(int count, int grain, const std::function<void(int begin, int end)>& body,
  const Progress& progress)
{
  const int chunks = count / grain + (count % grain > 0);
  if (chunks == 1)
  {
    // A single chunk runs directly: such calls are made millions of times.
    body(0, count);
    progress(1.0);
    return;
  }
  const int threads = GetThreadCount();
  oneapi::tbb::task_arena& arena = GetArena(threads);
  const auto runChunk = [&](int chunk)
  { body(chunk * grain, chunk + 1 < chunks ? (chunk + 1) * grain : count); };

  // Batches grow until one takes about a tenth of a second, which is often enough for progress and
  // abort.
  int batch = threads;
  for (int first = 0; first < chunks;)
  {
    const int last = chunks - first > batch ? first + batch : chunks;
    const auto start = std::chrono::steady_clock::now();
    // Isolated: a thread that waits for an inner loop must not start another chunk of the outer
    // one, whose locks and buffers it may hold.
    arena.execute(
      [&]
      {
        oneapi::tbb::this_task_arena::isolate(
          [&] { oneapi::tbb::parallel_for(first, last, runChunk); });
      });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (seconds.count() < 0.1)
    {
      batch = std::min(batch > chunks / 2 ? chunks : 2 * batch, chunks);
    }
    first = last;
    progress(static_cast<double>(first) / chunks);
  }
}

} // namespace shape
