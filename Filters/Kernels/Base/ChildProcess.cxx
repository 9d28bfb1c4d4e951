#include "Base/ChildProcess.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace shape
{
namespace
{

/// Detaches a fork from its parent's signals and files. Returns the pipe's new number.
int Detach(pid_t parent, int pipeEnd)
{
  for (int number = 1; number < NSIG; ++number)
  {
    signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
#ifdef __linux__
  // The system kills the child when its parent's thread ends. If that happened before this call,
  // the child already has another parent.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent)
  {
    _exit(1);
  }
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  // Buffered output stays the parent's to print, because the child ends with _exit.
  const int nowhere = open("/dev/null", O_RDWR);
  // The pipe gets a number above those of the standard streams, which are replaced below.
  const int kept = fcntl(pipeEnd, F_DUPFD, 3);
  for (const int standard : { 0, 1, 2 })
  {
    dup2(nowhere, standard);
  }
  rlimit files{ 0, 0 };
  getrlimit(RLIMIT_NOFILE, &files);
  // The bound limits the time if the system allows millions of files.
  for (int file = 3; file < static_cast<int>(std::min<rlim_t>(files.rlim_cur, 65536)); ++file)
  {
    if (file != kept)
    {
      close(file);
    }
  }
  return kept;
}

} // namespace

ChildProcess::ChildProcess(const std::function<void(int pipe)>& body)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw SolveFailure(
      std::string("cannot make a pipe: ") + std::strerror(errno) + "; close some files");
  }
  for (const int end : ends)
  {
    fcntl(end, F_SETFD, FD_CLOEXEC);
  }
  // Signals are blocked until the child has removed this process's handlers.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t parent = getpid();
  this->Id = fork();
  if (this->Id == 0)
  {
    try
    {
      body(Detach(parent, ends[1]));
    }
    catch (...)
    {
      _exit(1);
    }
    _exit(0);
  }
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(ends[1]);
  if (this->Id < 0)
  {
    close(ends[0]);
    throw SolveFailure(
      std::string("cannot start a process: ") + std::strerror(error) + "; free some memory");
  }
  this->Pipe = ends[0];
  // Receive must return to `waiting` even if nothing arrives.
  fcntl(this->Pipe, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess()
{
  close(this->Pipe);
  if (!this->Ended)
  {
    kill(this->Id, SIGKILL);
    while (waitpid(this->Id, &this->Status, 0) < 0 && errno == EINTR)
    {
    }
  }
}

void ChildProcess::Send(int pipe, const void* data, std::size_t size)
{
  const char* at = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t sent = write(pipe, at, size);
    if (sent < 0 && errno != EINTR)
    {
      _exit(1);
    }
    at += std::max<ssize_t>(sent, 0);
    size -= std::max<ssize_t>(sent, 0);
  }
}

bool ChildProcess::Receive(void* data, std::size_t size, const std::function<void()>& waiting)
{
  char* at = static_cast<char*>(data);
  while (size > 0)
  {
    const ssize_t got = read(this->Pipe, at, size);
    if (got > 0)
    {
      at += got;
      size -= got;
    }
    else if (got < 0 && errno != EAGAIN && errno != EINTR)
    {
      return false;
    }
    else if (this->Ended)
    {
      return false;
    }
    else
    {
      waiting();
      // Ask for the child's state before the pipe is read once more. The end of the pipe is not
      // enough: another process forked meanwhile may hold it open.
      this->Wait(got == 0);
      pollfd readable{ this->Pipe, POLLIN, 0 };
      poll(&readable, 1, this->Ended ? 0 : 100);
    }
  }
  return true;
}

int ChildProcess::Signal() const
{
  return WIFSIGNALED(this->Status) ? WTERMSIG(this->Status) : 0;
}

void ChildProcess::Wait(bool block)
{
  const pid_t ended = waitpid(this->Id, &this->Status, block ? 0 : WNOHANG);
  // If somebody else has collected the child's status, it has ended as well.
  this->Ended = ended == this->Id || (ended < 0 && errno == ECHILD);
}

} // namespace shape
