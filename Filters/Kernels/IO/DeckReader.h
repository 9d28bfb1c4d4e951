#pragma once

#include "Base/Progress.h"
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

  std::int64_t Number = 0;              ///< in the deck
  std::array<std::size_t, 3> Begin{};   ///< byte of the content at which each coordinate begins
  std::array<std::uint32_t, 3> Length{}; ///< bytes of each coordinate; 0 if the field is empty
  std::uint16_t Columns = 0;            ///< maximum length of a coordinate; 0: no limit
  bool IsFixed = false;                 ///< a coordinate occupies all of its columns
  int File = 0;
  int Part = 0; ///< 0 outside of parts; parts number their nodes independently
};

/// The nodes and elements of a deck.
struct Deck
{
  std::deque<DeckFile> Files;     ///< the deck itself first
  std::vector<DeckNode> Nodes;    ///< n
  Cells Mesh;                     ///< points: the n nodes. Kinds: VTK cell types, also quadratic
  std::vector<std::int64_t> ElementNumbers; ///< m
  Eigen::VectorXi Regions;                  ///< m; the element set or part, from 0
  std::vector<std::string> RegionNames;
  /// elements that Mesh does not have: their type and count
  std::vector<std::pair<std::string, int>> Skipped;
  bool HasParts = false; ///< a node has a part
};

/// Returns the content of the file that a deck names. Throws InvalidInput if it cannot be read.
using ReadNamedFile = std::function<std::string(const std::string& name)>;

/**
 * Reads the nodes and elements of an input deck. name: of the deck; its extension is the format:
 * .inp; .k, .key or .dyn; .feb. content: of that file. read: the files that it includes.
 *
 * The time is linear in the size of the files. Bytes outside of nodes and elements are not
 * interpreted, in any encoding; lines may end with CR LF.
 *
 * - Abaqus and CalculiX: *NODE, *ELEMENT, both also with INPUT=, and *INCLUDE. Parts that have one
 *   instance without translation or rotation are read; each has its own numbers.
 *   Elements: solid, surface and truss elements of 2 to 20 nodes, by their names (C3D8R, S4, ...).
 * - LS-DYNA: *NODE, *ELEMENT_SOLID (also _ORTHO), _TSHELL and _SHELL (also _THICKNESS, _BETA,
 *   _MCID), *INCLUDE; columns or commas; the standard, I10 and long formats.
 * - FEBio: <Nodes> and <Elements>, of version 1 to 4.
 *
 * Throws InvalidInput, with the file and line, if
 * - the extension, a number or an element is wrong, or a file includes itself,
 * - nodes are not where their coordinates say, or are generated from others: *SYSTEM, *NODE with
 *   SYSTEM=, *NGEN, *NFILL, *NCOPY, *NMAP, instances with a translation or of a part that has
 *   another one; *NODE_TRANSFORM, *NODE_RIGID_SURFACE, *INCLUDE_TRANSFORM and other *INCLUDE_...;
 *   <Instance>, and meshes from another file,
 * - there is no node, two nodes have the same number, or an element has a node that is not there.
 * Throws Aborted.
 */
Deck ReadDeck(const std::string& name, std::string content, const ReadNamedFile& read,
  const Progress& progress = {});

} // namespace shape
