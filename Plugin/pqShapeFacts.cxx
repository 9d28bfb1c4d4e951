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

std::string GetPrefix(vtkSMProxy* filter)
{
  return std::string(filter->GetXMLName()).substr(std::strlen("Shape")) + ".";
}

/// The facts are the columns of the output Facts, a table with one row.
vtkPVDataSetAttributesInformation* GetArrays(vtkSMProxy* filter)
{
  auto* source = vtkSMSourceProxy::SafeDownCast(filter);
  for (unsigned int port = 0; port < source->GetNumberOfOutputPorts(); ++port)
  {
    const char* name = source->GetOutputPortName(port);
    if (name && std::strcmp(name, "Facts") == 0)
    {
      return source->GetDataInformation(port)->GetRowDataInformation();
    }
  }
  return source->GetDataInformation(0)->GetFieldDataInformation();
}

vtkPVArrayInformation* Find(vtkSMProxy* filter, const std::string& name)
{
  return GetArrays(filter)->GetArrayInformation((GetPrefix(filter) + name).c_str());
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

std::vector<std::string> GetNames(vtkSMProxy* filter)
{
  const std::string prefix = GetPrefix(filter);
  vtkPVDataSetAttributesInformation* arrays = GetArrays(filter);
  std::vector<std::string> names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const std::string name = arrays->GetArrayInformation(i)->GetName();
    if (name.compare(0, prefix.size(), prefix) == 0)
    {
      names.push_back(name.substr(prefix.size()));
    }
  }
  return names;
}

} // namespace pqShapeFacts
