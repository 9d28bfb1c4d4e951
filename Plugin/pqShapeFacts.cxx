#include "pqShapeFacts.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMSourceProxy.h"

#include <cstring>

namespace pqShapeFacts
{

namespace
{

vtkPVArrayInformation* Find(vtkSMProxy* filter, const std::string& name)
{
  const std::string prefix = std::string(filter->GetXMLName()).substr(std::strlen("Shape"));
  auto* source = vtkSMSourceProxy::SafeDownCast(filter);
  vtkPVDataInformation* table = source->GetDataInformation(source->GetNumberOfOutputPorts() - 1);
  return table->GetRowDataInformation()->GetArrayInformation((prefix + "." + name).c_str());
}

} // namespace

std::vector<double> GetNumbers(vtkSMProxy* filter, const std::string& name)
{
  vtkPVArrayInformation* array = Find(filter, name);
  std::vector<double> numbers;
  for (int i = 0; array && i < array->GetNumberOfComponents(); ++i)
  {
    numbers.push_back(array->GetComponentRange(i)[0]);
  }
  return numbers;
}

std::string GetText(vtkSMProxy* filter, const std::string& name)
{
  vtkPVArrayInformation* array = Find(filter, name);
  const char* text = array ? array->GetStringValue(0) : nullptr;
  return text ? text : "";
}

} // namespace pqShapeFacts
