#include "pqShapeFirstApply.h"

#include "pqShapePorts.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVGeneralSettings.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace
{

/// Gap between two shapes that are drawn beside each other, as a share of the width of the first.
constexpr double Gap = 0.1;
/// What of the view an output covers if the camera can stay as it is.
constexpr double MinimumCover = 0.15, MaximumCover = 1.1;
/// Positions of two bounding boxes that differ by less than this share of their size are the same.
constexpr double SameBounds = 0.05;

/// A colour map that belongs to an array: value, red, green and blue of each of its points. Values
/// outside have the first and the last colour, unless there is a colour for values below.
struct ColorMap
{
  const char* Array;
  std::vector<double> Points;
  std::vector<double> Below;
};

/// Bad cells are red, inverted cells darker still, and good cells a calm blue. What is only marked
/// is orange in grey.
const std::vector<ColorMap>& GetColorMaps()
{
  static const std::vector<double> marks = { 0.0, 0.82, 0.82, 0.8, 1.0, 0.93, 0.5, 0.1 };
  static const std::vector<ColorMap> maps = {
    { "ScaledJacobian",
      { 0.0, 0.75, 0.1, 0.1, 0.25, 0.93, 0.45, 0.2, 0.5, 0.97, 0.82, 0.45, 0.75, 0.75, 0.84, 0.85,
        1.0, 0.42, 0.6, 0.75 },
      { 0.35, 0.0, 0.2 } },
    { "Filled", marks, {} },
    { "Inverted", marks, {} },
    { "Flipped", marks, {} },
  };
  return maps;
}

std::string Get(vtkPVXMLElement* element, const char* attribute)
{
  const char* value = element->GetAttribute(attribute);
  return value ? value : "";
}

int GetPort(vtkPVXMLElement* element, const char* attribute)
{
  int port = 0;
  element->GetScalarAttribute(attribute, &port);
  return port;
}

vtkSMProxy* FindRepresentation(pqPipelineSource* filter, int port, pqView* view)
{
  pqDataRepresentation* representation = filter->getOutputPort(port)->getRepresentation(view);
  return representation && representation->isVisible() ? representation->getProxy() : nullptr;
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

bool IsShared(vtkSMProxy* table, vtkSMProxy* representation)
{
  for (const auto* other :
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqDataRepresentation*>())
  {
    vtkSMProxy* proxy = other->getProxy();
    if (proxy != representation &&
      vtkSMPropertyHelper(proxy, "LookupTable", true).GetAsProxy() == table)
    {
      return true;
    }
  }
  return false;
}

/// Gives an array its own colour map, unless another representation already shows the array.
void SetColorMap(vtkSMProxy* representation, const std::string& array)
{
  const auto& maps = GetColorMaps();
  const auto map = std::find_if(
    maps.begin(), maps.end(), [&array](const ColorMap& m) { return array == m.Array; });
  vtkSMProxy* table = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  if (map == maps.end() || !table || IsShared(table, representation))
  {
    return;
  }
  Set(table, "ColorSpace", 0); // mix red, green and blue
  Set(table, "AutomaticRescaleRangeMode", vtkSMTransferFunctionManager::NEVER);
  Set(table, "RGBPoints", map->Points);
  if (!map->Below.empty())
  {
    Set(table, "UseBelowRangeColor", 1);
    Set(table, "BelowRangeColor", map->Below);
  }
}

void ShowColorBar(vtkSMProxy* representation, pqView* view)
{
  if (vtkPVGeneralSettings::GetInstance()->GetScalarBarMode() ==
    vtkPVGeneralSettings::AUTOMATICALLY_SHOW_AND_HIDE_SCALAR_BARS)
  {
    vtkSMPVRepresentationProxy::SetScalarBarVisibility(representation, view->getProxy(), true);
  }
}

void ColorByArray(pqPipelineSource* filter, vtkPVXMLElement* element, pqView* view)
{
  const int port = GetPort(element, "port");
  vtkSMProxy* representation = FindRepresentation(filter, port, view);
  std::string array = Get(element, "array");
  int association =
    Get(element, "association") == "CELLS" ? vtkDataObject::CELL : vtkDataObject::POINT;
  const std::string like = Get(element, "like");
  pqOutputPort* input = like.empty() ? nullptr : pqShapePorts::FindInput(filter->getProxy(), like);
  pqDataRepresentation* model = input ? input->getRepresentation(view) : nullptr;
  if (model && vtkSMPVRepresentationProxy::GetUsingScalarColoring(model->getProxy()))
  {
    array = vtkSMPropertyHelper(model->getProxy(), "ColorArrayName").GetInputArrayNameToProcess();
    association = vtkDataObject::POINT; // all transferred arrays are
  }
  if (array.empty() && vtkSMPVRepresentationProxy::GetUsingScalarColoring(representation))
  {
    const vtkSMPropertyHelper chosen(representation, "ColorArrayName");
    array = chosen.GetInputArrayNameToProcess();
    association = chosen.GetInputArrayAssociation();
  }
  if (array.empty() ||
    !filter->getOutputPort(port)->getDataInformation()->GetArrayInformation(
      array.c_str(), association))
  {
    return;
  }
  vtkSMProxy* former = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  vtkSMPVRepresentationProxy::SetScalarColoring(representation, array.c_str(), association);
  if (former)
  {
    vtkSMPVRepresentationProxy::HideScalarBarIfNotNeeded(former, view->getProxy());
  }
  if (element->GetAttribute("direct"))
  {
    Set(representation, "MapScalars", 0);
    vtkSMPVRepresentationProxy::SetScalarBarVisibility(representation, view->getProxy(), false);
    return;
  }
  if (element->GetAttribute("component"))
  {
    vtkSMPVRepresentationProxy::SetScalarColoring(
      representation, array.c_str(), association, GetPort(element, "component"));
  }
  vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange(representation, false, false);
  SetColorMap(representation, array);
  ShowColorBar(representation, view);
}

void Color(pqPipelineSource* filter, vtkPVXMLElement* element, pqView* view)
{
  vtkSMProxy* representation = FindRepresentation(filter, GetPort(element, "port"), view);
  if (!representation)
  {
    return;
  }
  double color[3];
  if (element->GetVectorAttribute("solid", 3, color) == 3)
  {
    vtkSMPVRepresentationProxy::SetScalarColoring(representation, nullptr, vtkDataObject::POINT);
    Set(representation, "AmbientColor", { color, color + 3 });
    Set(representation, "DiffuseColor", { color, color + 3 });
    return;
  }
  ColorByArray(filter, element, view);
}

vtkBoundingBox GetBounds(pqOutputPort* port)
{
  return vtkBoundingBox(port->getDataInformation()->GetBounds());
}

bool IsMoved(vtkSMProxy* representation)
{
  const std::vector<double> shift =
    vtkSMPropertyHelper(representation, "Position").GetDoubleArray();
  return std::any_of(shift.begin(), shift.end(), [](double value) { return value != 0.0; });
}

/// Returns the output that an attribute names: a port of the filter, or what one of its inputs is.
pqOutputPort* FindShown(pqPipelineSource* filter, vtkPVXMLElement* element, const char* attribute)
{
  const std::string name = Get(element, attribute);
  return filter->getProxy()->GetProperty(name.c_str())
    ? pqShapePorts::FindInput(filter->getProxy(), name)
    : filter->getOutputPort(GetPort(element, attribute));
}

bool DrawBeside(pqPipelineSource* filter, vtkPVXMLElement* element, pqView* view)
{
  pqOutputPort* ports[] = { FindShown(filter, element, "port"),
    FindShown(filter, element, "other") };
  vtkSMProxy* representations[2] = {};
  for (int i = 0; i < 2; ++i)
  {
    representations[i] = ports[i]
      ? FindRepresentation(ports[i]->getSource(), ports[i]->getPortNumber(), view)
      : nullptr;
    if (!representations[i] || IsMoved(representations[i]))
    {
      return false;
    }
  }
  const vtkBoundingBox bounds = GetBounds(ports[0]), other = GetBounds(ports[1]);
  if (ports[0] == ports[1] || !other.Intersects(bounds))
  {
    return false;
  }
  const double shift = other.GetBound(1) - bounds.GetBound(0) + Gap * other.GetLength(0);
  Set(representations[0], "Position", { shift, 0.0, 0.0 });
  return true;
}

bool AreSame(const vtkBoundingBox& a, const vtkBoundingBox& b)
{
  double difference = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    difference = std::max(difference, std::abs(a.GetBound(i) - b.GetBound(i)));
  }
  return difference <= SameBounds * std::max(a.GetDiagonalLength(), b.GetDiagonalLength());
}

bool IsWellInView(const vtkBoundingBox& bounds, vtkSMRenderViewProxy* view)
{
  const std::vector<int> size = vtkSMPropertyHelper(view, "ViewSize").GetIntArray();
  vtkMatrix4x4* projection = view->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    size[0] / double(size[1]), -1.0, 1.0);
  double least[2] = { 1e30, 1e30 }, most[2] = { -1e30, -1e30 };
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    bounds.GetCorner(corner, point);
    projection->MultiplyPoint(point, point);
    if (point[3] <= 0.0)
    {
      return false; // behind the viewer
    }
    for (int i = 0; i < 2; ++i)
    {
      least[i] = std::min(least[i], point[i] / point[3]);
      most[i] = std::max(most[i], point[i] / point[3]);
    }
  }
  const double cover = std::max(most[0] - least[0], most[1] - least[1]) / 2.0;
  return cover >= MinimumCover && std::min(least[0], least[1]) >= -MaximumCover &&
    std::max(most[0], most[1]) <= MaximumCover;
}

