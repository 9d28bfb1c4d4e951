#pragma once

#include "Base/Errors.h"
#include "Base/Processes.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace shapetest
{

/// Forked processes that add through shared memory, as the processes of MPI do.
class ForkedProcesses
{
public:
  /// Calls work in `count` processes, of which this one is the first. Returns the number of
  /// processes in which it threw; an exception of this process is thrown again.
  static int Run(int count, const std::function<void(const shape::Processes&)>& work)
  {
    const std::size_t bytes = sizeof(Shared) + sizeof(double) * Chunk * count;
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    const ForkedProcesses here{ new (memory) Shared(), count };
    std::vector<pid_t> children;
    int number = 0;
    for (int child = 1; child < count && number == 0; ++child)
    {
      const pid_t id = fork();
      number = id == 0 ? child : 0;
      children.push_back(id);
    }
    const shape::Processes own{ count, number,
      [here, number](double* values, Eigen::Index size) { here.Add(number, values, size); } };
    if (number > 0)
    {
      setenv("VTK_SMP_MAX_THREADS", "1", 1); // a fork has no other thread
    }
    std::exception_ptr failure;
    try
    {
      work(own);
    }
    catch (...)
    {
      failure = std::current_exception();
      here.Common->Failed = true;
    }
    if (number > 0)
    {
      _exit(failure ? 1 : 0);
    }
    int failures = failure ? 1 : 0;
    for (const pid_t id : children)
    {
      int status = 0;
      waitpid(id, &status, 0);
      failures += status != 0 ? 1 : 0;
    }
    munmap(memory, bytes);
    if (failure)
    {
      std::rethrow_exception(failure);
    }
    return failures;
  }

private:
  struct Shared;
  ForkedProcesses(Shared* common, int count)
    : Common(common)
    , Count(count)
  {
  }

  static constexpr Eigen::Index Chunk = 65536;
  struct Shared
  {
    std::atomic<long> Arrived{ 0 };
    std::atomic<bool> Failed{ false };
  };

  Shared* Common;
  int Count;
  std::shared_ptr<long> Meetings = std::make_shared<long>(0); ///< of this process

  /// Waits until all processes have come here as often as this one.
  void Meet() const
  {
    ++this->Common->Arrived;
    ++*this->Meetings;
    while (this->Common->Arrived < *this->Meetings * this->Count)
    {
      if (this->Common->Failed)
      {
        throw shape::SolveFailure("another process has failed");
      }
      usleep(50);
    }
  }

  void Add(int number, double* values, Eigen::Index size) const
  {
    auto* all = reinterpret_cast<double*>(this->Common + 1);
    for (Eigen::Index first = 0; first < size; first += Chunk)
    {
      const Eigen::Index count = std::min(Chunk, size - first);
      std::copy_n(values + first, count, all + Chunk * number);
      this->Meet();
      std::fill_n(values + first, count, 0.0);
      for (int process = 0; process < this->Count; ++process)
      {
        for (Eigen::Index i = 0; i < count; ++i)
        {
          values[first + i] += all[Chunk * process + i];
        }
      }
      this->Meet();
    }
  }
};

} // namespace shapetest
