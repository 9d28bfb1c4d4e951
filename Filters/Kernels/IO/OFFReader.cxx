#include "IO/OFFReader.h"

#include "Base/Errors.h"
#include "IO/Private/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

namespace shape
{
namespace
{

/// The keyword of the file: [ST][C][N]OFF.
struct OFFKeyword
{
  bool Textures = false, Colored = false, Normals = false;
};

OFFKeyword ParseOFFKeyword(std::string word, const NumberText& text)
{
  const auto take = [&](const char* prefix)
  {
    const bool taken = word.rfind(prefix, 0) == 0;
    word.erase(0, taken ? std::strlen(prefix) : 0);
    return taken;
  };
  const std::string whole = word;
  OFFKeyword keyword;
  keyword.Textures = take("ST");
  keyword.Colored = take("C");
  keyword.Normals = take("N");
  if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
  {
    text.Refuse(whole + " has points of another dimension than 3; export it as OFF");
  }
  if (word != "OFF")
  {
    text.Refuse("'" + whole.substr(0, 20) + "' is no keyword of an OFF file; choose another file");
  }
  return keyword;
}

/// Numbers from one line: at most `Most` of them.
struct ColorText
{
  static constexpr int Most = 8;
  std::array<double, Most> Numbers{};
  int Count = 0;

  void Read(NumberText& text, const char* what)
  {
    for (this->Count = 0; !text.IsAtLineEnd(); ++this->Count)
    {
      if (this->Count == Most)
      {
        text.Refuse(std::string("there are too many numbers after ") + what +
          "; write each vertex and face on its own line");
      }
      this->Numbers[this->Count] = text.ReadNumber(what);
    }
  }
};

/// Colours are collected with four components, and lose the fourth if no colour has it.
class ColorCollector
{
public:
  explicit ColorCollector(std::size_t count)
    : Values(4 * count, 255)
  {
  }

  /// Sets the colour of an item: three or four numbers.
  void Set(std::size_t item, const double* numbers, int count)
  {
    this->Any = true;
    this->Alpha = this->Alpha || count == 4;
    const bool unit = std::all_of(numbers, numbers + count, [](double x) { return x <= 1.0; });
    for (int k = 0; k < count; ++k)
    {
      const double value = unit ? 255.0 * numbers[k] : numbers[k];
      this->Values[4 * item + k] =
        static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  }

  /// Makes an item grey, as Geomview does.
  void SetDefault(std::size_t item)
  {
    std::fill_n(this->Values.begin() + static_cast<std::ptrdiff_t>(4 * item), 3, 170);
  }

  OFFSurface::Colors Finish() const
  {
    OFFSurface::Colors colors;
    colors.Components = !this->Any ? 0 : this->Alpha ? 4 : 3;
    for (std::size_t i = 0; i < this->Values.size() && this->Any; ++i)
    {
      if (this->Alpha || i % 4 != 3)
      {
        colors.Values.push_back(this->Values[i]);
      }
    }
    return colors;
  }

private:
  std::vector<std::uint8_t> Values;
  bool Any = false, Alpha = false;
};

/// What both forms of the file fill.
struct OFFBuilder
{
  OFFBuilder(int pointCount, int faceCount, const OFFKeyword& keyword)
    : PointColors(pointCount)
    , FaceColors(faceCount)
  {
    this->Surface.Faces.Points.resize(pointCount, 3);
    this->Surface.Faces.Kinds.resize(faceCount);
    this->Surface.Faces.Offsets = Eigen::VectorXi::Zero(faceCount + 1);
    this->Surface.Normals.resize(keyword.Normals ? pointCount : 0, 3);
    this->Surface.TextureCoordinates.resize(keyword.Textures ? pointCount : 0, 2);
    this->Corners.reserve(3 * static_cast<std::size_t>(faceCount));
  }

  void AddCorner(int corner) { this->Corners.push_back(corner); }

  void EndFace(int face)
  {
    Cells& faces = this->Surface.Faces;
    faces.Offsets(face + 1) = static_cast<int>(this->Corners.size());
    const int size = faces.Offsets(face + 1) - faces.Offsets(face);
    faces.Kinds(face) = size == 1 ? cell_kind::Vertex
      : size == 2                 ? cell_kind::Line
                                  : OFFSurface::PolygonKind;
  }

  void SetFaceColor(int face, const double* numbers, int count)
  {
    if (count == 0)
    {
      this->FaceColors.SetDefault(face);
    }
    else if (count == 1)
    {
      this->Surface.FaceColorIndices.resize(this->Surface.Faces.Kinds.size(), -1);
      this->Surface.FaceColorIndices[face] = static_cast<int>(numbers[0]);
    }
    else
    {
      this->FaceColors.Set(face, numbers, count);
    }
  }

