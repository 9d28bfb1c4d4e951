#include "IO/MeditReader.h"

#include "IO/Private/NumberText.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

struct MeditSection
{
  const char* Keyword;
  int Kind;
  int Corners;
};

constexpr MeditSection MeditSections[] = { { "Corners", Vertex, 1 }, { "Edges", Line, 2 },
  { "Triangles", Triangle, 3 }, { "Quadrilaterals", Quadrilateral, 4 },
  { "Tetrahedra", Tetrahedron, 4 }, { "Pyramids", Pyramid, 5 }, { "Prisms", Wedge, 6 },
  { "Hexahedra", Hexahedron, 8 } };

/// Reads the sections of one file.
class MeditFile
{
public:
  MeditFile(std::string_view content, const Progress& progress)
    : Text(content)
    , Size(content.size())
    , Report(progress)
  {
  }

  MeditMesh Read()
  {
    if (this->Text.IsAtEnd() || this->Text.ReadWord("a keyword") != "MeshVersionFormatted")
    {
      this->Text.Refuse(
        "the file does not begin with MeshVersionFormatted; choose a Medit file in text form");
    }
    this->Text.ReadInteger("the version");
    while (!this->Text.IsAtEnd())
    {
      const std::string keyword(this->Text.ReadWord("a keyword"));
      if (keyword == "End")
      {
        break;
      }
      this->ReadSection(keyword);
    }
    if (this->References.empty())
    {
      this->Text.Refuse("the file has no Vertices; choose another file");
    }
    return this->Finish();
  }

private:
  void ReadSection(const std::string& keyword)
  {
    if (keyword == "Dimension")
    {
      this->Dimension = this->Text.ReadInteger("Dimension");
      if (this->Dimension != 2 && this->Dimension != 3)
      {
        this->Text.Refuse(
          "Dimension is " + std::to_string(this->Dimension) + "; it must be 2 or 3");
      }
    }
    else if (keyword == "Vertices")
    {
      this->ReadVertices();
    }
    else
    {
      const auto isKnown = [&](const MeditSection& known) { return keyword == known.Keyword; };
      const auto* section =
        std::find_if(std::begin(MeditSections), std::end(MeditSections), isKnown);
      if (section != std::end(MeditSections))
      {
        this->ReadCells(*section);
        return;
      }
      this->RequireNoCells(keyword);
      while (this->Text.IsAtNumber())
      {
        this->Text.SkipLine();
      }
    }
  }

  /// Refuses sections of cells that would otherwise be skipped: TrianglesP2, TetrahedraP3, ...
  void RequireNoCells(const std::string& keyword) const
  {
    for (const MeditSection& section : MeditSections)
    {
      const std::string prefix = section.Keyword;
      if (keyword.size() == prefix.size() + 2 && keyword.compare(0, prefix.size(), prefix) == 0)
      {
        this->Text.Refuse(keyword + " are cells of higher order; export linear cells");
      }
    }
    if (keyword.front() < 'A' || keyword.front() > 'Z')
    {
      this->Text.Refuse("'" + keyword.substr(0, 20) + "' is no keyword; repair the file");
    }
  }

  int ReadCount(const char* what, std::size_t bytesEach)
  {
    const int count = this->Text.ReadInteger(what);
    // Before anything of this size is allocated.
    if (count < 0 || static_cast<std::size_t>(count) > this->Text.CountBytesLeft() / bytesEach)
    {
      this->Text.Refuse("the file declares " + std::to_string(count) + " " + what +
        ", and is too short for them; it is incomplete");
    }
    return count;
  }

  void ReadVertices()
  {
    const int count = this->ReadCount("Vertices", 6);
    this->Points.resize(3 * static_cast<std::size_t>(count));
    this->References.resize(count);
    for (int i = 0; i < count; ++i)
    {
      for (int k = 0; k < this->Dimension; ++k)
      {
        this->Points[3 * static_cast<std::size_t>(i) + k] = this->Text.ReadNumber("a vertex");
      }
      this->References[i] = this->Text.ReadInteger("a vertex");
      this->ReportRow(i);
    }
  }

  void ReadCells(const MeditSection& section)
  {
    const int count = this->ReadCount(section.Keyword, 2 * section.Corners);
    for (int i = 0; i < count; ++i)
    {
      for (int k = 0; k < section.Corners; ++k)
      {
        const int corner = this->Text.ReadInteger(section.Keyword);
        if (corner < 1 || corner > static_cast<int>(this->References.size()))
        {
          this->Text.Refuse(std::string(section.Keyword) + " refer to vertex " +
            std::to_string(corner) + ", but vertices are 1 to " +
            std::to_string(this->References.size()) + "; repair the file");
        }
        this->Corners.push_back(corner - 1);
      }
      this->Kinds.push_back(section.Kind);
      this->Offsets.push_back(static_cast<int>(this->Corners.size()));
      this->CellReferences.push_back(
        section.Kind == Vertex ? 0 : this->Text.ReadInteger(section.Keyword));
      this->ReportRow(i);
    }
  }

  void ReportRow(int row)
  {
    if (row % 65536 == 0)
    {
      this->Report(
        1.0 - static_cast<double>(this->Text.CountBytesLeft()) / static_cast<double>(this->Size));
    }
  }

  MeditMesh Finish() const
  {
    const auto toVector = [](const std::vector<int>& values)
    {
      return Eigen::VectorXi(
        Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size())));
    };
    MeditMesh mesh;
    mesh.Mesh.Points = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
      this->Points.data(), static_cast<Eigen::Index>(this->References.size()), 3);
    mesh.Mesh.Kinds = toVector(this->Kinds);
    mesh.Mesh.Offsets = toVector(this->Offsets);
    mesh.Mesh.Corners = toVector(this->Corners);
    mesh.PointReferences = toVector(this->References);
    mesh.CellReferences = toVector(this->CellReferences);
    this->Report(1.0);
    return mesh;
  }

  NumberText Text;
  std::size_t Size;
  Progress Report;
  int Dimension = 3;
  std::vector<double> Points; ///< x, y, z of each vertex
  std::vector<int> References, Kinds, Corners, CellReferences;
  std::vector<int> Offsets = { 0 };
};

} // namespace

MeditMesh ReadMedit(std::string_view content, const Progress& progress)
{
  return MeditFile(content, progress).Read();
}

} // namespace shape
