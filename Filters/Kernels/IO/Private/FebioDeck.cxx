#include "IO/Private/DeckBuilder.h"
#include "IO/Private/DeckElements.h"
#include "IO/Private/DeckText.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace shape
{
namespace
{

/// A tag of XML.
struct FebioTag
{
  std::string_view Name;       ///< empty at the end of the file
  std::string_view Attributes; ///< the text after the name
  bool IsEnd = false;          ///< </name>
  bool IsEmpty = false;        ///< <name/>
  std::size_t At = 0;          ///< byte of its <
  std::size_t After = 0;       ///< byte after its >

  /// Returns the value of an attribute; empty if there is none.
  std::string_view Get(std::string_view name) const
  {
    for (std::size_t at = 0; (at = this->Attributes.find(name, at)) != std::string_view::npos;)
    {
      const bool isWhole = at == 0 || Trimmed(this->Attributes.substr(at - 1, 1)).empty();
      at += name.size();
      const std::string_view rest = Trimmed(this->Attributes.substr(at));
      if (isWhole && !rest.empty() && rest.front() == '=')
      {
        const std::string_view value = Trimmed(rest.substr(1));
        return value.empty() ? value : value.substr(1, value.find(value.front(), 1) - 1);
      }
    }
    return {};
  }
};

class FebioDeck
{
public:
  explicit FebioDeck(DeckBuilder& builder)
    : Builder(builder)
    , Text(builder.Content(0))
  {
  }

  void Read()
  {
    bool isFebio = false;
    for (FebioTag tag = this->NextTag(); !tag.Name.empty(); tag = this->NextTag())
    {
      this->Builder.Report(0, tag.At);
      isFebio = isFebio || tag.Name == "febio_spec";
      if (!isFebio)
      {
        break;
      }
      this->ReadTag(tag);
    }
    if (!isFebio)
    {
      this->Builder.Refuse(
        0, 0, "the file does not begin with <febio_spec>; choose a file of FEBio");
    }
  }

private:
  enum class Section
  {
    Other,
    Nodes,
    Elements
  };

  /// Returns the next tag; comments and the like are skipped.
  FebioTag NextTag()
  {
    FebioTag tag;
    for (;;)
    {
      tag.At = this->Text.find('<', this->Position);
      if (tag.At == std::string_view::npos)
      {
        return tag;
      }
      const std::string_view rest = this->Text.substr(tag.At);
      const auto begins = [&](std::string_view prefix)
      { return rest.substr(0, prefix.size()) == prefix; };
      if (begins("<!--") || begins("<![CDATA[") || begins("<?") || begins("<!"))
      {
        const std::string_view end = begins("<!--") ? "-->"
          : begins("<![")                           ? "]]>"
          : begins("<?")                            ? "?>"
                                                    : ">";
        this->Position = this->EndOf(end, tag.At);
        continue;
      }
      break;
    }
    tag.After = this->EndOf(">", tag.At);
    this->Position = tag.After;
    std::string_view inside = this->Text.substr(tag.At + 1, tag.After - tag.At - 2);
    tag.IsEnd = !inside.empty() && inside.front() == '/';
    tag.IsEmpty = !inside.empty() && inside.back() == '/';
    inside.remove_prefix(tag.IsEnd ? 1 : 0);
    inside.remove_suffix(tag.IsEmpty && !inside.empty() ? 1 : 0);
    const std::size_t end = std::min(inside.find_first_of(" \t\r\n"), inside.size());
    tag.Name = inside.substr(0, end);
    tag.Attributes = inside.substr(end);
    if (tag.Name.empty())
    {
      this->Builder.Refuse(0, tag.At, "a tag has no name; repair the file");
    }
    return tag;
  }

  std::size_t EndOf(std::string_view end, std::size_t from) const
  {
    const std::size_t found = this->Text.find(end, from);
    if (found == std::string_view::npos)
    {
      this->Builder.Refuse(0, from, "a tag or comment has no end; the file is incomplete");
    }
    return found + end.size();
  }

  void ReadTag(const FebioTag& tag)
  {
    if (tag.Name == "Nodes" || tag.Name == "Elements")
    {
      this->Current = tag.IsEnd || tag.IsEmpty ? Section::Other
        : tag.Name == "Nodes"                  ? Section::Nodes
                                               : Section::Elements;
      this->BeginSection(tag);
    }
    else if (tag.Name == "Instance" ||
      ((tag.Name == "Geometry" || tag.Name == "Mesh") && !tag.Get("from").empty()))
    {
      this->Builder.Refuse(0, tag.At,
        "<" + std::string(tag.Name) +
          "> takes its nodes from elsewhere; write all nodes and elements in this file");
    }
    else if (!tag.IsEnd && !tag.IsEmpty && this->Current == Section::Nodes && tag.Name == "node")
    {
      this->ReadNode(tag);
    }
    else if (!tag.IsEnd && !tag.IsEmpty && this->Current == Section::Elements)
    {
      this->ReadElement(tag);
    }
  }

  void BeginSection(const FebioTag& tag)
  {
    if (this->Current == Section::Elements)
    {
      ++this->Sections;
      this->SectionType = tag.Get("type");
      std::string_view name = tag.Get("name");
      name = name.empty() ? tag.Get("elset") : name;
      this->SectionName =
        name.empty() ? "Elements" + std::to_string(this->Sections) : std::string(name);
      this->HasRegion = false;
    }
  }

  /// Returns the text of an element of XML up to the next tag.
  std::string_view ContentOf(const FebioTag& tag) const
  {
    return this->Text.substr(tag.After, this->Text.find('<', tag.After) - tag.After);
  }

  std::int64_t NumberOf(const FebioTag& tag) const
  {
    std::int64_t number = 0;
    if (!ReadDeckInteger(tag.Get("id"), number))
    {
      this->Builder.Refuse(0, tag.At,
        "<" + std::string(tag.Name) + "> has no number in the attribute id; repair the file");
    }
    return number;
  }

  void ReadNode(const FebioTag& tag)
  {
    DeckNode node;
    node.Number = this->NumberOf(tag);
    SplitAtCommas(this->ContentOf(tag), this->Fields);
    Eigen::RowVector3d position;
    if (this->Fields.size() != 3)
    {
      this->Builder.Refuse(0, tag.At,
        "node " + std::to_string(node.Number) +
          " does not have three coordinates; repair the file");
    }
    for (int k = 0; k < 3; ++k)
    {
      const std::string_view field = Trimmed(this->Fields[k]);
      if (field.empty() || !ReadDeckNumber(field, position(k)))
      {
        this->Builder.Refuse(
          0, tag.At, "'" + std::string(field) + "' is no coordinate of a node; repair the file");
      }
      node.Begin[k] = field.data() - this->Text.data();
      node.Length[k] = static_cast<std::uint32_t>(field.size());
    }
    this->Builder.AddNode(node, position);
  }

  /// Since version 2.5 the section has the type; before, the tag was the type.
  void ReadElement(const FebioTag& tag)
  {
    const std::string_view typeName = this->SectionType.empty() ? tag.Name : this->SectionType;
    const DeckElementType type = FindFebioElement(typeName);
    if (type.Kind == 0)
    {
      this->Builder.SkipElement(std::string(typeName));
      return;
    }
    const std::int64_t number = this->NumberOf(tag);
    SplitAtCommas(this->ContentOf(tag), this->Fields);
    std::vector<std::int64_t> nodes(this->Fields.size());
    bool isRight = static_cast<int>(nodes.size()) == type.Nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      isRight = isRight && ReadDeckInteger(this->Fields[k], nodes[k]);
    }
    if (!isRight)
    {
      this->Builder.Refuse(0, tag.At,
        "element " + std::to_string(number) + " does not have the " + std::to_string(type.Nodes) +
          " nodes of " + std::string(typeName) + "; repair the file");
    }
    if (!this->HasRegion)
    {
      this->Region = this->Builder.FindRegion(this->SectionName);
      this->HasRegion = true;
    }
    this->Builder.AddElement(
      this->Region, 0, number, type.Kind, nodes.data(), static_cast<int>(nodes.size()));
  }

  DeckBuilder& Builder;
  std::string_view Text;
  std::size_t Position = 0; ///< byte after what was read
  Section Current = Section::Other;
  int Sections = 0, Region = 0;
  bool HasRegion = false; ///< Region is that of the section
  std::string_view SectionType;
  std::string SectionName;
  std::vector<std::string_view> Fields;
};

} // namespace

void ParseFebioDeck(DeckBuilder& builder)
{
  FebioDeck(builder).Read();
}

} // namespace shape
