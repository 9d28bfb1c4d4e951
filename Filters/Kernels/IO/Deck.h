#pragma once

#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace shape
{

/// A file of a deck: the deck itself, or a file that it includes.
struct DeckFile
{
  std::string Name; ///< as the deck names it
  std::string Content;
};

/// A node of a deck, with the text of its coordinates.
struct DeckNode
{
  /// Begin of a coordinate that the file does not have; it is 0.
  static constexpr std::size_t NoText = std::numeric_limits<std::size_t>::max();

  std::int64_t Number = 0;               ///< in the deck
  std::array<std::size_t, 3> Begin{};    ///< byte of the content at which each coordinate begins
  std::array<std::uint32_t, 3> Length{}; ///< bytes of each coordinate; 0 if the field is empty
  std::uint16_t Columns = 0;             ///< maximum length of a coordinate; 0: no limit
  bool IsFixed = false;                  ///< a coordinate occupies all of its columns
  int File = 0;
  int Part = 0; ///< 0 outside of parts; parts number their nodes independently
};

/// The nodes and elements of a deck.
struct Deck
{
  std::deque<DeckFile> Files;  ///< the deck itself first
  std::vector<DeckNode> Nodes; ///< n
  Cells Mesh;                  ///< points: the n nodes. Kinds: VTK cell types, also quadratic
  std::vector<std::int64_t> ElementNumbers; ///< m
  Eigen::VectorXi Regions;                  ///< m; the element set or part, from 0
  std::vector<std::string> RegionNames;
  /// elements that Mesh does not have: their type and count
  std::vector<std::pair<std::string, int>> Skipped;
  bool HasParts = false; ///< a node has a part
};

/// Returns the content of the file that a deck names. Throws InvalidInput if it cannot be read.
using ReadNamedFile = std::function<std::string(const std::string& name)>;

} // namespace shape
