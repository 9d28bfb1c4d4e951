// benchmark [CASE ARGUMENTS ... [--json | --help]]: measures one case in a process of its own and
// prints its figures. Without a case it lists all of them.
// Exits with 0 if there are figures, with 1 if the computation failed, with 2 if the model is not
// one that the case applies to, with 64 if the arguments are wrong.
#include "Driver/Case.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace
{

enum ExitCode
{
  Done = 0,
  Failed = 1,
  DoesNotApply = 2,
  WrongUsage = 64
};

int ListCases()
{
  std::puts("benchmark CASE ARGUMENTS ... [--json]   figures, for people or for scripts\n"
            "benchmark CASE --help                   what the arguments and the figures mean\n");
  for (const auto& [name, each] : benchmark::Cases())
  {
    std::printf("%-17s %s\n", name.c_str(), each.Usage.substr(0, each.Usage.find('\n')).c_str());
  }
  return Done;
}

/// Removes the word; returns whether it was there.
bool Take(std::vector<std::string>& words, const std::string& word)
{
  const auto end = std::remove(words.begin(), words.end(), word);
  const bool isThere = end != words.end();
  words.erase(end, words.end());
  return isThere;
}

int Run(const std::string& name, std::vector<std::string> words)
{
  const auto found = benchmark::Cases().find(name);
  if (found == benchmark::Cases().end())
  {
    std::fprintf(stderr, "There is no case \"%s\" in this program.\n", name.c_str());
    return WrongUsage;
  }
  if (Take(words, "--help"))
  {
    std::printf("benchmark %s %s\n", name.c_str(), found->second.Usage.c_str());
    return Done;
  }
  using Format = benchmark::Figures::FormatType;
  benchmark::Figures figures(Take(words, "--json") ? Format::Json : Format::Table);
  benchmark::Arguments arguments(words);
  try
  {
    found->second.Run(arguments, figures);
    return Done;
  }
  catch (const benchmark::UsageError& error)
  {
    std::fprintf(
      stderr, "%s\n\nbenchmark %s %s\n", error.what(), name.c_str(), found->second.Usage.c_str());
    return WrongUsage;
  }
  catch (const shape::InvalidInput& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return DoesNotApply;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return Failed;
  }
}

} // namespace

std::map<std::string, benchmark::Case>& benchmark::Cases()
{
  static std::map<std::string, Case> cases;
  return cases;
}

int main(int count, char** words)
{
  const std::vector<std::string> arguments(words + 1, words + count);
  return arguments.empty() ? ListCases()
                           : Run(arguments.front(), { arguments.begin() + 1, arguments.end() });
}
