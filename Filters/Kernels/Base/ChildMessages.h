#pragma once

#include "Base/ChildProcess.h"
#include "Base/Errors.h"
#include "Base/Progress.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <functional>
#include <new>
#include <string>
#include <vector>

namespace shape
{

///@{
/// Sends values through the pipe of a child process, or receives them in the same order: a function
/// that moves the members of a result serves both processes.
struct ChildSender
{
  int Pipe;

  template <class T>
  void Move(std::vector<T>& values) const
  {
    const std::size_t count = values.size();
    ChildProcess::Send(this->Pipe, &count, sizeof(count));
    ChildProcess::Send(this->Pipe, values.data(), count * sizeof(T));
  }
};

struct ChildReceiver
{
  ChildProcess& Child;
  const std::function<void()>& Waiting;         ///< called about every 0.1 s until the end
  std::function<void(int signal)> ThrowIfEnded; ///< throws; the child ended without a result

  template <class T>
  void Move(std::vector<T>& values) const
  {
    std::size_t count = 0;
    this->Receive(&count, sizeof(count));
    values.resize(count);
    this->Receive(values.data(), count * sizeof(T));
  }

private:
  void Receive(void* data, std::size_t size) const
  {
    if (size > 0 && !this->Child.Receive(data, size, this->Waiting))
    {
      this->ThrowIfEnded(this->Child.Signal());
    }
  }
};
///@}

template <class Mover>
void MoveText(const Mover& mover, std::string& text)
{
  std::vector<char> letters(text.begin(), text.end());
  mover.Move(letters);
  text.assign(letters.begin(), letters.end());
}

/// A computation that a child process does for this one, by a library that may crash.
template <class Result>
struct ChildTask
{
  std::function<Result()> Compute; ///< in the child; may throw
  double UsualSeconds = 1.0;       ///< after this time, the progress is one half
  ///@{
  /// What the errors say: who computes, what it does ("reads the file"), and the remedies if memory
  /// runs out and if it crashes.
  std::string Library, Work, MemoryRemedy, CrashRemedy;
  ///@}
};

/// Computes in a child process. move(mover, result): moves the members of a result, by a
/// ChildSender in the child and a ChildReceiver here. Throws InvalidInput and SolveFailure as the
/// child does; SolveFailure if it crashes; Aborted.
template <class Result, class Move>
Result ComputeInChild(
  const ChildTask<Result>& task, const Move& move, const Progress& progress = {})
{
  enum class Outcome : char
  {
    Completed,
    InvalidInput,
    SolveFailure
  };
  ChildProcess child(
    [&](int pipe)
    {
      std::vector<Outcome> outcome{ Outcome::Completed };
      std::string message;
      Result result;
      try
      {
        result = task.Compute();
      }
      catch (const InvalidInput& error)
      {
        outcome = { Outcome::InvalidInput };
        message = error.what();
      }
      catch (const std::bad_alloc&)
      {
        outcome = { Outcome::SolveFailure };
        message = "out of memory; " + task.MemoryRemedy;
      }
      catch (const std::exception& error)
      {
        outcome = { Outcome::SolveFailure };
        message = error.what();
      }
      const ChildSender sender{ pipe };
      sender.Move(outcome);
      MoveText(sender, message);
      move(sender, result);
    });
  const auto start = std::chrono::steady_clock::now();
  const std::function<void()> waiting = [&]
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    progress(seconds.count() / (seconds.count() + task.UsualSeconds));
  };
  const auto fail = [&](int signal)
  {
    throw SolveFailure(signal == SIGKILL ? "the process that " + task.Work +
          " was killed, probably because memory ran out; " + task.MemoryRemedy
                                         : task.Library + " crashed (" +
          (signal > 0 ? std::string(strsignal(signal)) : "it ended without a result") + "); " +
          task.CrashRemedy);
  };
  const ChildReceiver receiver{ child, waiting, fail };
  std::vector<Outcome> outcome;
  std::string message;
  Result result;
  receiver.Move(outcome);
  MoveText(receiver, message);
  if (outcome.front() == Outcome::InvalidInput)
  {
    throw InvalidInput(message);
  }
  if (outcome.front() == Outcome::SolveFailure)
  {
    throw SolveFailure(message);
  }
  move(receiver, result);
  progress(1.0);
  return result;
}

} // namespace shape
