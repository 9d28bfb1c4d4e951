#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace shape
{

/**
 * The input cannot be used. The message states the fact about the input (with a count or the first
 * id) and the remedy. The filter that reports it prepends its own name.
 */
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The input is valid but the computation did not reach its goal. The message says how far it got.
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

/// Throws InvalidInput unless an option is in its range: "CellSize is -1; it must be positive".
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
