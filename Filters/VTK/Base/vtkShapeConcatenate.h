#pragma once

#include "vtkType.h"

#include <vector>

class vtkMultiProcessController;

/// Values of several processes, one after the other.
namespace vtkShapeConcatenate
{

/// Returns the values of all processes, in the order of the processes: the same on every process.
/// offsets: where the values of each process begin, and the number of values. Container is a vector
/// of double or a string. Collective: all processes must call it.
template <typename Container>
Container Concatenate(
  vtkMultiProcessController* controller, const Container& own, std::vector<vtkIdType>& offsets);

} // namespace vtkShapeConcatenate
