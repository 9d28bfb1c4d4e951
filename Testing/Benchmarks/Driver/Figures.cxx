#include "Driver/Figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace benchmark
{
namespace
{

constexpr std::size_t LongestRow = 12;                      // of a table; a longer one is a list
constexpr int NumberWidth = 10, TextWidth = 16, Digits = 5; // for people

std::string FormatNumber(double value, int digits)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.*g", digits, value);
  return text;
}

/// Converts a value to text; `number` and `quote` convert its parts.
template <typename Number, typename Quote>
std::string ToText(const Row::Value& value, const Number& number, const Quote& quote,
  const char* open, const char* separator, const char* close)
{
  if (const auto* single = std::get_if<double>(&value))
  {
    return number(*single);
  }
  if (const auto* count = std::get_if<long>(&value))
  {
    return std::to_string(*count);
  }
  if (const auto* words = std::get_if<std::string>(&value))
  {
    return quote(*words);
  }
  std::string text = open;
  for (const double each : std::get<std::vector<double>>(value))
  {
    text += (text == open ? "" : separator) + number(each);
  }
  return text + close;
}

std::string Quote(const std::string& words)
{
  std::string text = "\"";
  for (const char letter : words)
  {
    if (letter == '"' || letter == '\\')
    {
      text += '\\';
    }
    text += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter; // line breaks
  }
  return text + '"';
}

std::string ToJson(const Row::Value& value)
{
  // JSON has no NaN and no infinity.
  return ToText(
    value, [](double number) { return std::isfinite(number) ? FormatNumber(number, 17) : "null"; },
    Quote, "[", ", ", "]");
}

std::string ToWords(const Row::Value& value)
{
  return ToText(
    value, [](double number) { return FormatNumber(number, Digits); },
    [](const std::string& words) { return words; }, "", " ", "");
}

} // namespace

Row& Row::Add(const Cost& cost)
{
  return this->Add("cpu", cost.Cpu).Add("wall", cost.Wall).Add("mib", cost.MiB);
}

Row& Row::Append(const Row& other)
{
  this->Items.insert(this->Items.end(), other.Items.begin(), other.Items.end());
  return *this;
}

void Figures::Print(const Row& row)
{
  const auto& items = row.GetItems();
  if (this->Format == FormatType::Json)
  {
    std::string line = "{";
    for (const auto& [name, value] : items)
    {
      line += (line.size() > 1 ? ", " : "") + Quote(name) + ": " + ToJson(value);
    }
    std::printf("%s}\n", line.c_str());
  }
  else if (items.size() > LongestRow)
  {
    std::size_t width = 0;
    for (const auto& item : items)
    {
      width = std::max(width, item.first.size());
    }
    for (const auto& [name, value] : items)
    {
      std::printf("%-*s  %s\n", static_cast<int>(width), name.c_str(), ToWords(value).c_str());
    }
    this->Header.clear();
  }
  else
  {
    std::vector<std::string> names;
    for (const auto& item : items)
    {
      names.push_back(item.first);
    }
    const auto width = [](const std::pair<std::string, Row::Value>& item)
    {
      const bool isText = std::holds_alternative<std::string>(item.second);
      return std::max(isText ? TextWidth : NumberWidth, static_cast<int>(item.first.size()));
    };
    if (names != this->Header)
    {
      for (const auto& item : items)
      {
        std::printf("%*s ", width(item), item.first.c_str());
      }
      std::printf("\n");
      this->Header = names;
    }
    for (const auto& item : items)
    {
      std::printf("%*s ", width(item), ToWords(item.second).c_str());
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

} // namespace benchmark
