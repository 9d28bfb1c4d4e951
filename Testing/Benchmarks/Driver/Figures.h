#pragma once

#include "Driver/Cost.h"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace benchmark
{

/// Figures with their names, in the order in which they are printed.
class Row
{
public:
  using Value = std::variant<double, long, std::string, std::vector<double>>;

  /// A number, words, or a list of numbers.
  template <typename T>
  Row& Add(const std::string& name, const T& value)
  {
    if constexpr (std::is_integral_v<T>)
    {
      this->Items.emplace_back(name, static_cast<long>(value));
    }
    else
    {
      this->Items.emplace_back(name, value);
    }
    return *this;
  }
  /// As cpu, wall (seconds) and mib.
  Row& Add(const Cost& cost);
  /// Those of another row, after its own.
  Row& Append(const Row& other);

  const std::vector<std::pair<std::string, Value>>& GetItems() const { return this->Items; }

private:
  std::vector<std::pair<std::string, Value>> Items;
};

/// Prints what a case measures, a row at a time, each as soon as it is known.
class Figures
{
public:
  enum class FormatType
  {
    Table, ///< for people: rows of the same figures below each other, long rows as a list
    Json   ///< for scripts: an object for each row on a line of its own, numbers to the last bit
  };

  explicit Figures(FormatType format)
    : Format(format)
  {
  }
  void Print(const Row& row);

private:
  FormatType Format;
  std::vector<std::string> Header; ///< names of the row before, if it was printed in a table
};

} // namespace benchmark
