// The mouse and the keys of pqShapeInteractiveWidget: from an event to a step of an edit.
#include "pqShapeInteractiveWidget.h"

#include "pqShapeDisplay.h"

#include "vtkCommand.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMRenderViewProxy.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"

#include <QSignalBlocker>

namespace
{

/// Maximum motion of the mouse during a click, in pixels of a standard screen.
constexpr double ClickDistance = 3.0;
/// Pause that ends a burst of keys, in milliseconds.
constexpr int BurstPause = 400;

} // namespace

bool pqShapeInteractiveWidget::OnEvent(unsigned long event)
{
  if (!this->IsReady())
  {
    return false;
  }
  switch (event)
  {
    case vtkCommand::MouseMoveEvent:
      return this->OnMove();
    case vtkCommand::LeftButtonPressEvent:
      return this->OnPress();
    case vtkCommand::LeftButtonReleaseEvent:
      return this->OnRelease();
    case vtkCommand::LeftButtonDoubleClickEvent:
      return this->DoubleClick() || this->OnPress();
    case vtkCommand::RightButtonPressEvent:
      this->LetGo(); // the context menu hides the release of the left button
      return false;
    case vtkCommand::MouseWheelForwardEvent:
      return this->OnWheel(1);
    case vtkCommand::MouseWheelBackwardEvent:
      return this->OnWheel(-1);
    default:
      return this->OnKey();
  }
}

bool pqShapeInteractiveWidget::OnMove()
{
  if (this->Grabbed && this->Released)
  {
    return true; // the drag has ended, even if its last step is not processed yet
  }
  this->Pixel = this->Overlays.GetCurrent()->GetPixel();
  if (this->Grabbed)
  {
    this->StepTimer.start(0);
    return true;
  }
  const bool isOtherPart = this->UpdateHovered();
  if (this->Hover(this->Pixel) || isOtherPart)
  {
    this->RequestRender();
  }
  return false;
}

bool pqShapeInteractiveWidget::UpdateHovered()
{
  const int part = this->Grabbed ? this->Hovered : this->FindPart(this->Pixel);
  const bool changed = part != this->Hovered;
  this->Hovered = part;
  return changed;
}

bool pqShapeInteractiveWidget::OnPress()
{
  if (this->Stepping)
  {
    return true; // an execution that processes events is not interrupted
  }
  this->LetGo(); // first processes a drag that was released, or whose release was lost
  this->Pixel = this->Overlays.GetCurrent()->GetPixel();
  this->Pressed = this->Pixel;
  const int part = this->FindPart(this->Pixel);
  this->Clicking = part == 0;
  if (part == 0 || !this->UpdateSurface())
  {
    return false;
  }
  this->Hovered = part;
  this->Worked = this->Pixel;
  this->Grabbed = true;
  this->Released = false;
  this->Edit.Begin();
  this->Grab(part, this->Pixel, this->Overlays.GetCurrent()->IsShiftPressed(),
    this->Overlays.GetCurrent()->IsControlPressed());
  return true;
}

bool pqShapeInteractiveWidget::OnRelease()
{
  this->Pixel = this->Overlays.GetCurrent()->GetPixel();
  if (this->Grabbed)
  {
    this->Released = true;
    this->StepTimer.start(0);
    return true;
  }
  // The camera received the press, so it must receive the release, too.
  const double reach = ClickDistance * pqShapeDisplay::PixelScale(this->GetRenderer());
  if (this->Clicking && (this->Pixel - this->Pressed).norm() <= reach && this->UpdateSurface() &&
    this->Click(this->Pixel))
  {
    this->RequestRender();
  }
  this->Clicking = false;
  return false;
}

void pqShapeInteractiveWidget::LetGo()
{
  if (this->Grabbed)
  {
    this->Step(); // to the last position of the mouse
  }
  this->EndDrag();
}

bool pqShapeInteractiveWidget::OnWheel(int steps)
{
  this->UpdateHovered();
  return this->Grabbed || this->TurnWheel(steps, this->Overlays.GetCurrent()->IsControlPressed());
}

bool pqShapeInteractiveWidget::OnKey()
{
  const std::string key = this->Overlays.GetCurrent()->GetKey();
  if (key == "Escape" && this->Edit.IsActive())
  {
    this->BurstTimer.stop();
    this->StepTimer.stop();
    this->Grabbed = false;
    this->Edit.Cancel();
    pqApplicationCore::instance()->render();
    return true;
  }
  this->UpdateHovered();
  if (!this->Grabbed && this->PressKey(key))
  {
    return true;
  }
  this->EndBurst(); // the key may be the first of Ctrl+Z
  return false;
}

void pqShapeInteractiveWidget::Step()
{
  // Events that arrive during a step are processed after it.
  if (!this->Edit.IsActive() || this->Stepping)
  {
    return;
  }
  this->Stepping = true;
  const bool last = this->Released;
  const bool moved = this->Grabbed && this->Pixel != this->Worked;
  this->Worked = this->Pixel;
  if (!this->Grabbed)
  {
    this->Show();
    this->BurstTimer.start(BurstPause);
  }
  else if (moved && this->Drag(this->Pixel))
  {
    this->Show();
  }
  if (this->Grabbed && last)
  {
    this->Grabbed = false;
    this->Finish();
  }
  this->Stepping = false;
  if (this->Grabbed && this->Released)
  {
    this->StepTimer.start(0);
  }
}

void pqShapeInteractiveWidget::Burst(const std::function<void()>& change)
{
  if (!this->Edit.IsActive())
  {
    this->Edit.Begin();
  }
  change();
  this->StepTimer.start(0);
}

void pqShapeInteractiveWidget::EndBurst()
{
  this->BurstTimer.stop();
  if (this->Edit.IsActive() && !this->Grabbed)
  {
    this->Finish();
  }
}

void pqShapeInteractiveWidget::EndDrag()
{
  // The release of the button will not be seen.
  this->StepTimer.stop();
  this->Grabbed = false;
  this->EndBurst();
}

void pqShapeInteractiveWidget::Change(const std::function<void()>& change)
{
  this->EndBurst();
  this->Edit.Begin();
  change();
  this->Finish();
}

void pqShapeInteractiveWidget::Show()
{
  // ParaView's panels would compute the ranges of all arrays of all outputs, which takes as long as
  // a fast filter itself. Finish tells them.
  const QSignalBlocker blocker(this->FindSource());
  this->Edit.Show();
  for (pqView* view : this->Overlays.GetViews())
  {
    vtkSMRenderViewProxy::SafeDownCast(view->getProxy())->InteractiveRender();
  }
  if (!this->Refused)
  {
    this->Edit.Keep();
  }
}

pqPipelineSource* pqShapeInteractiveWidget::FindSource() const
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
    this->proxy());
}

void pqShapeInteractiveWidget::Finish()
{
  if (this->Refused)
  {
    this->Edit.TakeBack();
  }
  this->Edit.Finish(tr("Drag %1").arg(this->proxy()->GetXMLLabel()));
  pqPipelineSource* source = this->FindSource();
  if (source && !this->Group->GetProperty("Dragging")) // it does not run again
  {
    Q_EMIT source->dataUpdated(source);
  }
  pqApplicationCore::instance()->render();
}
