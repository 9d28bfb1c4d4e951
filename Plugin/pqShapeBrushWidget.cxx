#include "pqShapeBrushWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapeRepresentation.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqPropertiesPanel.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

constexpr double CircleWidth = 2.0; // pixels
constexpr int CircleSegments = 48;
constexpr double RadiusFactor = 1.1;
/// Numbers of a stroke in the property Strokes.
constexpr std::size_t StrokeWidth = 5;
constexpr int SmoothMode = 2;
/// The automatic radius is this share of half the diagonal of the surface.
constexpr double AutomaticRadius = 0.1;
/// Between two positions of a stroke, as shares of the radius. Set and Add act once in a stroke,
/// and their weight is then less than 1 % too small between two positions. Smooth acts at each
/// position.
constexpr double StrokeSpacing = 0.125, SmoothSpacing = 0.5;
/// Maximum number of positions that one move of the mouse adds.
constexpr int MaximumSteps = 256;

QDoubleSpinBox* MakeNumber(const char* name, double minimum, double maximum, double value)
{
  auto* number = new QDoubleSpinBox();
  number->setObjectName(name);
  number->setDecimals(6);
  number->setRange(minimum, maximum);
  number->setValue(value);
  number->setSingleStep(0.1);
  return number;
}

} // namespace

pqShapeBrushWidget::pqShapeBrushWidget(
  vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(filter, group, { "Strokes", "Points" }, parent)
  , Button(new QPushButton(tr("Paint"), this))
  , Remove(new QPushButton(tr("Undo Last Stroke"), this))
  , Mode(new QComboBox(this))
  , Ring(vtkSmartPointer<vtkPolyData>::New())
{
  this->Button->setObjectName("Paint");
  this->Button->setCheckable(true);
  this->AddWidget(this->Button);
  this->MakeSettings();
  this->TakeLastBrush();
  this->Remove->setObjectName("UndoLastStroke");
  this->AddWidget(this->Remove);
  this->AddHelp(
    tr("Press Paint and drag over the surface; with Shift, the brush smooths. A drag beside the "
       "surface rotates the view. Backspace removes the last stroke, Esc undoes a drag. Press - "
       "and +, or turn the wheel with Ctrl, to change the radius."));
  this->TakeShortcut(Qt::Key_Plus); // in ParaView these keys grow and shrink a selection
  this->TakeShortcut(Qt::Key_Minus);
  this->RingActor = pqShapeDisplay::MakeCurve(this->Ring);
  this->RingActor->GetProperty()->SetColor(1.0, 0.55, 0.05);
  this->AddActor(this->RingActor);
  QObject::connect(this->Button, &QPushButton::toggled, this, [this] { this->Start(); });
  QObject::connect(this->Remove, &QPushButton::clicked, this, [this] { this->RemoveLastStroke(); });
  QObject::connect(this->Radius, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this] { this->RequestRender(); });
}

void pqShapeBrushWidget::MakeSettings()
{
  auto* settings = new QWidget(this);
  settings->setObjectName("Settings");
  auto* layout = new QFormLayout(settings);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Mode->setObjectName("Mode");
  this->Mode->addItems({ tr("Set"), tr("Add"), tr("Smooth") });
  this->Mode->setToolTip(tr("Set moves the values under the brush towards Value, Add adds Value, "
                            "and Smooth moves them towards their mean."));
  this->Radius = MakeNumber("Radius", 0.0, 1e12, 0.0);
  this->Radius->setSpecialValueText(tr("automatic"));
  this->Radius->setToolTip(tr("Radius of the brush, in the units of the surface. 0: 5 % of the "
                              "diagonal of the surface."));
  this->Strength = MakeNumber("Strength", 0.0, 1.0, 1.0);
  this->Strength->setToolTip(tr("How much a stroke changes the values at the centre of the brush, "
                                "from 0 to 1. The effect decreases to 0 at the radius."));
  this->Value = MakeNumber("Value", -1e12, 1e12, 1.0);
  this->Value->setToolTip(tr("The value that Set paints, and that Add adds."));
  layout->addRow(tr("Mode"), this->Mode);
  layout->addRow(tr("Radius"), this->Radius);
  layout->addRow(tr("Strength"), this->Strength);
  layout->addRow(tr("Value"), this->Value);
  this->AddWidget(settings);
}

void pqShapeBrushWidget::TakeLastBrush()
{
  const std::vector<double> strokes = this->GetValues("Strokes");
  if (strokes.size() >= StrokeWidth)
  {
    const double* last = &strokes[strokes.size() - StrokeWidth];
    this->Mode->setCurrentIndex(static_cast<int>(last[0]));
    this->Radius->setValue(last[1]);
    this->Strength->setValue(last[2]);
    this->Value->setValue(last[3]);
  }
}

void pqShapeBrushWidget::deselect()
{
  this->Button->setChecked(false);
  this->Superclass::deselect();
}

bool pqShapeBrushWidget::IsPainting() const
{
  return this->Button->isChecked();
}

void pqShapeBrushWidget::Start()
{
  const auto* filter =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqProxy*>(this->proxy());
  auto* panel = pqCoreUtilities::mainWidget()->findChild<pqPropertiesPanel*>();
  if (this->IsPainting() && panel && filter && filter->modifiedState() == pqProxy::UNINITIALIZED)
  {
    panel->apply();
  }
  this->RequestRender();
}

double pqShapeBrushWidget::GetRadius() const
{
  const double radius = this->Radius->value();
  return radius > 0.0 ? radius : AutomaticRadius * this->GetSurface().GetSize();
}

void pqShapeBrushWidget::ScaleRadius(double factor)
{
  this->Radius->setValue(factor * this->GetRadius());
}

