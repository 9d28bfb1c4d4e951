#include "pqShapeHandleWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapeFacts.h"
#include "pqShapeGrips.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkPVDataInformation.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace
{

using namespace pqShapeGrips;

/// Rotation and scaling for a pixel of a drag with Shift or Control.
constexpr double PixelDegrees = 0.5, PixelFactor = 1.01;

/// Returns the angle in degrees, in (-180, 180].
double Wrap(double degrees)
{
  return degrees - 360.0 * std::ceil((degrees - 180.0) / 360.0);
}

} // namespace

pqShapeHandleWidget::pqShapeHandleWidget(
  vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(filter, group, { "Seed", "Rotation", "Scale", "Radius" }, parent)
  , BallActor(pqShapeDisplay::MakeBall())
  , KnobActor(pqShapeDisplay::MakeBall())
  , Ring(vtkSmartPointer<vtkPolyData>::New())
{
  for (const char* function : { "Seed", "Rotation", "Scale", "Radius" })
  {
    this->AddRow(function);
  }
  this->AddHelp(
    tr("Drag the ball to move over the surface. Drag the knob, or press [ ] - +, to rotate "
       "and scale. Esc undoes a drag."));
  this->TakeShortcut(Qt::Key_Plus); // in ParaView these keys grow and shrink a selection
  this->TakeShortcut(Qt::Key_Minus);
  this->RingActor = pqShapeDisplay::MakeCurve(this->Ring);
  this->AddActor(this->RingActor);
  this->AddActor(this->BallActor);
  this->AddActor(this->KnobActor);
}

double pqShapeHandleWidget::GetValue(const std::string& function, double otherwise) const
{
  const std::vector<double> values = this->GetValues(function);
  return values.empty() ? otherwise : values.front();
}

double pqShapeHandleWidget::GetSize() const
{
  if (this->GetProperty("Scale"))
  {
    return this->GetValue("Scale", 1.0);
  }
  // A radius of 0 leaves the choice to the filter.
  const double radius = this->GetValue("Radius", 0.0);
  return radius > 0.0 ? radius : 0.2 * this->GetSurface().GetSize();
}

bool pqShapeHandleWidget::SetTurn(double degrees)
{
  this->SetValues("Rotation", { Wrap(degrees) });
  return this->GetProperty("Rotation") != nullptr;
}

bool pqShapeHandleWidget::SetSize(double size)
{
  const char* function = this->GetProperty("Scale") ? "Scale" : "Radius";
  this->SetValues(function, { size });
  return this->GetProperty(function) != nullptr;
}

pqShapeHandleWidget::Frame pqShapeHandleWidget::MakeFrame()
{
  const std::vector<double> seed = this->GetValues("Seed");
  const pqShapePlace position =
    this->GetSurface().FindClosest(Eigen::Vector3d(seed[0], seed[1], seed[2]));
  const Eigen::Vector3d& normal = position.Normal;
  Eigen::Vector3d first = this->Zero - this->Zero.dot(normal) * normal;
  if (first.norm() < 1e-3)
  {
    first = normal.unitOrthogonal();
  }
  first.normalize();
  Frame frame;
  frame.Centre = position.Position;
  frame.Axes << first, normal.cross(first), normal;
  // The knob stays within reach for features of every size.
  const int* view = this->GetRenderer()->GetSize();
  const double pixel = pqShapeDisplay::PixelLength(this->GetRenderer(), frame.Centre);
  const double visible =
    std::min(view[0], view[1]) / pqShapeDisplay::PixelScale(this->GetRenderer());
  frame.Radius = pixel *
    std::max(SmallestRing, std::min(this->Unit * this->GetSize() / pixel, LargestRing * visible));
  const double turn = this->GetValue("Rotation", 0.0) * Pi / 180.0;
  frame.Knob = frame.Centre +
    frame.Radius * (std::cos(turn) * frame.Axes.col(0) + std::sin(turn) * frame.Axes.col(1));
  return frame;
}

void pqShapeHandleWidget::Place()
{
  if (!this->Placed.empty() && this->GetValues("Seed") != this->Placed)
  {
    return; // the user has moved it
  }
  vtkRenderer* renderer = this->GetRenderer();
  const Eigen::Vector2d middle(0.5 * renderer->GetSize()[0], 0.5 * renderer->GetSize()[1]);
  const Eigen::Vector2d centre = pqShapeDisplay::ToPixel(renderer, this->GetSurface().GetCentre());
  pqShapePlace position;
  if (!this->GetSurface().FindUnder(renderer, middle, position) &&
    !this->GetSurface().FindUnder(renderer, centre, position))
  {
    position =
      this->GetSurface().FindClosest(Eigen::Vector3d(renderer->GetActiveCamera()->GetPosition()));
  }
  this->Placed = { position.Position.x(), position.Position.y(), position.Position.z() };
  this->SetValues("Seed", this->Placed);
}

int pqShapeHandleWidget::FindPart(const Eigen::Vector2d& pixel)
{
  const Frame frame = this->MakeFrame();
  vtkRenderer* renderer = this->GetRenderer();
  const auto near = [&](const Eigen::Vector3d& position, double radius)
  {
    return (pqShapeDisplay::ToPixel(renderer, position) - pixel).norm() <=
      pqShapeDisplay::PixelScale(renderer) * (radius + GrabPixels);
  };
  if (near(frame.Centre, BallPixels))
  {
    return Ball;
  }
  return near(frame.Knob, KnobPixels) ? Knob : None;
}

void pqShapeHandleWidget::Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control)
{
  this->Moving = Motion::Move;
  if (shift || control)
  {
    this->Moving = shift ? Motion::Turn : Motion::Scale;
  }
  else if (part == Knob)
  {
    this->Moving = Motion::TurnAndScale;
  }
  this->FirstPixel = pixel;
  this->FirstFrame = this->MakeFrame();
  this->Offset = pqShapeDisplay::ToPixel(this->GetRenderer(), this->FirstFrame.Centre) - pixel;
  this->FirstTurn = this->GetValue("Rotation", 0.0);
  this->FirstSize = this->GetSize();
  this->Polar(pixel, this->FirstAngle, this->FirstDistance);
}

