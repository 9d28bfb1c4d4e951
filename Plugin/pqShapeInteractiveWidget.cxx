#include "pqShapeInteractiveWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapeFacts.h"

#include "vtkCommand.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqProxy.h"
#include "pqProxyWidget.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace
{

std::vector<vtkSMProperty*> FindProperties(
  vtkSMPropertyGroup* group, const std::vector<std::string>& functions)
{
  std::vector<vtkSMProperty*> properties;
  for (const std::string& function : functions)
  {
    properties.push_back(group->GetProperty(function.c_str()));
  }
  return properties;
}

} // namespace

pqShapeInteractiveWidget::pqShapeInteractiveWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group,
  const std::vector<std::string>& functions, QWidget* parent)
  : Superclass(filter, parent)
  , Group(group)
  , Surface(group->GetProperty("Surface"), [this] { this->VisibilityTimer.start(0); })
  , Edit(filter, FindProperties(group, functions), group->GetProperty("Dragging"))
  , Layout(new QFormLayout(this))
  , ShowHandle(new QCheckBox(tr("Show handle"), this))
  , Help(new QLabel(this))
  , Overlays([this] { this->OnRender(); },
      [this](unsigned long event) { return this->OnEvent(event); },
      [this] { this->LetGo(); }) // a drag whose release was lost in the other view
{
  this->setChangeAvailableAsChangeFinished(false); // a row reports itself when editing is finished
  this->Layout->setContentsMargins(0, 0, 0, 0);
  this->ShowHandle->setObjectName("ShowHandle");
  this->ShowHandle->setChecked(true);
  this->Layout->addRow(this->ShowHandle);
  this->Help->setObjectName("Help");
  this->Help->setWordWrap(true);
  for (vtkSMProperty* property : FindProperties(group, functions))
  {
    if (property)
    {
      pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(OnValuesChanged()));
      pqCoreUtilities::connect(
        property, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(OnValuesChanged()));
    }
  }
  pqCoreUtilities::connect(filter, vtkCommand::UpdateDataEvent, this, SLOT(OnUpdated()));
  if (vtkSMProperty* surface = group->GetProperty("Surface"))
  {
    pqCoreUtilities::connect(
      surface, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(OnUpdated()));
  }
  for (QTimer* timer : { &this->VisibilityTimer, &this->StepTimer, &this->BurstTimer })
  {
    timer->setSingleShot(true);
  }
  const auto showOrHide = [this] { this->VisibilityTimer.start(0); };
  QObject::connect(this->ShowHandle, &QCheckBox::toggled, this, showOrHide);
  QObject::connect(
    &this->VisibilityTimer, &QTimer::timeout, this, [this] { this->UpdateVisibility(); });
  QObject::connect(&this->StepTimer, &QTimer::timeout, this, [this] { this->Step(); });
  QObject::connect(&this->BurstTimer, &QTimer::timeout, this, [this] { this->EndBurst(); });
}

void pqShapeInteractiveWidget::apply()
{
  this->EndDrag();
  for (pqPropertyWidget* row : this->Rows)
  {
    row->apply();
  }
  this->Superclass::apply();
}

void pqShapeInteractiveWidget::reset()
{
  for (pqPropertyWidget* row : this->Rows)
  {
    row->reset();
  }
  this->Superclass::reset();
}

void pqShapeInteractiveWidget::select()
{
  this->Superclass::select();
  this->VisibilityTimer.start(0);
}

void pqShapeInteractiveWidget::deselect()
{
  this->EndDrag();
  this->Superclass::deselect();
  this->UpdateVisibility();
}

void pqShapeInteractiveWidget::setView(pqView* view)
{
  const bool changed = view != this->view();
  if (changed)
  {
    this->EndDrag();
  }
  for (pqPropertyWidget* row : this->Rows)
  {
    row->setView(view);
  }
  this->Superclass::setView(view);
  if (changed)
  {
    // A view that still shows the handle keeps it, so that no event is lost.
    this->Overlays.DetachExcept(this->FindViews());
  }
  this->VisibilityTimer.start(0);
}

vtkSMProperty* pqShapeInteractiveWidget::GetProperty(const std::string& function) const
{
  return this->Group->GetProperty(function.c_str());
}

std::vector<double> pqShapeInteractiveWidget::GetValues(const std::string& function) const
{
  vtkSMProperty* property = this->GetProperty(function);
  return property ? vtkSMUncheckedPropertyHelper(property).GetDoubleArray() : std::vector<double>();
}

