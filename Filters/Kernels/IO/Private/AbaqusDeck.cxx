#include "IO/Private/DeckBuilder.h"
#include "IO/Private/DeckElements.h"
#include "IO/Private/DeckText.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shape
{
namespace
{

/// A line with a keyword, and the lines that continue it.
struct AbaqusKeyword
{
  std::string Name; ///< in upper case, without blanks: *NODE PRINT is NODEPRINT
  /// by names in upper case, without blanks; values without quotes
  std::map<std::string, std::string> Parameters;

  std::string Get(const std::string& parameter) const
  {
    const auto found = this->Parameters.find(parameter);
    return found == this->Parameters.end() ? "" : found->second;
  }
};

std::string WithoutBlanks(std::string_view text)
{
  std::string name = InUpperCase(text);
  const auto isBlank = [](char letter) { return letter == ' ' || letter == '\t'; };
  name.erase(std::remove_if(name.begin(), name.end(), isBlank), name.end());
  return name;
}

AbaqusKeyword ToKeyword(std::string_view text)
{
  AbaqusKeyword keyword;
  std::vector<std::string_view> parts;
  SplitAtCommas(text.substr(1), parts);
  keyword.Name = WithoutBlanks(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const std::size_t equals = parts[i].find('=');
    std::string_view value =
      equals == std::string_view::npos ? "" : Trimmed(parts[i].substr(equals + 1));
    if (value.size() > 1 && (value.front() == '"' || value.front() == '\'') &&
      value.back() == value.front())
    {
      value = value.substr(1, value.size() - 2);
    }
    keyword.Parameters[WithoutBlanks(parts[i].substr(0, equals))] = value;
  }
  return keyword;
}

/// The files of one deck, which are read as if they were one file.
class AbaqusDeck
{
public:
  explicit AbaqusDeck(DeckBuilder& builder)
    : Builder(builder)
  {
  }

  void ReadFile(int file)
  {
    DeckLines lines(this->Builder.Content(file));
    while (lines.Next())
    {
      this->Builder.Report(file, lines.Begin());
      const std::string_view line = Trimmed(lines.Line());
      if (line.empty() || line.substr(0, 2) == "**")
      {
        continue;
      }
      if (line.front() == '*')
      {
        const std::size_t at = lines.Begin();
        this->ReadKeyword(ToKeyword(JoinContinuation(lines)), file, at);
      }
      else
      {
        this->ReadDataLine(lines, file);
      }
    }
  }

  void Finish()
  {
    this->EndElements(0, this->Builder.Content(0).size());
    for (const auto& [name, part] : this->Parts)
    {
      if (part.Instances > 1 && part.HasNodes)
      {
        this->Builder.Refuse(part.File, part.At,
          "the part " + name + " has " + std::to_string(part.Instances) +
            " instances, which would move alike; give each instance its own part");
      }
    }
  }

private:
  enum class Block
  {
    Other,
    Nodes,
    Elements,
    SkippedElements,
    System,
    Instance
  };

  struct Part
  {
    int File = 0;
    std::size_t At = 0;
    int Instances = 0;
    bool HasNodes = false;
  };

  /// Returns the keyword line and what continues it: after a comma, a line that begins with a
  /// letter.
  static std::string JoinContinuation(DeckLines& lines)
  {
    std::string text(Trimmed(lines.Line()));
    for (DeckLines ahead = lines; text.back() == ',' && ahead.Next(); lines = ahead)
    {
      const std::string_view next = Trimmed(ahead.Line());
      const std::string upper = InUpperCase(next.substr(0, 1));
      if (upper < "A" || upper > "Z")
      {
        break;
      }
      text += next;
    }
    return text;
  }

  void ReadKeyword(const AbaqusKeyword& keyword, int file, std::size_t at)
  {
    const std::string& name = keyword.Name;
    const auto include = [&]
    {
      const std::string input = keyword.Get("INPUT");
      if (!input.empty())
      {
        this->Builder.Include(input, file, at, [&](int included) { this->ReadFile(included); });
      }
    };
    if (name == "INCLUDE")
    {
      include(); // it continues the block
      return;
    }
    this->EndElements(file, at);
    this->Current = Block::Other;
    this->RequireFixedNodes(keyword, file, at);
    if (name == "NODE")
    {
      this->Current = Block::Nodes;
      include();
    }
    else if (name == "ELEMENT")
    {
      this->BeginElements(keyword);
      include();
    }
    else if (name == "ELGEN" || name == "ELCOPY")
    {
      this->Builder.SkipElement("*" + name);
    }
    else if (name == "SYSTEM")
    {
      this->Current = Block::System;
    }
    else
    {
      this->ReadStructure(keyword, file, at);
    }
  }

  /// Refuses nodes that are not where their coordinates say, or come from other nodes.
  void RequireFixedNodes(const AbaqusKeyword& keyword, int file, std::size_t at) const
  {
    const std::string& name = keyword.Name;
    if (name == "NGEN" || name == "NFILL" || name == "NCOPY" || name == "NMAP")
    {
      this->Builder.Refuse(file, at,
        "*" + name +
          " makes nodes from others, which a map does not move; write each node in *NODE");
    }
    const std::string system = InUpperCase(keyword.Get("SYSTEM"));
    if (name == "NODE" && !system.empty() && system != "R")
    {
      this->Builder.Refuse(
        file, at, "*NODE has SYSTEM=" + system + "; write its nodes in rectangular coordinates");
    }
  }

  void ReadStructure(const AbaqusKeyword& keyword, int file, std::size_t at)
  {
    const std::string& name = keyword.Name;
    const bool isInstance = name == "INSTANCE";
    if (name == "PART" || isInstance)
    {
      this->Name = InUpperCase(keyword.Get("NAME"));
      this->Scope = ++this->Scopes;
      Part& part = this->Parts[isInstance ? InUpperCase(keyword.Get("PART")) : this->Name];
      part.Instances += isInstance ? 1 : 0;
      part.File = file;
      part.At = at;
      this->Owner = isInstance ? nullptr : &part;
      this->Current = isInstance ? Block::Instance : Block::Other;
    }
    else if (name == "ENDPART" || name == "ENDINSTANCE" || name == "ASSEMBLY")
    {
      this->Scope = 0;
      this->Owner = nullptr;
      this->Name.clear();
    }
  }

  void BeginElements(const AbaqusKeyword& keyword)
  {
    const std::string type = InUpperCase(keyword.Get("TYPE")), set = keyword.Get("ELSET");
    this->Type = FindAbaqusElement(type);
    this->TypeName = type;
    this->Current = !this->Builder.WantsElements() ? Block::Other
      : this->Type.Kind == 0                       ? Block::SkippedElements
                                                   : Block::Elements;
    this->IsContinued = false;
    if (this->Current == Block::Elements)
    {
      this->Region = this->Builder.FindRegion(
        (this->Name.empty() ? "" : this->Name + ".") + InUpperCase(set.empty() ? type : set));
    }
  }

  void EndElements(int file, std::size_t at)
  {
    if (!this->Numbers.empty())
    {
      this->Builder.Refuse(file, at,
        "element " + std::to_string(this->Numbers.front()) + " before this line has " +
          std::to_string(this->Numbers.size() - 1) + " nodes, but " + this->TypeName + " has " +
          std::to_string(this->Type.Nodes) + "; repair the deck");
    }
  }

  void ReadDataLine(const DeckLines& lines, int file)
  {
    switch (this->Current)
    {
      case Block::Nodes:
        this->ReadNode(lines, file);
        break;
      case Block::Elements:
        this->ReadElement(lines, file);
        break;
      case Block::SkippedElements:
        this->IsContinued ? void() : this->Builder.SkipElement(this->TypeName);
        this->IsContinued = Trimmed(lines.Line()).back() == ',';
        break;
      case Block::System:
        this->Builder.Refuse(file, lines.Begin(),
          "*SYSTEM defines a local coordinate system; write all nodes in global coordinates");
      case Block::Instance:
        this->RequireNoTransform(lines, file);
        break;
      case Block::Other:
        break;
    }
  }

  void RequireNoTransform(const DeckLines& lines, int file)
  {
    SplitAtCommas(lines.Line(), this->Fields);
    for (const std::string_view field : this->Fields)
    {
      double number = 0.0;
      if (!ReadDeckNumber(field, number) || number != 0.0)
      {
        this->Builder.Refuse(file, lines.Begin(),
          "the instance " + this->Name +
            " is translated or rotated; write its nodes in global coordinates");
      }
    }
  }

  void ReadNode(const DeckLines& lines, int file)
  {
    const std::string_view line = lines.Line();
    SplitAtCommas(line, this->Fields);
    DeckNode node;
    constexpr std::uint16_t columns = 20;
    node.Columns = columns;
    node.File = file;
    node.Part = this->Scope;
    if (!ReadDeckInteger(this->Fields[0], node.Number))
    {
      this->Builder.Refuse(file, lines.Begin(),
        "'" + std::string(Trimmed(this->Fields[0])) + "' is no number of a node; repair the deck");
    }
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
    node.Begin.fill(DeckNode::NoText);
    for (std::size_t k = 0; k < 3 && k + 1 < this->Fields.size(); ++k)
    {
      const std::string_view field = Trimmed(this->Fields[k + 1]);
      if (!ReadDeckNumber(field, position(static_cast<int>(k))))
      {
        this->Builder.Refuse(file, lines.Begin(),
          "'" + std::string(field) + "' is no coordinate of a node; repair the deck");
      }
      node.Begin[k] = lines.Begin() + (field.data() - line.data());
      node.Length[k] = static_cast<std::uint32_t>(field.size());
    }
    this->Builder.AddNode(node, position);
    if (this->Owner)
    {
      this->Owner->HasNodes = true;
    }
  }

  void ReadElement(const DeckLines& lines, int file)
  {
    SplitAtCommas(lines.Line(), this->Fields);
    for (std::size_t i = 0; i < this->Fields.size(); ++i)
    {
      const std::string_view field = Trimmed(this->Fields[i]);
      std::int64_t number = 0;
      if (field.empty() && i + 1 == this->Fields.size())
      {
        break; // a comma ends a line that is continued
      }
      if (!ReadDeckInteger(field, number))
      {
        this->Builder.Refuse(file, lines.Begin(),
          "'" + std::string(field) + "' is no number of an element or node; repair the deck");
      }
      this->Numbers.push_back(number);
      if (static_cast<int>(this->Numbers.size()) == this->Type.Nodes + 1)
      {
        this->Builder.AddElement(this->Region, this->Scope, this->Numbers[0], this->Type.Kind,
          this->Numbers.data() + 1, this->Type.Nodes);
        this->Numbers.clear();
      }
    }
  }

  DeckBuilder& Builder;
  Block Current = Block::Other;
  DeckElementType Type;
  std::string TypeName;
  int Region = 0;
  std::vector<std::int64_t> Numbers; ///< of the element that is being read, and of its nodes
  bool IsContinued = false;          ///< the last line ended with a comma
  std::map<std::string, Part> Parts;
  Part* Owner = nullptr; ///< the part that is being read
  std::string Name;      ///< of the part or instance that is being read
  int Scope = 0, Scopes = 0;
  std::vector<std::string_view> Fields;
};

} // namespace

void ParseAbaqusDeck(DeckBuilder& builder)
{
  AbaqusDeck deck(builder);
  deck.ReadFile(0);
  deck.Finish();
}

} // namespace shape
