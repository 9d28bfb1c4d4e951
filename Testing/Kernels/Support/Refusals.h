#pragma once

#include "Base/Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Functions shared by the tests of refused input.
namespace shapetest
{

/// Returns the message of the Error that a call throws; empty if it throws none.
template <class Error = shape::InvalidInput>
std::string Refusal(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

/// Checks that a refusal contains all of these words: the fact and the remedy.
inline testing::AssertionResult HasWords(
  const std::string& refusal, const std::vector<std::string>& words)
{
  if (refusal.empty())
  {
    return testing::AssertionFailure() << "it is not refused";
  }
  const auto missing = std::find_if(words.begin(), words.end(),
    [&](const std::string& word) { return refusal.find(word) == std::string::npos; });
  if (missing != words.end())
  {
    return testing::AssertionFailure() << "'" << *missing << "' is not in: " << refusal;
  }
  return testing::AssertionSuccess();
}

/// EXPECT_REFUSED(statement, word, ...) expects an InvalidInput that contains all of the words.
#define EXPECT_REFUSED(statement, ...)                                                             \
  EXPECT_TRUE(shapetest::HasWords(                                                                 \
    shapetest::Refusal([&] { static_cast<void>(statement); }), { __VA_ARGS__ }))

/// EXPECT_UNSOLVED(statement, word, ...): it throws SolveFailure with all of the words.
#define EXPECT_UNSOLVED(statement, ...)                                                            \
  EXPECT_TRUE(shapetest::HasWords(                                                                 \
    shapetest::Refusal<shape::SolveFailure>([&] { static_cast<void>(statement); }),                \
    { __VA_ARGS__ }))

/// A row of a table of refusals: an option, an invalid value of it, and words of the message.
template <class Options>
struct RefusedOption
{
  /// option: a member of Options, or of a base class of it.
  template <class Owner, class Value>
  RefusedOption(
    Value Owner::*option, std::common_type_t<Value> value, std::vector<std::string> words)
    : Set([option, value](Options& options) { options.*option = value; })
    , Words(std::move(words))
  {
  }

  std::function<void(Options&)> Set;
  std::vector<std::string> Words;
};

/// Expects that the call refuses good options if one of them is replaced by that of a row.
template <class Options>
void ExpectRefused(const std::function<void(const Options&)>& call, const Options& good,
  const std::vector<RefusedOption<Options>>& table)
{
  for (const RefusedOption<Options>& row : table)
  {
    Options options = good;
    row.Set(options);
    EXPECT_TRUE(HasWords(Refusal([&] { call(options); }), row.Words));
  }
}

} // namespace shapetest
