#pragma once

#include <charconv>
#include <string>

namespace shape
{

/// Returns the shortest text that represents the number exactly.
inline std::string ToExactText(double value)
{
  char buffer[40];
  return { buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr };
}

} // namespace shape
