#include "IO/Private/DeckText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

namespace shape
{
namespace
{

bool IsDeckBlank(char letter)
{
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n';
}

std::string_view WithoutPlus(std::string_view text)
{
  text.remove_prefix(!text.empty() && text.front() == '+' ? 1 : 0);
  return text;
}

} // namespace

bool DeckLines::Next()
{
  if (this->After >= this->Text.size())
  {
    return false;
  }
  this->First = this->After;
  const std::size_t end = this->Text.find('\n', this->First);
  this->After = end == std::string_view::npos ? this->Text.size() : end + 1;
  this->Current = this->Text.substr(
    this->First, (end == std::string_view::npos ? this->Text.size() : end) - this->First);
  if (!this->Current.empty() && this->Current.back() == '\r')
  {
    this->Current.remove_suffix(1);
  }
  ++this->Count;
  return true;
}

std::string_view Trimmed(std::string_view text)
{
  while (!text.empty() && IsDeckBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsDeckBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

std::string InUpperCase(std::string_view text)
{
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
    [](char letter) { return letter >= 'a' && letter <= 'z' ? char(letter - 'a' + 'A') : letter; });
  return upper;
}

void SplitAtCommas(std::string_view text, std::vector<std::string_view>& parts)
{
  parts.clear();
  for (std::size_t begin = 0;;)
  {
    const std::size_t end = text.find(',', begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos)
    {
      return;
    }
    begin = end + 1;
  }
}

bool ReadDeckInteger(std::string_view text, std::int64_t& value)
{
  text = WithoutPlus(Trimmed(text));
  const char* end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && next == end;
}

bool ReadDeckNumber(std::string_view text, double& value)
{
  text = WithoutPlus(Trimmed(text));
  value = 0.0;
  if (text.empty())
  {
    return true;
  }
  const char* end = text.data() + text.size();
  auto [next, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && next == end)
  {
    return std::isfinite(value);
  }
  // An exponent with D, or with a sign alone.
  std::string rewritten;
  for (const char letter : text)
  {
    const bool isBare =
      (letter == '+' || letter == '-') && !rewritten.empty() && rewritten.back() != 'e';
    rewritten += isBare ? "e" : "";
    rewritten += std::strchr("dDeE", letter) ? 'e' : letter;
  }
  end = rewritten.data() + rewritten.size();
  const auto [last, failure] =
    std::from_chars(static_cast<const char*>(rewritten.data()), end, value);
  return failure == std::errc() && last == end && std::isfinite(value);
}

} // namespace shape
