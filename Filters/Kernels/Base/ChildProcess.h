#pragma once

#include <cstddef>
#include <functional>
#include <sys/types.h>

namespace shape
{

/**
 * A forked copy of this process that runs one function and sends its results through a pipe. It is
 * for libraries that may crash, loop or exit: nothing that happens there affects this process.
 *
 * The child has a copy of this process's memory, but default signal handlers. Its standard streams
 * are /dev/null, all other files are closed, it writes no core dump, and it ends with the calling
 * thread. It must not use the user interface, the network or the work of other threads. Memory and
 * streams of the C library are safe, because the library makes them consistent when forking. POSIX
 * only.
 */
class ChildProcess
{
public:
  /// Starts the child. It calls body(pipe) and ends without running anything else. Throws
  /// SolveFailure if the system has no process or file left.
  explicit ChildProcess(const std::function<void(int pipe)>& body);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess(); ///< kills the child if it still runs

  /// Called in the child: sends `size` bytes, or ends the child if nobody receives them.
  static void Send(int pipe, const void* data, std::size_t size);

  /// Receives `size` bytes. Calls `waiting` about every 0.1 s until they have arrived. Returns
  /// false if the child ended before it sent them.
  bool Receive(void* data, std::size_t size, const std::function<void()>& waiting);

  /// Returns the signal that ended the child, or 0.
  int Signal() const;

private:
  void Wait(bool block);

  pid_t Id = -1;
  int Pipe = -1;
  int Status = 0;
  bool Ended = false;
};

} // namespace shape
