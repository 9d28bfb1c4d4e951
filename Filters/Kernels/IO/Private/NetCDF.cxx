#include "IO/Private/NetCDF.h"

#include "Base/Errors.h"

#include <cstring>
#include <utility>

namespace shape
{
namespace
{

// Codes of the format.
constexpr std::uint32_t dimensionList = 10, variableList = 11, attributeList = 12;
constexpr int characterType = 2, integerType = 4, floatType = 5, doubleType = 6;

/// Returns the bytes of a number, the most significant one first.
template <class Unsigned, class Number>
std::string ToBytes(Number number)
{
  static_assert(sizeof(Unsigned) == sizeof(Number));
  Unsigned bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  std::string bytes(sizeof(bits), '\0');
  for (std::size_t k = sizeof(bits); k-- > 0; bits >>= 8)
  {
    bytes[k] = static_cast<char>(bits & 0xff);
  }
  return bytes;
}

std::string ToWord(std::size_t number)
{
  return ToBytes<std::uint32_t>(static_cast<std::uint32_t>(number));
}

/// Fills up to a multiple of four bytes.
std::string Padded(std::string bytes)
{
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  return bytes;
}

std::string ToName(const std::string& name)
{
  return ToWord(name.size()) + Padded(name);
}

/// Returns the head of a list: its code and length, or zeros if it is empty.
std::string ToListHead(std::uint32_t code, std::size_t length)
{
  return ToWord(length == 0 ? 0 : code) + ToWord(length);
}

std::string ToAttributes(const std::vector<NetCDF::Attribute>& attributes)
{
  std::string bytes = ToListHead(attributeList, attributes.size());
  for (const auto& [name, value] : attributes)
  {
    bytes += ToName(name);
    if (const auto* text = std::get_if<std::string>(&value))
    {
      bytes += ToWord(characterType) + ToName(*text);
    }
    else if (const auto* number = std::get_if<int>(&value))
    {
      bytes += ToWord(integerType) + ToWord(1) + ToBytes<std::uint32_t>(*number);
    }
    else
    {
      bytes += ToWord(floatType) + ToWord(1) + ToBytes<std::uint32_t>(std::get<float>(value));
    }
  }
  return bytes;
}

} // namespace

int NetCDF::AddDimension(const std::string& name, std::size_t length)
{
  this->Dimensions.push_back({ name, length });
  return static_cast<int>(this->Dimensions.size()) - 1;
}

void NetCDF::AddVariable(Variable variable)
{
  variable.Count = 1;
  for (const int dimension : variable.Dimensions)
  {
    variable.Count *= this->Dimensions[dimension].Length;
  }
  if (variable.Count * variable.Width >= (std::uint64_t(1) << 32) - 4)
  {
    throw InvalidInput("the mesh is too large for the file format, in which " + variable.Name +
      " has less than 4 GiB; give its parts different regions, or write them to several files");
  }
  this->Variables.push_back(std::move(variable));
}

void NetCDF::AddIntegers(const std::string& name, const std::vector<int>& dimensions,
  std::function<int(std::size_t)> at, const std::vector<Attribute>& attributes)
{
  this->AddVariable({ name, dimensions, attributes, integerType, 0, 4,
    [at = std::move(at)](std::size_t i) { return ToBytes<std::uint32_t>(at(i)); } });
}

void NetCDF::AddDoubles(const std::string& name, const std::vector<int>& dimensions,
  std::function<double(std::size_t)> at)
{
  this->AddVariable({ name, dimensions, {}, doubleType, 0, 8,
    [at = std::move(at)](std::size_t i) { return ToBytes<std::uint64_t>(at(i)); } });
}

void NetCDF::AddTexts(const std::string& name, const std::vector<int>& dimensions,
  const std::vector<std::string>& texts, std::size_t width)
{
  std::string letters;
  for (const std::string& text : texts)
  {
    letters += text.substr(0, width);
    letters.resize((letters.size() + width - 1) / width * width, '\0');
  }
  this->AddVariable({ name, dimensions, {}, characterType, 0, 1,
    [letters](std::size_t i) { return std::string(1, letters[i]); } });
}

std::string NetCDF::MakeHeader(const std::vector<std::uint64_t>& offsets) const
{
  std::string header = std::string("CDF\2") + ToWord(0); // no records
  header += ToListHead(dimensionList, this->Dimensions.size());
  for (const Dimension& dimension : this->Dimensions)
  {
    header += ToName(dimension.Name) + ToWord(dimension.Length);
  }
  header += ToAttributes(this->Attributes) + ToListHead(variableList, this->Variables.size());
  for (std::size_t i = 0; i < this->Variables.size(); ++i)
  {
    const Variable& variable = this->Variables[i];
    header += ToName(variable.Name) + ToWord(variable.Dimensions.size());
    for (const int dimension : variable.Dimensions)
    {
      header += ToWord(static_cast<std::size_t>(dimension));
    }
    header += ToAttributes(variable.Attributes) + ToWord(static_cast<std::size_t>(variable.Type)) +
      ToWord((variable.Count * variable.Width + 3) / 4 * 4) + ToBytes<std::uint64_t>(offsets[i]);
  }
  return header;
}

void NetCDF::Write(std::ostream& file, const Progress& progress) const
{
  // The length of the header does not depend on the offsets in it.
  std::vector<std::uint64_t> offsets(this->Variables.size());
  std::uint64_t end = this->MakeHeader(offsets).size();
  std::size_t count = 0;
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    offsets[i] = end;
    end += (this->Variables[i].Count * this->Variables[i].Width + 3) / 4 * 4;
    count += this->Variables[i].Count;
  }
  file << this->MakeHeader(offsets);
  std::size_t done = 0;
  for (const Variable& variable : this->Variables)
  {
    for (std::size_t i = 0; i < variable.Count; ++i)
    {
      file << variable.At(i);
      if (++done % 65536 == 0)
      {
        progress(static_cast<double>(done) / static_cast<double>(count));
      }
    }
    file << std::string((4 - variable.Count * variable.Width % 4) % 4, '\0');
  }
}

} // namespace shape