bool pqShapeHandleWidget::Polar(const Eigen::Vector2d& pixel, double& angle, double& distance)
{
  const pqShapeDisplay::Ray ray = pqShapeDisplay::ToRay(this->GetRenderer(), pixel);
  const Eigen::Matrix3d& axes = this->FirstFrame.Axes;
  const Eigen::Vector3d from = axes.transpose() * (ray.Near - this->FirstFrame.Centre);
  const Eigen::Vector3d way = axes.transpose() * ray.Direction;
  const double along = -from.z() / way.z();
  if (!(along > ray.First) || !std::isfinite(along))
  {
    return false; // the pixel shows no position of the ring's plane
  }
  const Eigen::Vector2d flat = (from + along * way).head<2>();
  angle = std::atan2(flat.y(), flat.x()) * 180.0 / Pi;
  distance = flat.norm();
  return true;
}

bool pqShapeHandleWidget::Drag(const Eigen::Vector2d& pixel)
{
  const Eigen::Vector2d way =
    (pixel - this->FirstPixel) / pqShapeDisplay::PixelScale(this->GetRenderer());
  switch (this->Moving)
  {
    case Motion::Turn:
      return this->SetTurn(this->FirstTurn + PixelDegrees * way.x());
    case Motion::Scale:
      return this->SetSize(this->FirstSize * std::pow(PixelFactor, way.y()));
    case Motion::TurnAndScale:
      return this->DragKnob(pixel);
    default:
      break;
  }
  pqShapePlace position;
  if (!this->GetSurface().FindUnder(this->GetRenderer(), pixel + this->Offset, position))
  {
    return false; // the mouse is not on the surface: the feature does not move
  }
  this->SetValues("Seed", { position.Position.x(), position.Position.y(), position.Position.z() });
  return true;
}

bool pqShapeHandleWidget::DragKnob(const Eigen::Vector2d& pixel)
{
  double angle = 0.0;
  double distance = 0.0;
  if (!this->Polar(pixel, angle, distance) || !(this->FirstDistance > 0.0 && distance > 0.0))
  {
    return false;
  }
  const bool turned = this->SetTurn(this->FirstTurn + angle - this->FirstAngle);
  const bool scaled = this->SetSize(this->FirstSize * distance / this->FirstDistance);
  return turned || scaled;
}

