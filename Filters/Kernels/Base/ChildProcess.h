#pragma once

#include <cstddef>
#include <functional>
#include <sys/types.h>

namespace shape
{

/**
 * A forked copy of this process that runs one function and sends its results through a pipe. It is
 * for libraries that may crash, loop forever or exit: nothing that happens in the child affects
 * this process.
 *
 * The child has a copy of this process's memory, but default signal handlers. Its standard streams
 * are /dev/null, and all other files are closed. It writes no core dump, and it is killed if the
 * calling thread ends. It must not use the user interface or the network, or depend on other
 * threads, which do not exist in the child. It may allocate memory and use streams of the C
 * library, because the library makes both consistent when it forks. POSIX only.
 */
class ChildProcess
{
public:
  /// Starts the child, which calls body(pipe) and then ends without running anything else. Throws
  /// SolveFailure if the system cannot create another process or pipe.
  explicit ChildProcess(const std::function<void(int pipe)>& body);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess(); ///< kills the child if it still runs

  /// Sends `size` bytes. Must be called in the child. Ends the child if the parent process no
  /// longer receives.
  static void Send(int pipe, const void* data, std::size_t size);

  /// Receives `size` bytes from the child. Calls `waiting` about every 0.1 s until all bytes have
  /// arrived. Returns false if the child ended before it sent all of them.
  bool Receive(void* data, std::size_t size, const std::function<void()>& waiting);

  /// Returns the signal that ended the child, or 0 if it ended without a signal.
  int Signal() const;

private:
  void Wait(bool block);

  pid_t Id = -1;
  int Pipe = -1;
  int Status = 0;
  bool Ended = false;
};

} // namespace shape
