#pragma once

#include "vtkShapeAlgorithm.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

/// The commands of a repeatable property: a list whose entries are set by index.
namespace vtkShapeList
{

/// Changes the number of entries, each of `width` values. New values are 0, or empty.
template <typename Value>
void Resize(vtkShapeAlgorithm* owner, std::vector<Value>& list, int count, int width = 1)
{
  const std::size_t size = static_cast<std::size_t>(width) * std::max(count, 0);
  if (size != list.size())
  {
    list.resize(size, Value());
    owner->Modified();
  }
}

/// Sets an entry, and appends entries as needed. label: of the property, for the error if the index
/// is negative.
template <typename Value>
void Set(vtkShapeAlgorithm* owner, const std::string& label, std::vector<Value>& list, int index,
  std::initializer_list<Value> entry)
{
  if (index < 0)
  {
    vtkErrorWithObjectMacro(owner, << owner->GetLabel() << ": " << label << " has no index "
                                   << index << "; use an index from 0");
    return;
  }
  const std::size_t first = entry.size() * static_cast<std::size_t>(index);
  const bool isNew = first + entry.size() > list.size();
  list.resize(std::max(list.size(), first + entry.size()), Value());
  const auto at = list.begin() + static_cast<std::ptrdiff_t>(first);
  if (isNew || !std::equal(entry.begin(), entry.end(), at))
  {
    std::copy(entry.begin(), entry.end(), at);
    owner->Modified();
  }
}

} // namespace vtkShapeList