void pqShapeInteractiveWidget::SetValues(
  const std::string& function, const std::vector<double>& values)
{
  if (vtkSMProperty* property = this->GetProperty(function))
  {
    vtkSMPropertyHelper(property).Set(values.data(), static_cast<unsigned int>(values.size()));
  }
}

void pqShapeInteractiveWidget::AddRow(const std::string& function)
{
  vtkSMProperty* property = this->GetProperty(function);
  pqPropertyWidget* row =
    property ? pqProxyWidget::createWidgetForProperty(property, this->proxy(), this) : nullptr;
  if (row)
  {
    row->setObjectName(property->GetXMLName());
    QObject::connect(
      row, &pqPropertyWidget::changeAvailable, this, &pqPropertyWidget::changeAvailable);
    QObject::connect(
      row, &pqPropertyWidget::changeFinished, this, &pqPropertyWidget::changeFinished);
    this->Layout->addRow(property->GetXMLLabel(), row);
    this->Rows.push_back(row);
  }
}

void pqShapeInteractiveWidget::AddWidget(QWidget* widget)
{
  this->Layout->addRow(widget);
}

void pqShapeInteractiveWidget::AddHelp(const QString& text)
{
  this->HelpText = text;
  this->Help->setText(text);
  this->AddWidget(this->Help);
}

void pqShapeInteractiveWidget::OnValuesChanged()
{
  if (!this->Edit.IsActive() && this->Overlays.IsAttached())
  {
    this->RequestRender();
  }
}

void pqShapeInteractiveWidget::OnUpdated()
{
  const std::vector<double> refused = pqShapeFacts::GetNumbers(this->proxy(), "Refused");
  this->Refused = !refused.empty() && refused.front() != 0.0;
  const std::string reason = pqShapeFacts::GetText(this->proxy(), "Refusal");
  this->Help->setText(this->Refused && !reason.empty() ? reason.c_str() : this->HelpText);
  this->ReadFacts();
  this->VisibilityTimer.start(0); // it may have another input
}

double pqShapeInteractiveWidget::GetTime() const
{
  return vtkSMPropertyHelper(this->view()->getProxy(), "ViewTime").GetAsDouble();
}

bool pqShapeInteractiveWidget::UpdateSurface()
{
  return this->Surface.Update(this->GetTime());
}

void pqShapeInteractiveWidget::UpdateVisibility()
{
  const int version = this->Surface.GetVersion();
  std::vector<pqView*> views;
  if (this->isSelected() && this->ShowHandle->isChecked() &&
    pqShapeOverlay::CanAttach(this->view()) && this->UpdateSurface())
  {
    views = this->FindViews();
  }
  if (std::find(views.begin(), views.end(), this->Overlays.GetCurrent()->GetView()) == views.end())
  {
    this->EndDrag();
  }
  const bool wasAttached = this->Overlays.IsAttached();
  const bool otherSurface = version != this->Surface.GetVersion();
  if (!this->Overlays.Attach(views) && !otherSurface)
  {
    return;
  }
  if (this->Overlays.IsAttached() && (!wasAttached || otherSurface))
  {
    this->Initialize();
  }
  this->RequestRender();
}

void pqShapeInteractiveWidget::Initialize()
{
  this->OnUpdated();
  const auto* filter =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqProxy*>(this->proxy());
  if (filter && filter->modifiedState() == pqProxy::UNINITIALIZED)
  {
    const pqScopedUndoExclude exclude;
    this->Place();
    this->proxy()->UpdateVTKObjects();
  }
}

void pqShapeInteractiveWidget::OnRender()
{
  if (this->view() && this->GetTime() != this->Surface.GetTime())
  {
    this->VisibilityTimer.start(0);
  }
  this->Overlays.GetCurrent()->SetVisible(this->IsReady());
  if (this->IsReady())
  {
    if (this->Overlays.HasMouse())
    {
      this->UpdateHovered();
    }
    this->Draw();
  }
}

void pqShapeInteractiveWidget::RequestRender()
{
  // A view without a handle is rendered, too: the handle may just have left it.
  if (this->view())
  {
    this->view()->render();
  }
  for (pqView* view : this->Overlays.GetViews())
  {
    if (view != this->view())
    {
      view->render();
    }
  }
}