  OFFSurface Finish()
  {
    this->Surface.Faces.Corners = Eigen::Map<const Eigen::VectorXi>(
      this->Corners.data(), static_cast<Eigen::Index>(this->Corners.size()));
    this->Surface.PointColors = this->PointColors.Finish();
    this->Surface.FaceColors = this->FaceColors.Finish();
    return std::move(this->Surface);
  }

  OFFSurface Surface;
  std::vector<int> Corners;
  ColorCollector PointColors, FaceColors;
};

/// Returns what is wrong with the counts of a file that has `bytes` for them, or an empty string.
std::string FindWrongCount(int points, int faces, std::size_t bytes, std::size_t bytesEach)
{
  if (points < 1 || faces < 0)
  {
    return "the file declares " + std::to_string(points) + " vertices and " +
      std::to_string(faces) + " faces; there must be at least one vertex";
  }
  // Before anything of this size is allocated.
  if ((static_cast<std::size_t>(points) + static_cast<std::size_t>(faces)) > bytes / bytesEach)
  {
    return "the file declares " + std::to_string(points) + " vertices and " +
      std::to_string(faces) + " faces, and is too short for them; it is incomplete";
  }
  return {};
}

std::string DescribeWrongCorner(int corner, int points)
{
  return "a face refers to vertex " + std::to_string(corner) + ", but vertices are 0 to " +
    std::to_string(points - 1) + "; repair the file";
}

void ReadVertexLines(
  NumberText& text, const OFFKeyword& keyword, OFFBuilder& builder, const Progress& progress)
{
  Eigen::MatrixXd& points = builder.Surface.Faces.Points;
  ColorText rest;
  for (Eigen::Index point = 0; point < points.rows(); ++point)
  {
    for (int k = 0; k < 3; ++k)
    {
      points(point, k) = text.ReadNumber("a vertex");
    }
    for (int k = 0; k < 3 && keyword.Normals; ++k)
    {
      builder.Surface.Normals(point, k) = text.ReadNumber("a normal");
    }
    rest.Read(text, "a vertex");
    int colors = rest.Count;
    if (keyword.Textures)
    {
      colors -= 2;
      for (int k = 0; k < 2 && colors >= 0; ++k)
      {
        builder.Surface.TextureCoordinates(point, k) = rest.Numbers[colors + k];
      }
    }
    if (colors != 0 && colors != 3 && colors != 4)
    {
      text.Refuse("a vertex is followed by " + std::to_string(rest.Count) +
        " numbers; a colour has 3 or 4, and each vertex is on its own line");
    }
    if (colors > 0)
    {
      builder.PointColors.Set(point, rest.Numbers.data(), colors);
    }
    if (point % 65536 == 0)
    {
      progress(static_cast<double>(point) / static_cast<double>(points.rows()));
    }
  }
}

void ReadFaceLines(NumberText& text, OFFBuilder& builder, const Progress& progress)
{
  const int points = static_cast<int>(builder.Surface.Faces.Points.rows());
  const int faces = static_cast<int>(builder.Surface.Faces.Kinds.size());
  ColorText color;
  for (int face = 0; face < faces; ++face)
  {
    const int size = text.ReadInteger("a face");
    if (size < 1)
    {
      text.Refuse("a face has " + std::to_string(size) + " vertices; remove it from the file");
    }
    for (int k = 0; k < size; ++k)
    {
      const int corner = text.ReadInteger("a face");
      if (corner < 0 || corner >= points)
      {
        text.Refuse(DescribeWrongCorner(corner, points));
      }
      builder.AddCorner(corner);
    }
    builder.EndFace(face);
    color.Read(text, "a face");
    if (color.Count == 2 || color.Count > 4)
    {
      text.Refuse("a face is followed by " + std::to_string(color.Count) +
        " numbers; a colour has 1, 3 or 4, and each face is on its own line");
    }
    builder.SetFaceColor(face, color.Numbers.data(), color.Count);
    if (face % 65536 == 0)
    {
      progress(static_cast<double>(face) / static_cast<double>(faces));
    }
  }
}

/// The binary form: numbers of 32 bits, most significant byte first.
class BigEndianNumbers
{
public:
  explicit BigEndianNumbers(std::string_view bytes)
    : Bytes(bytes)
  {
  }

  std::size_t CountBytesLeft() const { return this->Bytes.size(); }

