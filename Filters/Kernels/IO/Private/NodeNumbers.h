#pragma once

#include "IO/Deck.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace shape
{

/// Finds nodes by their numbers.
class NodeNumbers
{
public:
  explicit NodeNumbers(const std::vector<DeckNode>& nodes);

  /// Returns the index of a node, or -1 if there is none.
  int Find(int part, std::int64_t number) const;

  /// Returns the number of nodes whose part and number an earlier one has; first: of them.
  int CountDuplicates(std::int64_t& first) const;

private:
  using Key = std::pair<int, std::int64_t>; ///< part and number

  const std::vector<DeckNode>& Nodes;
  std::vector<int> Sorted; ///< indices by part and number, if there is no table
  std::vector<int> Table;  ///< index of each number from Lowest on, or -1
  std::int64_t Lowest = 0;
  int Duplicates = 0;
  std::int64_t FirstDuplicate = 0;
};

} // namespace shape
