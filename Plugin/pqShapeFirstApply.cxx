#include "pqShapeFirstApply.h"

#include "pqShapeArrangement.h"
#include "pqShapeColors.h"
#include "pqShapePorts.h"
#include "pqShapeRepresentation.h"

#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMSourceProxy.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace
{

/// Diameter of points that are drawn as balls, in pixels.
constexpr int PointSize = 12;

bool IsOurs(pqPipelineSource* filter)
{
  return std::strncmp(filter->getProxy()->GetXMLName(), "Shape", 5) == 0;
}

/// Returns whether a filter has run: where it fails, all its outputs are empty.
bool HasResult(pqPipelineSource* filter)
{
  const QList<pqOutputPort*> ports = filter->getOutputPorts();
  return std::any_of(ports.begin(), ports.end(),
    [](pqOutputPort* port)
    {
      vtkPVDataInformation* data = port->getDataInformation();
      return data->GetNumberOfPoints() > 0 || data->GetNumberOfRows() > 0;
    });
}

/// The toolbars for colours are those of the active port: it must be one that is in the view.
void ActivateShownPort(pqPipelineSource* filter, pqView* view)
{
  pqActiveObjects& active = pqActiveObjects::instance();
  if (active.activeSource() != filter || pqShapePorts::IsVisible(active.activePort(), view))
  {
    return;
  }
  for (pqOutputPort* port : filter->getOutputPorts())
  {
    if (pqShapePorts::IsVisible(port, view))
    {
      active.setActivePort(port);
      return;
    }
  }
}

/// Returns the output that an attribute names: a port of the filter, or what one of its inputs is.
pqOutputPort* FindShown(
  pqPipelineSource* filter, vtkPVXMLElement* element, const char* attribute = "port")
{
  const char* name = element->GetAttributeOrEmpty(attribute);
  int port = 0;
  element->GetScalarAttribute(attribute, &port);
  return filter->getProxy()->GetProperty(name) ? pqShapePorts::FindInput(filter->getProxy(), name)
                                               : filter->getOutputPort(port);
}

void Hide(pqPipelineSource* filter, vtkPVXMLElement* element, pqView* view)
{
  pqOutputPort* input = FindShown(filter, element, "input");
  if (!input)
  {
    return;
  }
  const QList<pqOutputPort*> ports = element->GetAttribute("all")
    ? input->getSource()->getOutputPorts()
    : QList<pqOutputPort*>{ input };
  for (pqOutputPort* port : ports)
  {
    if (pqShapePorts::IsVisible(port, view))
    {
      pqShapePorts::SetVisible(port, view, false);
    }
  }
}

void ShowPoints(pqOutputPort* port, pqView* view)
{
  if (vtkSMProxy* representation = pqShapeRepresentation::FindVisible(port, view))
  {
    pqShapeRepresentation::Set(representation, "PointSize", PointSize);
    pqShapeRepresentation::Set(representation, "RenderPointsAsSpheres", 1);
  }
}

/// What a filter makes of one shape is drawn where that shape is drawn, and with its colours.
void FollowInput(pqPipelineFilter* filter, pqView* view)
{
  const QList<pqOutputPort*> inputs = filter->getAllInputs();
  if (inputs.size() != 1)
  {
    return;
  }
  for (pqOutputPort* port : filter->getOutputPorts())
  {
    pqShapeArrangement::DrawLike(port, inputs[0], view);
    pqShapeColors::Follow(port, inputs[0], view);
  }
}

void Show(pqPipelineSource* filter, vtkPVXMLElement* hints, pqView* view)
{
  bool moved = false;
  vtkPVXMLElement* camera = nullptr;
  for (unsigned int i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = hints->GetNestedElement(i);
    const std::string name = element->GetName();
    pqOutputPort* port = FindShown(filter, element);
    pqOutputPort* other = FindShown(filter, element, "other");
    if (name == "Color")
    {
      pqShapeColors::Apply(port, element, view);
    }
    else if (name == "Points")
    {
      ShowPoints(port, view);
    }
    else if (name == "Beside" && port && other)
    {
      moved = pqShapeArrangement::DrawBeside(port, other, view) || moved;
    }
    else if (name == "Off")
    {
      pqShapeArrangement::DrawOff(port, other, view);
    }
    else if (name == "Like" && other)
    {
      pqShapeArrangement::DrawLike(port, other, view);
    }
    else if (name == "Hide")
    {
      Hide(filter, element, view);
    }
    else if (name == "Camera")
    {
      camera = element;
    }
  }
  if (moved)
  {
    view->resetDisplay();
  }
  else
  {
    pqShapeArrangement::Look(filter, camera, view);
  }
  ActivateShownPort(filter, view);
}

} // namespace

void pqShapeFirstApply::startup()
{
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::modifiedStateChanged, this, &pqShapeFirstApply::OnStateChanged);
}

void pqShapeFirstApply::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}

void pqShapeFirstApply::OnStateChanged(pqServerManagerModelItem* item)
{
  auto* filter = qobject_cast<pqPipelineFilter*>(item);
  if (!filter)
  {
    return;
  }
  const pqUndoStack* undo = pqApplicationCore::instance()->getUndoStack();
  if (undo && (undo->getInUndo() || undo->getInRedo()))
  {
    return;
  }
  if (filter->modifiedState() == pqProxy::UNINITIALIZED)
  {
    this->New.insert(filter);
  }
  pqView* view = pqActiveObjects::instance().activeView();
  if (filter->modifiedState() != pqProxy::UNMODIFIED || !this->New.contains(filter) || !view)
  {
    return;
  }
  if (IsOurs(filter) && !this->HasRun(filter, view))
  {
    return;
  }
  this->New.remove(filter);
  FollowInput(filter, view);
  vtkPVXMLElement* hints = filter->getProxy()->GetHints();
  vtkPVXMLElement* first = hints ? hints->FindNestedElementByName("FirstApply") : nullptr;
  if (first)
  {
    Show(filter, first, view);
  }
}

bool pqShapeFirstApply::HasRun(pqPipelineFilter* filter, pqView* view)
{
  pqOutputPort* input = filter->getAnyInput();
  if (!HasResult(filter) && this->Failed.contains(filter))
  {
    filter->getSourceProxy()->UpdatePipeline();
  }
  if (!HasResult(filter))
  {
    this->Failed.insert(filter);
    pqShapePorts::SetVisible(input, view, true);
    return false;
  }
  if (this->Failed.remove(filter))
  {
    pqShapePorts::SetVisible(input, view, false);
  }
  return true;
}
