#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace shape
{

/**
 * The input cannot be used. The message states what is wrong with the input, with a count or the
 * first index, and the remedy. The filter that reports the message adds its own name in front.
 */
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The input is valid, but the computation did not reach its goal. The message says what was
/// reached.
class SolveFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Thrown by a kernel when its Progress requests a stop. This is not an error.
class Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "aborted"; }
};

/// Throws InvalidInput if `holds` is false. The message gives the name, the value and the range of
/// an option: "CellSize is -1; it must be positive".
inline void RequireOption(
  bool holds, const std::string& name, double value, const std::string& range)
{
  if (!holds)
  {
    std::ostringstream words;
    words << name << " is " << value << "; it must be " << range;
    throw InvalidInput(words.str());
  }
}

} // namespace shape