/// Returns whether the outputs lie elsewhere than the inputs, and the view does not show them well.
bool NeedsCamera(pqPipelineSource* filter, pqView* view)
{
  auto* render = vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  vtkBoundingBox shown;
  for (pqOutputPort* port : filter->getOutputPorts())
  {
    if (FindRepresentation(filter, port->getPortNumber(), view))
    {
      shown.AddBox(GetBounds(port));
    }
  }
  if (!render || !shown.IsValid())
  {
    return false;
  }
  auto* pipelineFilter = qobject_cast<pqPipelineFilter*>(filter);
  for (pqOutputPort* input : pipelineFilter->getAllInputs())
  {
    if (AreSame(shown, GetBounds(input)))
    {
      return false;
    }
  }
  return !IsWellInView(shown, render);
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
  if (active.activeSource() != filter ||
    FindRepresentation(filter, active.activePort()->getPortNumber(), view))
  {
    return;
  }
  for (pqOutputPort* port : filter->getOutputPorts())
  {
    if (FindRepresentation(filter, port->getPortNumber(), view))
    {
      active.setActivePort(port);
      return;
    }
  }
}

void Show(pqPipelineSource* filter, vtkPVXMLElement* hints, pqView* view)
{
  bool moved = false;
  for (unsigned int i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = hints->GetNestedElement(i);
    const std::string name = element->GetName();
    if (name == "Color")
    {
      Color(filter, element, view);
    }
    else if (name == "Beside")
    {
      moved = DrawBeside(filter, element, view) || moved;
    }
    else if (name == "Hide")
    {
      pqOutputPort* input = pqShapePorts::FindInput(filter->getProxy(), Get(element, "input"));
      if (input && input->getRepresentation(view))
      {
        pqShapePorts::SetVisible(input, view, false);
      }
    }
  }
  if (moved || NeedsCamera(filter, view))
  {
    view->resetDisplay();
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
  if (!filter || std::strncmp(filter->getProxy()->GetXMLName(), "Shape", 5) != 0)
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
  pqOutputPort* input = filter->getAnyInput();
  if (!HasResult(filter) && this->Failed.contains(filter))
  {
    filter->getSourceProxy()->UpdatePipeline();
  }
  if (!HasResult(filter))
  {
    this->Failed.insert(filter);
    pqShapePorts::SetVisible(input, view, true);
    return;
  }
  this->New.remove(filter);
  if (this->Failed.remove(filter))
  {
    pqShapePorts::SetVisible(input, view, false);
  }
  vtkPVXMLElement* hints = filter->getProxy()->GetHints();
  vtkPVXMLElement* first = hints ? hints->FindNestedElementByName("FirstApply") : nullptr;
  if (first)
  {
    Show(filter, first, view);
  }
}
