#pragma once

#include <cstddef>
#include <functional>
#include <sys/types.h>

namespace shape
{

/**
 * A forked copy of this process that runs one function and sends what it found through a pipe: for
 * a library that may crash, loop or end the process. Nothing that happens there reaches this
 * process.
 *
 * The child has the memory of this process as it was, but its signal handlers are the system's, its
 * standard streams lead nowhere, it holds no other file, writes no core dump, and ends when the
 * calling thread does. It must not touch the user's interface, the network or other threads' work;
 * memory and streams of the C library are safe there, since it makes them so when forking. POSIX.
 */
class ChildProcess
{
public:
  /// Starts it. The child calls body(pipe) and ends without running anything else. Throws
  /// SolveFailure where the system has no process or file left.
  explicit ChildProcess(const std::function<void(int pipe)>& body);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess(); ///< kills the child where it still runs

  /// In the child: sends `size` bytes, or ends the child where nobody receives them.
  static void Send(int pipe, const void* data, std::size_t size);

  /// Receives `size` bytes; calls `waiting` about every 0.1 s until they are there. Returns false
  /// where the child ended before it had sent them.
  bool Receive(void* data, std::size_t size, const std::function<void()>& waiting);

  /// The signal that ended the child, or 0.
  int Signal() const;

private:
  void Wait(bool block);

  pid_t Id = -1;
  int Pipe = -1;
  int Status = 0;
  bool Ended = false;
};

} // namespace shape
