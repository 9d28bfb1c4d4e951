#pragma once

#include "Base/ChildProcess.h"

#include <cstddef>
#include <functional>
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

} // namespace shape