bool pqShapeHandleWidget::PressKey(const std::string& key)
{
  const double turn = key == "bracketleft" ? KeyDegrees : key == "bracketright" ? -KeyDegrees : 0.0;
  const bool larger = key == "plus" || key == "equal" || key == "KP_Add";
  const bool smaller = key == "minus" || key == "KP_Subtract";
  if (turn != 0.0 && this->GetProperty("Rotation"))
  {
    this->Burst([this, turn] { this->SetTurn(this->GetValue("Rotation", 0.0) + turn); });
    return true;
  }
  if (larger || smaller)
  {
    const double factor = larger ? KeyFactor : 1.0 / KeyFactor;
    this->Burst([this, factor] { this->SetSize(this->GetSize() * factor); });
    return true;
  }
  return false;
}

bool pqShapeHandleWidget::TurnWheel(int steps, bool control)
{
  if (this->GetHovered() == None)
  {
    return false;
  }
  if (control || !this->GetProperty("Rotation"))
  {
    this->Burst([this, steps] { this->SetSize(this->GetSize() * std::pow(KeyFactor, steps)); });
  }
  else
  {
    this->Burst(
      [this, steps] { this->SetTurn(this->GetValue("Rotation", 0.0) + KeyDegrees * steps); });
  }
  return true;
}

void pqShapeHandleWidget::Draw()
{
  vtkRenderer* renderer = this->GetRenderer();
  const Frame frame = this->MakeFrame();
  std::vector<Eigen::Vector3d> positions{ frame.Centre };
  const double start = this->GetValue("Rotation", 0.0) * Pi / 180.0;
  for (int i = 0; i <= RingSegments; ++i)
  {
    const double angle = start + 2.0 * Pi * i / RingSegments;
    positions.emplace_back(frame.Centre +
      frame.Radius * (std::cos(angle) * frame.Axes.col(0) + std::sin(angle) * frame.Axes.col(1)));
  }
  pqShapeDisplay::SetCurve(this->Ring, positions);
  pqShapeDisplay::SetWidth(this->RingActor, renderer, RingPixels);
  const double pixel = pqShapeDisplay::PixelLength(renderer, frame.Centre);
  pqShapeDisplay::PlaceBall(this->BallActor, frame.Centre, BallPixels * pixel);
  pqShapeDisplay::PlaceBall(this->KnobActor, frame.Knob, KnobPixels * pixel);

  // On the far side of the surface the handle is faint.
  const double opacity =
    pqShapeDisplay::FacesViewer(renderer, frame.Centre, frame.Axes.col(2)) ? 1.0 : 0.3;
  const auto paint = [&](vtkActor* actor, bool bright)
  {
    const double green = bright ? 0.85 : 0.55;
    actor->GetProperty()->SetColor(1.0, this->IsRefused() ? 0.1 : green, bright ? 0.4 : 0.05);
    actor->GetProperty()->SetOpacity(opacity);
  };
  paint(this->BallActor, this->GetHovered() == Ball);
  paint(this->KnobActor, this->GetHovered() == Knob);
  paint(this->RingActor, false);
}

void pqShapeHandleWidget::ReadFacts()
{
  std::vector<double> direction = pqShapeFacts::GetNumbers(this->proxy(), "Direction");
  if (direction.empty())
  {
    direction = pqShapeFacts::GetNumbers(this->proxy(), "XAxis");
  }
  if (direction.size() == 3)
  {
    this->Zero = Eigen::Vector3d(direction[0], direction[1], direction[2]);
  }
  if (vtkSMProperty* input = this->GetProperty("Feature"))
  {
    const vtkSMPropertyHelper feature(input);
    auto* source = vtkSMSourceProxy::SafeDownCast(feature.GetAsProxy());
    const vtkBoundingBox box = source
      ? vtkBoundingBox(source->GetDataInformation(feature.GetOutputPort())->GetBounds())
      : vtkBoundingBox();
    this->Unit = box.IsValid() ? 0.5 * box.GetDiagonalLength() : 1.0;
  }
}
