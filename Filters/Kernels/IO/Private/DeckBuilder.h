#pragma once

#include "Base/Progress.h"
#include "IO/Deck.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shape
{

/// Collects what the parser of a format finds in the files of a deck.
class DeckBuilder
{
public:
  DeckBuilder(const std::string& name, std::string content, const ReadNamedFile& read,
    const Progress& progress, bool wantsElements);

  /// Reads a file that the deck includes, and calls parse(file). A file without nodes is read once.
  /// file, at: where it is included.
  template <typename Parse>
  void Include(const std::string& name, int file, std::size_t at, const Parse& parse)
  {
    const int included = this->Open(name, file, at);
    if (included >= 0)
    {
      parse(included);
      this->Reading.pop_back();
    }
  }

  std::string_view Content(int file) const { return this->Result.Files[file].Content; }

  /// at: of the node.
  void AddNode(const DeckNode& node, const Eigen::RowVector3d& position);
  /// Whether elements are read; AddElement ignores them otherwise.
  bool WantsElements() const { return this->HasElements; }
  /// Returns the number of a region. A new name is a new region.
  int FindRegion(const std::string& name);
  void AddElement(
    int region, int part, std::int64_t number, int kind, const std::int64_t* nodes, int count);
  void SkipElement(const std::string& type) { ++this->Skipped[type]; }

  /// Reports how far the file is read; call it for each line or node.
  void Report(int file, std::size_t at);

  /// Throws InvalidInput with the line of a byte of a file.
  [[noreturn]] void Refuse(int file, std::size_t at, const std::string& problem) const;

  /// Returns the deck. Throws InvalidInput if nodes are missing or have the same number.
  Deck Finish();

private:
  int Open(const std::string& name, int file, std::size_t at);
  void ReserveNodes(std::string_view content);
  void FindCorners();

  Deck Result;
  ReadNamedFile Read;
  shape::Progress Progress;
  bool HasElements;
  std::vector<int> Reading; ///< the files that are open, each included by the one before
  std::vector<double> Positions;
  std::map<std::string, int> Regions, Skipped;
  std::vector<int> Kinds, RegionOfElement, PartOfElement, Offsets = { 0 };
  std::vector<std::int64_t> Corners; ///< numbers of nodes
  std::size_t Calls = 0;
  double Done = 0.0;
};

///@{
/// Reads a file of the deck, and all that it includes.
void ParseAbaqusDeck(DeckBuilder& deck);
void ParseDynaDeck(DeckBuilder& deck);
void ParseFebioDeck(DeckBuilder& deck);
///@}

} // namespace shape
