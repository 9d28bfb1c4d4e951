#include "pqShapeArrangement.h"

#include "pqShapePorts.h"
#include "pqShapeRepresentation.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"

#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqView.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using pqShapeRepresentation::FindVisible;
using pqShapeRepresentation::GetPosition;
using pqShapeRepresentation::IsMoved;
using pqShapeRepresentation::Set;

/// Gap between two shapes that are drawn beside each other, as a share of the width of the first.
constexpr double Gap = 0.1;
/// Distance by which a part is drawn off the rest, as a share of the longest side of the rest.
constexpr double Off = 0.15;
/// What of the view an output covers if the camera can stay as it is.
constexpr double MinimumCover = 0.15, MaximumCover = 1.1;
/// Bounding boxes are at the same position, or the same, if they differ by less than this share of
/// their size.
constexpr double SamePosition = 0.05, SameBounds = 1e-6;

vtkBoundingBox GetBounds(pqOutputPort* port)
{
  return vtkBoundingBox(port->getDataInformation()->GetBounds());
}

/// Returns the bounds of an output as it is drawn.
vtkBoundingBox GetShownBounds(pqOutputPort* port, vtkSMProxy* representation)
{
  double bounds[6];
  port->getDataInformation()->GetBounds(bounds);
  const std::vector<double> shift = GetPosition(representation);
  for (std::size_t i = 0; i < 6; ++i)
  {
    bounds[i] += shift[i / 2];
  }
  return vtkBoundingBox(bounds);
}

bool AreSame(const vtkBoundingBox& a, const vtkBoundingBox& b, double tolerance)
{
  double difference = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    difference = std::max(difference, std::abs(a.GetBound(i) - b.GetBound(i)));
  }
  return difference <= tolerance * std::max(a.GetDiagonalLength(), b.GetDiagonalLength());
}

void HideCovered(pqOutputPort* port, pqView* view)
{
  if (!GetBounds(port).IsValid())
  {
    return; // there is nothing in it yet
  }
  const vtkBoundingBox bounds = GetShownBounds(port, FindVisible(port, view));
  for (pqRepresentation* representation : view->getRepresentations())
  {
    auto* data = qobject_cast<pqDataRepresentation*>(representation);
    pqOutputPort* other = data ? data->getOutputPortFromInput() : nullptr;
    if (other && other != port && data->isVisible() && GetBounds(other).IsValid() &&
      AreSame(bounds, GetShownBounds(other, data->getProxy()), SameBounds))
    {
      pqShapePorts::SetVisible(other, view, false);
    }
  }
}

void Move(pqOutputPort* port, const std::vector<double>& shift, pqView* view)
{
  Set(FindVisible(port, view), "Position", shift);
  HideCovered(port, view);
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
/// Nobody has chosen a view from the default direction: then the inputs do not matter.
bool NeedsCamera(pqPipelineSource* filter, bool isTurned, pqView* view)
{
  auto* render = vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  vtkBoundingBox shown;
  for (pqOutputPort* port : filter->getOutputPorts())
  {
    if (vtkSMProxy* representation = FindVisible(port, view))
    {
      shown.AddBox(GetShownBounds(port, representation));
    }
  }
  if (!shown.IsValid())
  {
    return false;
  }
  const QList<pqOutputPort*> inputs = qobject_cast<pqPipelineFilter*>(filter)->getAllInputs();
  const bool atInput = std::any_of(inputs.begin(), inputs.end(),
    [&](pqOutputPort* input) { return AreSame(shown, GetBounds(input), SamePosition); });
  return !(atInput && isTurned) && !IsWellInView(shown, render);
}

/// Returns whether the camera has another direction than in a new view.
bool IsTurned(vtkSMRenderViewProxy* view)
{
  double direction[3], up[3];
  view->GetActiveCamera()->GetDirectionOfProjection(direction);
  view->GetActiveCamera()->GetViewUp(up);
  return direction[2] > -1.0 + 1e-9 || up[1] < 1.0 - 1e-9;
}

} // namespace

namespace pqShapeArrangement
{

bool DrawBeside(pqOutputPort* port, pqOutputPort* other, pqView* view)
{
  vtkSMProxy* representations[] = { FindVisible(port, view), FindVisible(other, view) };
  const vtkBoundingBox bounds = GetBounds(port), otherBounds = GetBounds(other);
  if (port == other || !representations[0] || !representations[1] || IsMoved(representations[0]) ||
    IsMoved(representations[1]) || !otherBounds.Intersects(bounds))
  {
    return false;
  }
  Move(port,
    { otherBounds.GetBound(1) - bounds.GetBound(0) + Gap * otherBounds.GetLength(0), 0.0, 0.0 },
    view);
  return true;
}

void DrawOff(pqOutputPort* port, pqOutputPort* rest, pqView* view)
{
  vtkSMProxy* representation = FindVisible(port, view);
  if (!representation || !FindVisible(rest, view) || IsMoved(representation))
  {
    return;
  }
  const vtkBoundingBox bounds = GetBounds(rest);
  double centre[3], shift[3];
  bounds.GetCenter(centre);
  GetBounds(port).GetCenter(shift);
  vtkMath::Subtract(shift, centre, shift);
  if (vtkMath::Normalize(shift) > 0.0)
  {
    vtkMath::MultiplyScalar(shift, Off * bounds.GetMaxLength());
    Move(port, { shift, shift + 3 }, view);
  }
}

void DrawLike(pqOutputPort* port, pqOutputPort* other, pqView* view)
{
  vtkSMProxy* representation = FindVisible(port, view);
  pqDataRepresentation* model = other->getRepresentation(view);
  if (representation && model && IsMoved(model->getProxy()) && !IsMoved(representation))
  {
    Move(port, GetPosition(model->getProxy()), view);
  }
}

void Look(pqPipelineSource* filter, vtkPVXMLElement* camera, pqView* view)
{
  auto* render = vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  if (!render)
  {
    return;
  }
  const bool isTurned = IsTurned(render);
  double from[3];
  if (camera && !isTurned && camera->GetVectorAttribute("from", 3, from) == 3)
  {
    double focus[3];
    render->GetActiveCamera()->GetFocalPoint(focus);
    vtkMath::Add(focus, from, from);
    Set(render, "CameraPosition", { from, from + 3 });
    view->resetDisplay();
  }
  else if (NeedsCamera(filter, isTurned, view))
  {
    view->resetDisplay();
  }
}

} // namespace pqShapeArrangement
