#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark
{

/// The arguments of a case are missing, unknown or no numbers.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The words of a command line: positional ones, and settings KEY=VALUE, in any order.
class Arguments
{
public:
  explicit Arguments(const std::vector<std::string>& words);

  /// The next positional word. Throws UsageError if there is none.
  std::string NextWord();
  double NextNumber();
  int NextInteger();
  /// What the next word is the name of. Throws UsageError if it is none of them.
  template <typename T>
  T NextChoice(const std::map<std::string, T>& choices)
  {
    const std::string word = this->NextWord();
    const auto found = choices.find(word);
    if (found == choices.end())
    {
      throw UsageError("\"" + word + "\" is not known");
    }
    return found->second;
  }
  /// All that are left.
  std::vector<std::string> RemainingWords();

  /// A setting, or what it is by default.
  std::string Setting(const std::string& key, const std::string& usual);
  std::string Setting(const std::string& key, const char* usual)
  {
    return this->Setting(key, std::string(usual));
  }
  double Setting(const std::string& key, double usual);
  int Setting(const std::string& key, int usual);
  bool Setting(const std::string& key, bool usual);

  /// Throws UsageError, which names it, if a word or a setting was not asked for.
  void RequireAllRead() const;

private:
  std::vector<std::string> Words; ///< positional, the next one first
  std::map<std::string, std::string> Settings;
};

} // namespace benchmark
