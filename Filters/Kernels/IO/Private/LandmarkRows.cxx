#include "IO/Private/LandmarkRows.h"

#include "Base/Errors.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace shape
{

std::string Trim(std::string word)
{
  const char* blanks = " \t\r";
  word.erase(0, word.find_first_not_of(blanks));
  word.erase(word.find_last_not_of(blanks) + 1);
  return word;
}

double ToCoordinate(const std::string& word, const std::string& where)
{
  double value = 0.0;
  const char* end = word.data() + word.size();
  const std::from_chars_result read = std::from_chars(word.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
  {
    throw InvalidInput(where + ": `" + word + "` is no finite number");
  }
  return value;
}

} // namespace shape
