#pragma once

#include <set>
#include <vector>

namespace shape
{

/// Which regions meet. Regions are numbered from 0, which is the outside.
struct RegionMeetings
{
  int Count = 0;                     ///< number of regions, with the outside
  std::vector<char> Pairs;           ///< Count x Count: whether two regions share a face
  std::set<std::vector<int>> Around; ///< sets of three or more regions around an edge, ascending

  bool Touch(int one, int other) const { return this->Pairs[one * this->Count + other] != 0; }
};

} // namespace shape
