#include "Base/LibraryCall.h"

#include "Base/ChildProcess.h"
#include "Base/Errors.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace shape
{
namespace
{

/// Gives the complete pages of a result back to the system. They are zero until they are written.
void ReleasePages(const CallResult& result)
{
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(result.Data) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(result.Data) + result.Bytes) / page * page;
  if (begin < end)
  {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
  }
}

} // namespace

void RunInterruptibly(const std::function<void()>& call, double operations,
  const std::vector<CallResult>& results, const Progress& progress)
{
  constexpr double rate = 1e11;      // measured with two cores: operations in a second
  constexpr double shortCall = 0.05; // seconds, below which a process is not worth its cost
  const double expected = operations / rate;
  if (expected < shortCall)
  {
    call();
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  ChildProcess child(
    [&](int pipe)
    {
      call();
      for (const CallResult& result : results)
      {
        ChildProcess::Send(pipe, result.Data, result.Bytes);
      }
    });
  // The child has its own copy of what the call reads, so only one copy remains.
  for (const CallResult& result : results)
  {
    ReleasePages(result);
  }
  const auto report = [&]
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    progress(std::min(0.95, passed.count() / expected));
  };
  // Large results are received in pieces, with a report after each.
  constexpr std::size_t piece = std::size_t(1) << 26;
  for (const CallResult& result : results)
  {
    for (std::size_t done = 0; done < result.Bytes; done += piece)
    {
      report();
      if (child.Receive(
            static_cast<char*>(result.Data) + done, std::min(piece, result.Bytes - done), report))
      {
        continue;
      }
      throw SolveFailure("a process that decomposed a matrix ended early" +
        (child.Signal() > 0 ? " with signal " + std::to_string(child.Signal()) : std::string()) +
        "; free some memory");
    }
  }
}

} // namespace shape
