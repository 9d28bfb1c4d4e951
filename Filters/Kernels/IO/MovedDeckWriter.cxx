#include "IO/MovedDeckWriter.h"

#include "Base/Errors.h"
#include "IO/Private/ColumnText.h"
#include "IO/Private/NodeNumbers.h"

#include <algorithm>
#include <string>

namespace shape
{
namespace
{

/// Counts what is wrong with nodes, and refuses it.
class NodeFaults
{
public:
  void Add(std::int64_t node)
  {
    this->First = this->Count == 0 ? node : this->First;
    ++this->Count;
  }

  /// fault: "nodes are missing".
  void Refuse(const std::string& fault, const std::string& remedy) const
  {
    if (this->Count > 0)
    {
      throw InvalidInput(fault + ": " + std::to_string(this->Count) + " (first: node " +
        std::to_string(this->First) + "); " + remedy);
    }
  }

private:
  std::int64_t First = 0;
  int Count = 0;
};

void RequireText(const Deck& deck, const Eigen::MatrixXd& positions)
{
  NodeFaults faults;
  for (std::size_t i = 0; i < deck.Nodes.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    bool isLost = false;
    for (int k = 0; k < 3; ++k)
    {
      isLost = isLost || (deck.Nodes[i].Begin[k] == DeckNode::NoText && positions(row, k) != 0.0);
    }
    isLost ? faults.Add(deck.Nodes[i].Number) : void();
  }
  faults.Refuse("nodes have moved along an axis whose coordinate the deck leaves out",
    "write all three coordinates in the deck, or move the nodes in their plane");
}

} // namespace

Eigen::MatrixXd FindMovedNodes(const Deck& deck, const NumberedPoints& moved)
{
  const NodeNumbers numbers(deck.Nodes);
  Eigen::MatrixXd positions(static_cast<Eigen::Index>(deck.Nodes.size()), 3);
  std::vector<char> isFound(deck.Nodes.size(), 0);
  NodeFaults unknown, twice, infinite, missing;
  for (std::size_t p = 0; p < moved.Numbers.size(); ++p)
  {
    const int node = numbers.Find(moved.Parts.empty() ? 0 : moved.Parts[p], moved.Numbers[p]);
    const Eigen::RowVector3d position = moved.Points.row(static_cast<Eigen::Index>(p));
    if (node < 0)
    {
      unknown.Add(moved.Numbers[p]);
    }
    else if (!position.allFinite())
    {
      infinite.Add(moved.Numbers[p]);
    }
    else if (isFound[node] && positions.row(node) != position)
    {
      twice.Add(moved.Numbers[p]);
    }
    else
    {
      positions.row(node) = position;
      isFound[node] = 1;
    }
  }
  unknown.Refuse("points of the Input have a NodeId that the deck does not have",
    "choose the deck from which the Input came");
  infinite.Refuse("nodes have a position that is not finite", "repair the map");
  twice.Refuse("nodes are at two positions in the Input",
    "a filter has added points, and the elements of the deck do not have them: move the nodes "
    "without adding points");
  for (std::size_t i = 0; i < isFound.size(); ++i)
  {
    isFound[i] ? void() : missing.Add(deck.Nodes[i].Number);
  }
  missing.Refuse(
    "nodes of the deck are missing in the Input", "move all points of the deck, also unused ones");
  RequireText(deck, positions);
  return positions;
}

bool HasNodes(const Deck& deck, int file)
{
  return std::any_of(
    deck.Nodes.begin(), deck.Nodes.end(), [&](const DeckNode& node) { return node.File == file; });
}

void WriteMovedFile(std::ostream& file, const Deck& deck, int index,
  const Eigen::MatrixXd& positions, const Progress& progress)
{
  const std::string& content = deck.Files[index].Content;
  std::size_t written = 0;
  for (std::size_t i = 0; i < deck.Nodes.size(); ++i)
  {
    const DeckNode& node = deck.Nodes[i];
    const auto row = static_cast<Eigen::Index>(i);
    for (int k = 0; k < 3 && node.File == index; ++k)
    {
      if (positions(row, k) == deck.Mesh.Points(row, k))
      {
        continue;
      }
      const std::size_t columns = node.Columns;
      std::string text = ToColumnText(positions(row, k), columns == 0 ? 40 : columns);
      text.insert(0, node.IsFixed ? columns - text.size() : 0, ' ');
      file.write(content.data() + written, static_cast<std::streamsize>(node.Begin[k] - written));
      file << text;
      written = node.Begin[k] + node.Length[k];
    }
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(deck.Nodes.size()));
    }
  }
  file.write(content.data() + written, static_cast<std::streamsize>(content.size() - written));
  progress(1.0);
}

} // namespace shape