int pqShapeBrushWidget::FindPart(const Eigen::Vector2d& pixel)
{
  pqShapePlace place;
  return this->IsPainting() && this->GetSurface().FindUnder(this->GetRenderer(), pixel, place) ? 1
                                                                                               : 0;
}

bool pqShapeBrushWidget::Hover(const Eigen::Vector2d& pixel)
{
  const bool wasOver = this->IsOver;
  this->IsOver =
    this->IsPainting() && this->GetSurface().FindUnder(this->GetRenderer(), pixel, this->Centre);
  return this->IsOver || wasOver;
}

void pqShapeBrushWidget::Grab(int, const Eigen::Vector2d& pixel, bool shift, bool)
{
  pqShapePlace place;
  this->LastPixel = pixel;
  if (!this->GetSurface().FindUnder(this->GetRenderer(), pixel, place))
  {
    return;
  }
  const int mode = shift ? SmoothMode : this->Mode->currentIndex();
  this->Spacing = this->GetRadius() * (mode == SmoothMode ? SmoothSpacing : StrokeSpacing);
  std::vector<double> strokes = this->GetValues("Strokes");
  strokes.insert(strokes.end(),
    { double(mode), this->GetRadius(), this->Strength->value(), this->Value->value(), 0.0 });
  this->SetValues("Strokes", strokes);
  this->AddPoints({ place.Position });
  this->Centre = place;
  this->IsOver = true;
}

bool pqShapeBrushWidget::Drag(const Eigen::Vector2d& pixel)
{
  pqShapePlace place;
  this->IsOver = this->GetSurface().FindUnder(this->GetRenderer(), pixel, place);
  if (!this->IsOver)
  {
    return false; // the brush waits where it left the surface
  }
  this->Centre = place;
  const double steps = (place.Position - this->LastPoint).norm() / this->Spacing;
  const int count = static_cast<int>(std::min<double>(steps, MaximumSteps));
  std::vector<Eigen::Vector3d> points;
  for (int k = 1; k <= count; ++k)
  {
    const Eigen::Vector2d between = this->LastPixel + (pixel - this->LastPixel) * k / double(count);
    if (this->GetSurface().FindUnder(this->GetRenderer(), between, place))
    {
      points.push_back(place.Position);
    }
  }
  if (points.empty())
  {
    return false;
  }
  this->LastPixel = pixel;
  this->AddPoints(points);
  return true;
}

void pqShapeBrushWidget::AddPoints(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<double> strokes = this->GetValues("Strokes");
  std::vector<double> values = this->GetValues("Points");
  if (strokes.size() < StrokeWidth)
  {
    return; // an undo during the drag removed the stroke
  }
  for (const Eigen::Vector3d& point : points)
  {
    values.insert(values.end(), point.data(), point.data() + 3);
  }
  strokes.back() += static_cast<double>(points.size());
  this->LastPoint = points.back();
  this->SetValues("Strokes", strokes);
  this->SetValues("Points", values);
}

void pqShapeBrushWidget::RemoveLastStroke()
{
  std::vector<double> strokes = this->GetValues("Strokes");
  std::vector<double> values = this->GetValues("Points");
  if (strokes.size() < StrokeWidth)
  {
    return;
  }
  values.resize(values.size() - std::min(values.size(), 3 * std::size_t(strokes.back())));
  strokes.resize(strokes.size() - StrokeWidth);
  this->Change(
    [&]
    {
      this->SetValues("Strokes", strokes);
      this->SetValues("Points", values);
    });
}

bool pqShapeBrushWidget::PressKey(const std::string& key)
{
  if (!this->IsPainting())
  {
    return false;
  }
  if (key == "BackSpace")
  {
    this->RemoveLastStroke();
  }
  else if (key == "plus" || key == "equal" || key == "KP_Add")
  {
    this->ScaleRadius(RadiusFactor);
  }
  else if (key == "minus" || key == "KP_Subtract")
  {
    this->ScaleRadius(1.0 / RadiusFactor);
  }
  else if (key == "Escape")
  {
    this->Button->setChecked(false);
  }
  else
  {
    return false;
  }
  return true;
}

bool pqShapeBrushWidget::TurnWheel(int steps, bool control)
{
  if (!this->IsPainting() || !control)
  {
    return false;
  }
  this->ScaleRadius(std::pow(RadiusFactor, steps));
  return true;
}

void pqShapeBrushWidget::Draw()
{
  const bool isVisible = this->IsPainting() && this->IsOver;
  this->RingActor->SetVisibility(isVisible);
  if (!isVisible)
  {
    return;
  }
  const Eigen::Vector3d first = this->Centre.Normal.unitOrthogonal();
  const Eigen::Vector3d second = this->Centre.Normal.cross(first);
  std::vector<Eigen::Vector3d> ring;
  for (int i = 0; i <= CircleSegments; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / CircleSegments;
    ring.push_back(this->GetSurface()
                     .FindClosest(this->Centre.Position +
                       this->GetRadius() * (std::cos(angle) * first + std::sin(angle) * second))
                     .Position);
  }
  pqShapeDisplay::SetCurve(this->Ring, ring);
  pqShapeDisplay::SetWidth(this->RingActor, this->GetRenderer(), CircleWidth);
}

void pqShapeBrushWidget::ReadFacts()
{
  const auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      this->proxy());
  this->Remove->setEnabled(!this->GetValues("Strokes").empty());
  vtkSMProxy* representation = source && this->view()
    ? pqShapeRepresentation::FindVisible(source->getOutputPort(0), this->view())
    : nullptr;
  if (representation && vtkSMPVRepresentationProxy::GetUsingScalarColoring(representation))
  {
    const pqScopedUndoExclude exclude; // the range is not what a stroke changes
    vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange(representation, true, false);
  }
}
