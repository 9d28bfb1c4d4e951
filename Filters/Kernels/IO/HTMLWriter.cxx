#include "IO/HTMLWriter.h"

#include "Base/Errors.h"
#include "IO/Private/PageText.h"
#include "Mesh/CellFaces.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace shape
{
namespace
{

using namespace cell_kind;

std::string ToBase64(const std::vector<unsigned char>& bytes)
{
  static constexpr char letters[] =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      bits = bits << 8 | (k < count ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += k <= count ? letters[bits >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

/// Encodes numbers of four bytes: grouped by byte, deflated, in base64, as a JSON string.
template <typename Number>
std::string Encode(const std::vector<Number>& numbers)
{
  static_assert(sizeof(Number) == 4);
  std::vector<unsigned char> grouped(4 * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &numbers[i], 4);
    for (std::size_t k = 0; k < 4; ++k)
    {
      grouped[k * numbers.size() + i] = static_cast<unsigned char>(bits >> (8 * k) & 0xFFU);
    }
  }
  uLongf size = compressBound(grouped.size());
  std::vector<unsigned char> packed(size);
  if (compress2(packed.data(), &size, grouped.data(), grouped.size(), Z_BEST_COMPRESSION) != Z_OK)
  {
    throw SolveFailure("an array cannot be compressed; use a coarser mesh");
  }
  packed.resize(size);
  return '"' + ToBase64(packed) + '"';
}

/// Returns a JSON string that is also safe inside a page.
std::string Quote(const std::string& text)
{
  static constexpr char digits[] = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char letter : text)
  {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20 || letter == '"' || letter == '\\' || letter == '<' || letter == '>')
    {
      quoted += std::string("\\u00") + digits[code >> 4] + digits[code & 15];
    }
    else
    {
      quoted += letter;
    }
  }
  return quoted + '"';
}

/// VTK's cells of any number of points.
constexpr int PolyVertex = 2, PolyLine = 4, PagePolygon = 7;

/// Returns the cells that a page shows, in order. Throws InvalidInput.
std::vector<int> FindShownCells(const Cells& cells)
{
  std::vector<int> shown;
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    const int kind = cells.Kinds(cell);
    if (kind != PagePolygon && GetCornerCount(kind) == 0 && kind != PolyVertex && kind != PolyLine)
    {
      throw InvalidInput("the Input's cell " + std::to_string(cell) + " has VTK's cell type " +
        std::to_string(kind) + "; divide it with Tetrahedralize or Triangulate");
    }
    if (kind == PagePolygon || kind == Triangle || kind >= Quadrilateral)
    {
      shown.push_back(cell);
    }
  }
  if (shown.empty())
  {
    throw InvalidInput("the Input has no surface or solid cells; connect a mesh with such cells");
  }
  return shown;
}

std::vector<float> ToFloats(const Eigen::MatrixXd& points)
{
  std::vector<float> floats;
  floats.reserve(points.size());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      floats.push_back(static_cast<float>(points(i, k)));
    }
  }
  return floats;
}

} // namespace

void WriteHTML(std::ostream& file, const MeshPage& page, const Progress& progress)
{
  const Cells& mesh = page.Mesh;
  const std::vector<int> shown = FindShownCells(mesh);
  std::vector<std::int32_t> kinds, sizes, corners;
  std::int32_t before = 0;
  for (const int cell : shown)
  {
    kinds.push_back(mesh.Kinds(cell));
    sizes.push_back(mesh.Offsets(cell + 1) - mesh.Offsets(cell));
    for (int k = mesh.Offsets(cell); k < mesh.Offsets(cell + 1); ++k)
    {
      corners.push_back(mesh.Corners(k) - before);
      before = mesh.Corners(k);
    }
  }
  static constexpr std::string_view mark = "@MESH@";
  const std::string_view text = PageText;
  const std::size_t at = text.find(mark);
  file << text.substr(0, at) << "{\"title\":" << Quote(page.Title) << ",\"facts\":[";
  const char* separator = "";
  for (const auto& [name, value] : page.Facts)
  {
    file << separator << '[' << Quote(name) << ',' << Quote(value) << ']';
    separator = ",";
  }
  file << "],\n\"points\":" << Encode(ToFloats(mesh.Points)) << ",\n\"kinds\":" << Encode(kinds)
       << ",\n\"sizes\":" << Encode(sizes) << ",\n\"corners\":" << Encode(corners)
       << ",\n\"arrays\":[";
  progress(0.5);
  separator = "\n";
  for (std::size_t i = 0; i < page.Arrays.size(); ++i)
  {
    const PageArray& array = page.Arrays[i];
    std::vector<float> values;
    if (array.IsOfCells)
    {
      for (const int cell : shown)
      {
        const auto first =
          array.Values.begin() + static_cast<std::ptrdiff_t>(cell) * array.Components;
        values.insert(values.end(), first, first + array.Components);
      }
    }
    file << separator << "{\"name\":" << Quote(array.Name) << ",\"on\":\""
         << (array.IsOfCells ? "cell" : "point") << "\",\"components\":" << array.Components
         << ",\"values\":" << Encode(array.IsOfCells ? values : array.Values) << '}';
    separator = ",\n";
    progress(0.5 + 0.5 * static_cast<double>(i + 1) / static_cast<double>(page.Arrays.size()));
  }
  file << "]}" << text.substr(at + mark.size());
  progress(1.0);
}

} // namespace shape