  std::uint32_t ReadBits()
  {
    if (this->Bytes.size() < 4)
    {
      throw InvalidInput("the binary file ends too early; it is incomplete");
    }
    std::uint32_t bits = 0;
    for (int k = 0; k < 4; ++k)
    {
      bits = bits << 8 | static_cast<unsigned char>(this->Bytes[k]);
    }
    this->Bytes.remove_prefix(4);
    return bits;
  }

  int ReadInteger() { return static_cast<int>(this->ReadBits()); }

  double ReadNumber()
  {
    const std::uint32_t bits = this->ReadBits();
    float number = 0.0F;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number))
    {
      throw InvalidInput("the binary file has a number that is not finite; repair the file");
    }
    return number;
  }

private:
  std::string_view Bytes;
};

OFFSurface ReadBinaryOFF(
  std::string_view bytes, const OFFKeyword& keyword, const Progress& progress)
{
  BigEndianNumbers numbers(bytes);
  const int points = numbers.ReadInteger(), faces = numbers.ReadInteger();
  numbers.ReadInteger(); // edges
  const std::string wrong = FindWrongCount(points, faces, numbers.CountBytesLeft(), 12);
  if (!wrong.empty())
  {
    throw InvalidInput(wrong);
  }
  OFFBuilder builder(points, faces, keyword);
  const auto readRow = [&](auto&& row)
  {
    for (double& number : row)
    {
      number = numbers.ReadNumber();
    }
  };
  std::array<double, 4> color{};
  for (int point = 0; point < points; ++point)
  {
    readRow(builder.Surface.Faces.Points.row(point));
    if (keyword.Normals)
    {
      readRow(builder.Surface.Normals.row(point));
    }
    if (keyword.Colored)
    {
      readRow(color);
      builder.PointColors.Set(point, color.data(), 4);
    }
    if (keyword.Textures)
    {
      readRow(builder.Surface.TextureCoordinates.row(point));
    }
  }
  progress(0.5);
  for (int face = 0; face < faces; ++face)
  {
    const auto refuse = [face](const std::string& problem)
    { throw InvalidInput("face " + std::to_string(face) + ": " + problem); };
    const int size = numbers.ReadInteger();
    if (size < 1 || static_cast<std::size_t>(size) > numbers.CountBytesLeft() / 4)
    {
      refuse("it has " + std::to_string(size) + " vertices; repair the file");
    }
    for (int k = 0; k < size; ++k)
    {
      const int corner = numbers.ReadInteger();
      if (corner < 0 || corner >= points)
      {
        refuse(DescribeWrongCorner(corner, points));
      }
      builder.AddCorner(corner);
    }
    builder.EndFace(face);
    const int count = numbers.ReadInteger();
    if (count < 0 || count > 4 || count == 2)
    {
      refuse("its colour has " + std::to_string(count) + " numbers; there must be 0, 1, 3 or 4");
    }
    for (int k = 0; k < count; ++k)
    {
      color[k] = numbers.ReadNumber();
    }
    builder.SetFaceColor(face, color.data(), count);
  }
  progress(1.0);
  return builder.Finish();
}

} // namespace

OFFSurface ReadOFF(std::string_view content, const Progress& progress)
{
  NumberText text(content);
  OFFKeyword keyword;
  NumberText ahead = text;
  const std::string first(ahead.ReadWord("the keyword OFF"));
  if (!text.IsAtNumber() || first.find("OFF") != std::string::npos)
  {
    keyword = ParseOFFKeyword(first, text);
    text = ahead;
    if (!text.IsAtLineEnd() && !text.IsAtNumber())
    {
      const std::string word(text.ReadWord("the counts"));
      if (word != "BINARY")
      {
        text.Refuse("'" + word.substr(0, 20) + "' follows OFF; the number of vertices must");
      }
      text.SkipLine();
      return ReadBinaryOFF(
        content.substr(content.size() - text.CountBytesLeft()), keyword, progress);
    }
  }
  const int points = text.ReadInteger("the number of vertices");
  const int faces = text.ReadInteger("the number of faces");
  // A line of a face has at least "1 0" and its end, which the last line may lack.
  const std::string wrong = FindWrongCount(points, faces, text.CountBytesLeft() + 1, 4);
  if (!wrong.empty())
  {
    text.Refuse(wrong);
  }
  text.SkipLine(); // the number of edges, which may be missing
  OFFBuilder builder(points, faces, keyword);
  ReadVertexLines(text, keyword, builder, progress.Part(0.0, 0.5));
  ReadFaceLines(text, builder, progress.Part(0.5, 1.0));
  progress(1.0);
  return builder.Finish();
}

} // namespace shape
