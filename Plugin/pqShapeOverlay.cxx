#include "pqShapeOverlay.h"

#include "vtkCommand.h"
#include "vtkPVRenderView.h"
#include "vtkProp.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include "pqView.h"

#include <QKeyEvent>
#include <QWidget>

namespace
{

/// Higher than the priority of ParaView's 3D widgets and of the camera.
constexpr float Priority = 10.0F;

} // namespace

pqShapeOverlay::pqShapeOverlay(
  const std::function<void()>& draw, const std::function<bool(unsigned long)>& takeEvent)
  : Draw(draw)
  , TakeEvent(takeEvent)
{
}

pqShapeOverlay::~pqShapeOverlay()
{
  this->Detach();
}

void pqShapeOverlay::AddActor(vtkProp* actor)
{
  actor->PickableOff();
  this->Actors.emplace_back(actor);
  if (this->Renderer)
  {
    this->Renderer->AddViewProp(actor);
  }
}

void pqShapeOverlay::SetVisible(bool visible)
{
  for (const vtkSmartPointer<vtkProp>& actor : this->Actors)
  {
    actor->SetVisibility(visible);
  }
}

bool pqShapeOverlay::CanAttach(pqView* view)
{
  auto* proxy = view ? vtkSMRenderViewProxy::SafeDownCast(view->getProxy()) : nullptr;
  return proxy && proxy->GetInteractor();
}

void pqShapeOverlay::Attach(pqView* view)
{
  this->Detach();
  auto* proxy = vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  this->Renderer =
    vtkPVRenderView::SafeDownCast(proxy->GetClientSideObject())->GetNonCompositedRenderer();
  this->Interactor = proxy->GetInteractor();
  this->View = view;
  for (const vtkSmartPointer<vtkProp>& actor : this->Actors)
  {
    this->Renderer->AddViewProp(actor);
  }
  this->RenderObserver =
    this->Renderer->AddObserver(vtkCommand::StartEvent, this, &pqShapeOverlay::OnRender);
  for (const int event : { vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonPressEvent,
         vtkCommand::LeftButtonReleaseEvent, vtkCommand::LeftButtonDoubleClickEvent,
         vtkCommand::RightButtonPressEvent, vtkCommand::MouseWheelForwardEvent,
         vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent })
  {
    this->Observers.push_back(
      this->Interactor->AddObserver(event, this, &pqShapeOverlay::OnEvent, Priority));
  }
  this->Widget = view->widget();
  if (this->Widget)
  {
    this->Widget->installEventFilter(this);
  }
}

void pqShapeOverlay::Detach()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->RenderObserver);
    for (const vtkSmartPointer<vtkProp>& actor : this->Actors)
    {
      this->Renderer->RemoveViewProp(actor);
    }
  }
  if (this->Interactor)
  {
    for (const unsigned long observer : this->Observers)
    {
      this->Interactor->RemoveObserver(observer);
    }
  }
  if (this->Widget)
  {
    this->Widget->removeEventFilter(this);
  }
  this->Observers.clear();
  this->View = nullptr;
  this->Widget = nullptr;
  this->Renderer = nullptr;
  this->Interactor = nullptr;
}

bool pqShapeOverlay::eventFilter(QObject* widget, QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride)
  {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool alone =
      (key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    if (alone && this->Shortcuts.contains(key->key()))
    {
      event->accept(); // Qt then sends it again as a key press
      return true;
    }
  }
  return QObject::eventFilter(widget, event);
}

vtkRenderer* pqShapeOverlay::GetRenderer() const
{
  return this->Renderer;
}

Eigen::Vector2d pqShapeOverlay::GetPixel() const
{
  const int* position = this->Interactor->GetEventPosition();
  return { position[0], position[1] };
}

bool pqShapeOverlay::IsShiftPressed() const
{
  return this->Interactor->GetShiftKey() != 0;
}

bool pqShapeOverlay::IsControlPressed() const
{
  return this->Interactor->GetControlKey() != 0;
}

std::string pqShapeOverlay::GetKey() const
{
  const char* symbol = this->Interactor->GetKeySym();
  return symbol ? symbol : "";
}
