#include "pqShapeRepresentation.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqView.h"

#include <algorithm>

namespace pqShapeRepresentation
{

vtkSMProxy* FindVisible(pqOutputPort* port, pqView* view)
{
  pqDataRepresentation* representation = port->getRepresentation(view);
  return representation && representation->isVisible() ? representation->getProxy() : nullptr;
}

std::vector<double> GetPosition(vtkSMProxy* representation)
{
  std::vector<double> position =
    vtkSMPropertyHelper(representation, "Position", true).GetDoubleArray();
  position.resize(3, 0.0); // some kinds of representations have none
  return position;
}

bool IsMoved(vtkSMProxy* representation)
{
  const std::vector<double> position = GetPosition(representation);
  return std::any_of(position.begin(), position.end(), [](double value) { return value != 0.0; });
}

void Set(vtkSMProxy* proxy, const char* property, const std::vector<double>& values)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
  vtkSMPropertyHelper(proxy, property, true)
    .Set(values.data(), static_cast<unsigned int>(values.size()));
  proxy->UpdateVTKObjects();
}

void Set(vtkSMProxy* proxy, const char* property, int value)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
  vtkSMPropertyHelper(proxy, property, true).Set(value);
  proxy->UpdateVTKObjects();
}

} // namespace pqShapeRepresentation
