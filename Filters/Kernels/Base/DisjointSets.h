#pragma once

#include <numeric>
#include <vector>

namespace shape
{

/// A partition of the items 0 to count - 1 into sets, which begin with one item each and can be
/// merged.
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
