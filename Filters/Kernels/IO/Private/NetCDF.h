#pragma once

#include "Base/Progress.h"

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace shape
{

/**
 * A file in netCDF's classic format with 64-bit offsets ("NetCDF Classic Format Specification",
 * Unidata), which is written in one pass.
 */
class NetCDF
{
public:
  using Value = std::variant<std::string, int, float>;

  struct Attribute
  {
    std::string Name;
    Value Content;
  };

  /// Adds a dimension and returns its number. length: 0 is the unlimited dimension, without
  /// records.
  int AddDimension(const std::string& name, std::size_t length);

  void AddAttribute(const std::string& name, const Value& value)
  {
    this->Attributes.push_back({ name, value });
  }

  /// Adds a variable over some dimensions. `at` returns its values, in the order of the file.
  /// Throws InvalidInput if it has 4 GiB or more.
  ///@{
  void AddIntegers(const std::string& name, const std::vector<int>& dimensions,
    std::function<int(std::size_t)> at, const std::vector<Attribute>& attributes = {});
  void AddDoubles(const std::string& name, const std::vector<int>& dimensions,
    std::function<double(std::size_t)> at);
  ///@}

  /// Adds a list of texts, each of `width` characters with zeros at the end. dimensions: of the
  /// list and of the width.
  void AddTexts(const std::string& name, const std::vector<int>& dimensions,
    const std::vector<std::string>& texts, std::size_t width);

  /// Writes the file. Throws Aborted. The caller checks `file` for write errors.
  void Write(std::ostream& file, const Progress& progress) const;

private:
  struct Dimension
  {
    std::string Name;
    std::size_t Length;
  };

  struct Variable
  {
    std::string Name;
    std::vector<int> Dimensions;
    std::vector<Attribute> Attributes;
    int Type;
    std::size_t Count;                          ///< of values
    std::size_t Width;                          ///< bytes of a value
    std::function<std::string(std::size_t)> At; ///< the bytes of a value
  };

  void AddVariable(Variable variable);
  std::string MakeHeader(const std::vector<std::uint64_t>& offsets) const;

  std::vector<Dimension> Dimensions;
  std::vector<Attribute> Attributes;
  std::vector<Variable> Variables;
};

} // namespace shape
