#include "pqShapeNeeded.h"

#include "vtkPVXMLElement.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

namespace pqShapeNeeded
{

bool IsNeeded(vtkSMProperty* input)
{
  vtkPVXMLElement* hints = input->GetHints();
  vtkPVXMLElement* optional = hints ? hints->FindNestedElementByName("Optional") : nullptr;
  return !optional || optional->GetAttribute("needed");
}

QStringList GetInputs(vtkSMProxy* filter)
{
  QStringList names;
  auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(filter->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    if (properties->GetProperty()->IsA("vtkSMInputProperty") && IsNeeded(properties->GetProperty()))
    {
      names << properties->GetKey();
    }
  }
  return names;
}

} // namespace pqShapeNeeded
