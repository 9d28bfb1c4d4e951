#include "IO/Private/NodeNumbers.h"

#include <algorithm>
#include <numeric>

namespace shape
{
namespace
{

std::pair<int, std::int64_t> KeyOf(const DeckNode& node)
{
  return { node.Part, node.Number };
}

} // namespace

NodeNumbers::NodeNumbers(const std::vector<DeckNode>& nodes)
  : Nodes(nodes)
{
  const auto byKey = [](const DeckNode& a, const DeckNode& b) { return KeyOf(a) < KeyOf(b); };
  const auto [first, last] = std::minmax_element(nodes.begin(), nodes.end(), byKey);
  const auto note = [&](std::int64_t number)
  {
    this->FirstDuplicate = this->Duplicates == 0 ? number : this->FirstDuplicate;
    ++this->Duplicates;
  };
  // The table is a few times as long as the list of nodes at most.
  constexpr std::uint64_t sparsest = 8;
  if (!nodes.empty() && first->Part == last->Part &&
    static_cast<std::uint64_t>(last->Number) - static_cast<std::uint64_t>(first->Number) <
      sparsest * nodes.size())
  {
    this->Lowest = first->Number;
    this->Table.assign(static_cast<std::size_t>(last->Number - first->Number) + 1, -1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      int& entry = this->Table[nodes[i].Number - this->Lowest];
      entry < 0 ? void(entry = static_cast<int>(i)) : note(nodes[i].Number);
    }
    return;
  }
  this->Sorted.resize(nodes.size());
  std::iota(this->Sorted.begin(), this->Sorted.end(), 0);
  std::stable_sort(this->Sorted.begin(), this->Sorted.end(),
    [&](int a, int b) { return KeyOf(nodes[a]) < KeyOf(nodes[b]); });
  for (std::size_t i = 1; i < this->Sorted.size(); ++i)
  {
    if (KeyOf(nodes[this->Sorted[i]]) == KeyOf(nodes[this->Sorted[i - 1]]))
    {
      note(nodes[this->Sorted[i]].Number);
    }
  }
}

int NodeNumbers::Find(int part, std::int64_t number) const
{
  if (!this->Table.empty())
  {
    const std::uint64_t entry =
      static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(this->Lowest);
    return entry < this->Table.size() && this->Nodes.front().Part == part ? this->Table[entry] : -1;
  }
  const auto found = std::lower_bound(this->Sorted.begin(), this->Sorted.end(), Key{ part, number },
    [&](int node, const Key& key) { return KeyOf(this->Nodes[node]) < key; });
  return found != this->Sorted.end() && KeyOf(this->Nodes[*found]) == Key{ part, number } ? *found
                                                                                          : -1;
}

int NodeNumbers::CountDuplicates(std::int64_t& first) const
{
  first = this->FirstDuplicate;
  return this->Duplicates;
}

} // namespace shape
