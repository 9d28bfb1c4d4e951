#include "IO/Private/DeckBuilder.h"

#include "Base/Errors.h"
#include "IO/Private/NodeNumbers.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace shape
{

DeckBuilder::DeckBuilder(const std::string& name, std::string content, const ReadNamedFile& read,
  const shape::Progress& progress, bool wantsElements)
  : Read(read)
  , Progress(progress)
  , HasElements(wantsElements)
  , Reading({ 0 })
{
  this->ReserveNodes(content);
  this->Result.Files.push_back({ name, std::move(content) });
}

/// No file has more nodes than lines. Memory that is reserved costs nothing before it is used, and
/// lists that grow are copied again and again.
void DeckBuilder::ReserveNodes(std::string_view content)
{
  const std::size_t nodes = this->Result.Nodes.size() +
    static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n')) + 1;
  this->Result.Nodes.reserve(nodes);
  this->Positions.reserve(3 * nodes);
}

int DeckBuilder::Open(const std::string& name, int file, std::size_t at)
{
  auto& files = this->Result.Files;
  const auto known = std::find_if(
    files.begin(), files.end(), [&](const DeckFile& other) { return other.Name == name; });
  const int index = static_cast<int>(known - files.begin());
  if (known != files.end())
  {
    if (std::count(this->Reading.begin(), this->Reading.end(), index) > 0)
    {
      this->Refuse(file, at, "the file '" + name + "' includes itself; repair the deck");
    }
    const auto& nodes = this->Result.Nodes;
    if (std::any_of(
          nodes.begin(), nodes.end(), [&](const DeckNode& node) { return node.File == index; }))
    {
      this->Refuse(file, at,
        "the file '" + name + "' has nodes and is included twice; give each its own file");
    }
    return -1;
  }
  std::string content;
  try
  {
    content = this->Read(name);
  }
  catch (const InvalidInput& error)
  {
    this->Refuse(file, at, error.what());
  }
  this->ReserveNodes(content);
  files.push_back({ name, std::move(content) });
  this->Reading.push_back(index);
  return index;
}

void DeckBuilder::AddNode(const DeckNode& node, const Eigen::RowVector3d& position)
{
  if (this->Result.Nodes.size() == std::numeric_limits<int>::max())
  {
    throw InvalidInput("the deck has more nodes than an int can number; divide it");
  }
  this->Result.Nodes.push_back(node);
  this->Result.HasParts = this->Result.HasParts || node.Part > 0;
  this->Positions.insert(this->Positions.end(), position.begin(), position.end());
}

int DeckBuilder::FindRegion(const std::string& name)
{
  const auto [found, isNew] =
    this->Regions.emplace(name, static_cast<int>(this->Result.RegionNames.size()));
  if (isNew)
  {
    this->Result.RegionNames.push_back(name);
  }
  return found->second;
}

void DeckBuilder::AddElement(
  int region, int part, std::int64_t number, int kind, const std::int64_t* nodes, int count)
{
  if (!this->HasElements)
  {
    return;
  }
  if (this->Corners.size() + count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw InvalidInput("the deck has more element nodes than an int can number; divide it");
  }
  this->Result.ElementNumbers.push_back(number);
  this->Kinds.push_back(kind);
  this->RegionOfElement.push_back(region);
  this->PartOfElement.push_back(part);
  this->Corners.insert(this->Corners.end(), nodes, nodes + count);
  this->Offsets.push_back(static_cast<int>(this->Corners.size()));
}

void DeckBuilder::Report(int file, std::size_t at)
{
  if (++this->Calls % 65536 == 0)
  {
    // How many files are still to come is not known.
    const double size = static_cast<double>(std::max<std::size_t>(1, this->Content(file).size()));
    const double fraction = static_cast<double>(at) / size / static_cast<double>(file + 1);
    this->Done = std::max(this->Done, 0.8 * fraction);
    this->Progress(this->Done);
  }
}

void DeckBuilder::Refuse(int file, std::size_t at, const std::string& problem) const
{
  const std::string_view content = this->Content(file);
  const auto line =
    1 + std::count(content.begin(), content.begin() + std::min(at, content.size()), '\n');
  const std::string included =
    file == 0 ? "" : "included file '" + this->Result.Files[file].Name + "', ";
  throw InvalidInput(included + "line " + std::to_string(line) + ": " + problem);
}

void DeckBuilder::FindCorners()
{
  const NodeNumbers numbers(this->Result.Nodes);
  std::int64_t first = 0;
  if (const int duplicates = numbers.CountDuplicates(first))
  {
    throw InvalidInput("nodes have the number of another node: " + std::to_string(duplicates) +
      " (first: node " + std::to_string(first) + "); give each node its own number");
  }
  Eigen::VectorXi& corners = this->Result.Mesh.Corners;
  corners.resize(static_cast<Eigen::Index>(this->Corners.size()));
  std::size_t element = 0;
  for (int k = 0; k < static_cast<int>(this->Corners.size()); ++k)
  {
    element += k == this->Offsets[element + 1] ? 1 : 0;
    corners(k) = numbers.Find(this->PartOfElement[element], this->Corners[k]);
    if (corners(k) < 0)
    {
      throw InvalidInput("element " + std::to_string(this->Result.ElementNumbers[element]) +
        " has node " + std::to_string(this->Corners[k]) +
        ", which the deck does not have; repair the deck, or open the one that includes it");
    }
    if (k % 65536 == 0)
    {
      this->Progress(0.8 + 0.2 * k / static_cast<double>(this->Corners.size()));
    }
  }
}

Deck DeckBuilder::Finish()
{
  if (this->Result.Nodes.empty())
  {
    throw InvalidInput("the deck has no nodes; choose the file that has them");
  }
  const auto toVector = [](const std::vector<int>& values)
  {
    return Eigen::VectorXi(
      Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  this->FindCorners();
  Cells& mesh = this->Result.Mesh;
  mesh.Points = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
    this->Positions.data(), static_cast<Eigen::Index>(this->Result.Nodes.size()), 3);
  mesh.Kinds = toVector(this->Kinds);
  mesh.Offsets = toVector(this->Offsets);
  this->Result.Regions = toVector(this->RegionOfElement);
  this->Result.Skipped.assign(this->Skipped.begin(), this->Skipped.end());
  this->Progress(1.0);
  return std::move(this->Result);
}

} // namespace shape
