#include "Driver/Arguments.h"

#include <cstddef>

namespace benchmark
{
namespace
{

template <typename Convert>
auto ToNumber(const std::string& word, const Convert& convert)
{
  std::size_t length = 0;
  try
  {
    const auto number = convert(word, &length);
    if (length == word.size())
    {
      return number;
    }
  }
  catch (const std::logic_error&) // std::stod's
  {
  }
  throw UsageError("\"" + word + "\" is not a number");
}

double ToDouble(const std::string& word)
{
  return ToNumber(word, [](const auto& text, auto* length) { return std::stod(text, length); });
}

int ToInteger(const std::string& word)
{
  return ToNumber(word, [](const auto& text, auto* length) { return std::stoi(text, length); });
}

} // namespace

Arguments::Arguments(const std::vector<std::string>& words)
{
  for (const std::string& word : words)
  {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
    {
      this->Words.push_back(word);
    }
    else
    {
      this->Settings[word.substr(0, sign)] = word.substr(sign + 1);
    }
  }
}

std::string Arguments::NextWord()
{
  if (this->Words.empty())
  {
    throw UsageError("an argument is missing");
  }
  std::string word = this->Words.front();
  this->Words.erase(this->Words.begin());
  return word;
}

double Arguments::NextNumber()
{
  return ToDouble(this->NextWord());
}

int Arguments::NextInteger()
{
  return ToInteger(this->NextWord());
}

std::vector<std::string> Arguments::RemainingWords()
{
  std::vector<std::string> words;
  words.swap(this->Words);
  return words;
}

std::string Arguments::Setting(const std::string& key, const std::string& usual)
{
  const auto found = this->Settings.find(key);
  if (found == this->Settings.end())
  {
    return usual;
  }
  std::string value = found->second;
  this->Settings.erase(found);
  return value;
}

double Arguments::Setting(const std::string& key, double usual)
{
  const std::string value = this->Setting(key, std::string());
  return value.empty() ? usual : ToDouble(value);
}

int Arguments::Setting(const std::string& key, int usual)
{
  const std::string value = this->Setting(key, std::string());
  return value.empty() ? usual : ToInteger(value);
}

bool Arguments::Setting(const std::string& key, bool usual)
{
  return this->Setting(key, usual ? 1 : 0) != 0;
}

void Arguments::RequireAllRead() const
{
  if (!this->Words.empty())
  {
    throw UsageError("unexpected argument \"" + this->Words.front() + "\"");
  }
  if (!this->Settings.empty())
  {
    throw UsageError("unknown setting \"" + this->Settings.begin()->first + "\"");
  }
}

} // namespace benchmark
