#include "IO/Private/DeckBuilder.h"
#include "IO/Private/DeckElements.h"
#include "IO/Private/DeckText.h"

#include "Mesh/Cells.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

/// Widths of the fields of nodes and elements.
enum class DynaFormat
{
  Standard, ///< 8 columns, 16 for coordinates
  I10,      ///< 10 columns, 16 for coordinates
  Long      ///< 20 columns
};

/// Removes repeated nodes of a degenerate solid, as LS-DYNA numbers them, and returns its kind.
int ReduceSolid(std::vector<std::int64_t>& n)
{
  if (n.size() == 10)
  {
    return QuadraticTetrahedron;
  }
  if (n[4] == n[3] && n[5] == n[3] && n[6] == n[3] && n[7] == n[3])
  {
    n.resize(4);
    return Tetrahedron;
  }
  if (n[5] == n[4] && n[6] == n[4] && n[7] == n[4])
  {
    n.resize(5);
    return Pyramid;
  }
  if (n[4] == n[5] && n[6] == n[7])
  {
    n = { n[3], n[2], n[6], n[0], n[1], n[4] };
    return Wedge;
  }
  return Hexahedron;
}

class DynaDeck
{
public:
  explicit DynaDeck(DeckBuilder& builder)
    : Builder(builder)
  {
  }

  void ReadFile(int file)
  {
    const DynaFormat outer = this->Default;
    this->Default = DynaFormat::Standard; // each file has its own
    this->Current = Block::Other;
    DeckLines lines(this->Builder.Content(file));
    while (lines.Next() && this->Current != Block::End)
    {
      this->Builder.Report(file, lines.Begin());
      const std::string_view line = lines.Line();
      if (line.empty() || line.front() == '$')
      {
        continue;
      }
      if (line.front() == '*')
      {
        this->EndElement(file, lines.Begin());
        this->ReadKeyword(InUpperCase(Trimmed(line)).substr(1), file, lines.Begin());
      }
      else if (!Trimmed(line).empty())
      {
        this->ReadCard(lines, file);
      }
    }
    this->EndElement(file, lines.Begin());
    this->Default = outer;
    this->Current = Block::Other;
  }

private:
  enum class Block
  {
    Other,
    Nodes,
    Elements,
    SkippedElements,
    Include,
    End
  };

  void ReadKeyword(std::string keyword, int file, std::size_t at)
  {
    this->Current = Block::Other;
    this->Format = this->Default;
    if (const char last = keyword.empty() ? ' ' : keyword.back();
        last == '+' || last == '-' || last == '%')
    {
      this->Format = last == '+' ? DynaFormat::Long
        : last == '%'            ? DynaFormat::I10
                                 : DynaFormat::Standard;
      keyword = Trimmed(keyword.substr(0, keyword.size() - 1));
    }
    const auto begins = [&](std::string_view prefix)
    { return keyword.compare(0, prefix.size(), prefix) == 0; };
    if (begins("KEYWORD"))
    {
      this->Default = keyword.find("LONG=Y") != std::string::npos ? DynaFormat::Long
        : keyword.find("I10=Y") != std::string::npos              ? DynaFormat::I10
                                                                  : DynaFormat::Standard;
    }
    else if (keyword == "NODE" || keyword == "INCLUDE" || keyword == "END")
    {
      this->Current = keyword == "NODE" ? Block::Nodes
        : keyword == "INCLUDE"          ? Block::Include
                                        : Block::End;
    }
    else if (begins("ELEMENT_"))
    {
      this->BeginElements(keyword);
    }
    else if (keyword == "NODE_TRANSFORM" || begins("NODE_RIGID_SURFACE") ||
      (begins("INCLUDE_") && !begins("INCLUDE_PATH")))
    {
      this->Builder.Refuse(file, at,
        "nodes of *" + keyword +
          " are not where *NODE says; write all nodes in *NODE, in global coordinates");
    }
  }

  void BeginElements(const std::string& keyword)
  {
    this->Current = Block::Elements;
    this->TypeName = keyword;
    this->IsSolid = true;
    this->ExtraCards = 0;
    if (keyword == "ELEMENT_SOLID_ORTHO")
    {
      this->ExtraCards = 2;
    }
    else if (keyword == "ELEMENT_SHELL" || keyword == "ELEMENT_SHELL_THICKNESS" ||
      keyword == "ELEMENT_SHELL_BETA" || keyword == "ELEMENT_SHELL_MCID")
    {
      this->IsSolid = false;
      this->ExtraCards = keyword == "ELEMENT_SHELL" ? 0 : 1;
    }
    else if (keyword != "ELEMENT_SOLID" && keyword != "ELEMENT_TSHELL")
    {
      this->Current = Block::SkippedElements;
    }
  }

  /// Divides a card into fields: at commas, or columns of one width after a first of its own.
  void Split(std::string_view line, std::size_t first, std::size_t other, std::size_t count)
  {
    if (line.find(',') != std::string_view::npos)
    {
      SplitAtCommas(line, this->Fields);
      this->Fields.resize(std::min(this->Fields.size(), count));
      return;
    }
    this->Fields.clear();
    for (std::size_t begin = 0; begin < line.size() && this->Fields.size() < count;)
    {
      const std::size_t width = this->Fields.empty() ? first : other;
      this->Fields.push_back(line.substr(begin, width));
      begin += width;
    }
  }

  void ReadCard(const DeckLines& lines, int file)
  {
    switch (this->Current)
    {
      case Block::Nodes:
        this->ReadNode(lines, file);
        break;
      case Block::Elements:
        this->ReadElementCard(lines, file);
        break;
      case Block::SkippedElements:
        this->Builder.SkipElement("card of *" + this->TypeName);
        break;
      case Block::Include:
        this->ReadInclude(lines, file);
        break;
      default:
        break;
    }
  }

