#pragma once

#include "Mesh/HalfEdges.h"

#include <vector>

namespace shape
{

/// Calls visit(begin, end) with the half-edges of each edge. sorted: see SortHalfEdges.
template <typename Visit>
void ForEachEdge(const std::vector<HalfEdge>& sorted, const Visit& visit)
{
  const HalfEdge* const last = sorted.data() + sorted.size();
  for (const HalfEdge *begin = sorted.data(), *end = begin; begin != last; begin = end)
  {
    while (end != last && end->Low() == begin->Low() && end->High() == begin->High())
    {
      ++end;
    }
    visit(begin, end);
  }
}

} // namespace shape
