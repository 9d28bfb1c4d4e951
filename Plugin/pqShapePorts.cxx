#include "pqShapePorts.h"

#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"

namespace pqShapePorts
{

pqOutputPort* FindInput(vtkSMProxy* filter, const std::string& name)
{
  const vtkSMPropertyHelper helper(filter, name.c_str());
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      helper.GetAsProxy());
  return source ? source->getOutputPort(static_cast<int>(helper.GetOutputPort())) : nullptr;
}

bool IsVisible(pqOutputPort* port, pqView* view)
{
  const pqDataRepresentation* representation = port->getRepresentation(view);
  return representation && representation->isVisible();
}

void SetVisible(pqOutputPort* port, pqView* view, bool visible)
{
  const vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->SetVisibility(vtkSMSourceProxy::SafeDownCast(port->getSourceProxy()),
    port->getPortNumber(), view->getViewProxy(), visible);
}

} // namespace pqShapePorts
