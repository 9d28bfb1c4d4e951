#include "vtkShapeConcatenate.h"

#include "vtkMultiProcessController.h"

#include <numeric>
#include <string>

template <typename Container>
Container vtkShapeConcatenate::Concatenate(
  vtkMultiProcessController* controller, const Container& own, std::vector<vtkIdType>& offsets)
{
  const auto size = static_cast<vtkIdType>(own.size());
  if (!controller || controller->GetNumberOfProcesses() <= 1)
  {
    offsets = { 0, size };
    return own;
  }
  const int processes = controller->GetNumberOfProcesses();
  std::vector<vtkIdType> sizes(processes);
  controller->AllGather(&size, sizes.data(), 1);
  offsets.assign(processes + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), offsets.begin() + 1);
  Container all(offsets.back(), {});
  controller->AllGatherV(own.data(), all.data(), size, sizes.data(), offsets.data());
  return all;
}

template std::string vtkShapeConcatenate::Concatenate(
  vtkMultiProcessController*, const std::string&, std::vector<vtkIdType>&);
template std::vector<double> vtkShapeConcatenate::Concatenate(
  vtkMultiProcessController*, const std::vector<double>&, std::vector<vtkIdType>&);
