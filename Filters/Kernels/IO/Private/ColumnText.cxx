#include "IO/Private/ColumnText.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace shape
{
namespace
{

/// Removes redundant zeros: 0.5 becomes .5, 1e-05 becomes 1e-5. An integer gets a decimal point.
std::string Shortened(std::string_view digits)
{
  std::string text(digits);
  if (const auto zero = text.find("0."); zero == 0 || (zero == 1 && text[0] == '-'))
  {
    text.erase(zero, 1);
  }
  const auto exponent = text.find('e');
  if (exponent == std::string::npos)
  {
    return text.find('.') == std::string::npos ? text + '.' : text;
  }
  if (text[exponent + 1] == '+')
  {
    text.erase(exponent + 1, 1);
  }
  const auto digit = text.find_first_of("0123456789", exponent);
  if (text[digit] == '0' && digit + 1 < text.size())
  {
    text.erase(digit, 1);
  }
  return text;
}

/// Returns the text with the most digits that fits in one notation; empty if none does.
std::string ToNotation(double value, std::size_t columns, std::chars_format notation)
{
  char buffer[400];
  for (int precision = static_cast<int>(columns); precision >= 0; --precision)
  {
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, notation, precision).ptr;
    std::string text = Shortened(std::string_view(buffer, end - buffer));
    if (text.size() <= columns)
    {
      return text;
    }
  }
  return {};
}

double ErrorOf(const std::string& text, double value)
{
  double read = std::numeric_limits<double>::infinity();
  std::from_chars(text.data(), text.data() + text.size(), read);
  return std::abs(read - value);
}

} // namespace

std::string ToColumnText(double value, std::size_t columns)
{
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  std::string exact = Shortened(std::string_view(buffer, end - buffer));
  if (exact.size() <= columns)
  {
    return exact;
  }
  const std::string fixed = ToNotation(value, columns, std::chars_format::fixed);
  const std::string scientific = ToNotation(value, columns, std::chars_format::scientific);
  return ErrorOf(fixed, value) < ErrorOf(scientific, value) ? fixed : scientific;
}

} // namespace shape