  /// A name that is too long for its line continues after " +".
  void ReadInclude(const DeckLines& lines, int file)
  {
    std::string_view part = Trimmed(lines.Line());
    const bool goesOn = part.size() > 2 && part.substr(part.size() - 2) == " +";
    this->IncludedName += Trimmed(goesOn ? part.substr(0, part.size() - 2) : part);
    if (!goesOn)
    {
      std::string name;
      name.swap(this->IncludedName);
      this->Builder.Include(
        name, file, lines.Begin(), [&](int included) { this->ReadFile(included); });
      this->Current = Block::Include;
    }
  }

  void ReadNode(const DeckLines& lines, int file)
  {
    constexpr std::uint16_t columns = 16, longColumns = 20;
    const std::string_view line = lines.Line();
    DeckNode node;
    node.Columns = this->Format == DynaFormat::Long ? longColumns : columns;
    node.IsFixed = line.find(',') == std::string_view::npos;
    node.File = file;
    this->Split(line, this->IdColumns(), node.Columns, 4);
    if (!ReadDeckInteger(this->Fields[0], node.Number))
    {
      this->Builder.Refuse(file, lines.Begin(),
        "'" + std::string(Trimmed(this->Fields[0])) +
          "' is no number of a node; repair the deck, or its format (LONG, I10)");
    }
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
    node.Begin.fill(DeckNode::NoText);
    for (std::size_t k = 0; k < 3 && k + 1 < this->Fields.size(); ++k)
    {
      const std::string_view trimmed = Trimmed(this->Fields[k + 1]);
      if (!ReadDeckNumber(trimmed, position(static_cast<int>(k))))
      {
        this->Builder.Refuse(file, lines.Begin(),
          "'" + std::string(trimmed) + "' is no coordinate of a node; repair the deck");
      }
      const std::string_view field = node.IsFixed ? this->Fields[k + 1] : trimmed;
      node.Begin[k] = lines.Begin() + (field.data() - line.data());
      node.Length[k] = static_cast<std::uint32_t>(field.size());
    }
    this->Builder.AddNode(node, position);
  }

  std::size_t IdColumns() const
  {
    constexpr std::size_t standard = 8, wider = 10, longest = 20;
    return this->Format == DynaFormat::Long ? longest
      : this->Format == DynaFormat::I10     ? wider
                                            : standard;
  }

  /// An element has one card, or two if its first has only its number and part; then come cards of
  /// an option.
  void ReadElementCard(const DeckLines& lines, int file)
  {
    if (this->SkipCards > 0)
    {
      --this->SkipCards;
      return;
    }
    constexpr std::size_t most = 12;
    this->Split(lines.Line(), this->IdColumns(), this->IdColumns(), most);
    for (const std::string_view field : this->Fields)
    {
      std::int64_t number = 0;
      if (!Trimmed(field).empty() && !ReadDeckInteger(field, number))
      {
        this->Builder.Refuse(file, lines.Begin(),
          "'" + std::string(Trimmed(field)) +
            "' is no number of an element or node; repair the deck");
      }
      this->Numbers.push_back(number);
    }
    while (this->Numbers.size() > 2 && this->Numbers.back() == 0)
    {
      this->Numbers.pop_back();
    }
    if (this->Numbers.size() > 2)
    {
      this->AddElement(file, lines.Begin());
      this->SkipCards = this->ExtraCards;
    }
  }

  void AddElement(int file, std::size_t at)
  {
    std::vector<std::int64_t> nodes(this->Numbers.begin() + 2, this->Numbers.end());
    const std::size_t count = nodes.size();
    int kind = 0;
    if (!this->IsSolid && (count == 3 || (count == 4 && nodes[2] == nodes[3])))
    {
      nodes.resize(3);
      kind = Triangle;
    }
    else if (!this->IsSolid && count == 4)
    {
      kind = Quadrilateral;
    }
    else if (this->IsSolid && (count == 4 || count == 6))
    {
      kind = count == 4 ? Tetrahedron : Wedge;
    }
    else if (this->IsSolid && (count == 8 || count == 10))
    {
      kind = ReduceSolid(nodes);
    }
    else
    {
      this->Builder.Refuse(file, at,
        "element " + std::to_string(this->Numbers[0]) + " of *" + this->TypeName + " has " +
          std::to_string(count) + " nodes; repair the deck");
    }
    this->Builder.AddElement(this->Builder.FindRegion(std::to_string(this->Numbers[1])), 0,
      this->Numbers[0], kind, nodes.data(), static_cast<int>(nodes.size()));
    this->Numbers.clear();
  }

  void EndElement(int file, std::size_t at)
  {
    if (!this->Numbers.empty())
    {
      this->Builder.Refuse(file, at,
        "element " + std::to_string(this->Numbers[0]) +
          " before this line has no nodes; repair the deck");
    }
    this->SkipCards = 0;
  }

  DeckBuilder& Builder;
  Block Current = Block::Other;
  DynaFormat Default = DynaFormat::Standard; ///< of the file
  DynaFormat Format = DynaFormat::Standard;  ///< of the keyword
  std::string TypeName, IncludedName;
  bool IsSolid = true;
  int ExtraCards = 0, SkipCards = 0;
  std::vector<std::int64_t> Numbers; ///< of the element that is being read, its part and its nodes
  std::vector<std::string_view> Fields;
};

} // namespace

void ParseDynaDeck(DeckBuilder& builder)
{
  DynaDeck(builder).ReadFile(0);
}

} // namespace shape
