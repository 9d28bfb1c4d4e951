#pragma once

#include <numeric>
#include <vector>

namespace shape
{

/// Sets of connected items, merged pair by pair.
class DisjointSets
{
public:
  explicit DisjointSets(int count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  int Find(int item)
  {
    while (this->Parent[item] != item)
    {
      item = this->Parent[item] = this->Parent[this->Parent[item]];
    }
    return item;
  }
  void Merge(int a, int b) { this->Parent[this->Find(a)] = this->Find(b); }

private:
  std::vector<int> Parent;
};

} // namespace shape
