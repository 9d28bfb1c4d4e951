#pragma once

#include <sstream>
#include <string>

namespace shape
{

/// Returns a number for a message, with six significant digits: "1e-08", where std::to_string gives
/// "0.000000".
inline std::string FormatNumber(double number)
{
  std::ostringstream words;
  words << number;
  return words.str();
}

} // namespace shape
