#include "pqShapeMotionWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapeGrips.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

using namespace pqShapeGrips;

/// Lengths of the axis beyond the ring, and of a frame.
constexpr double AxisPixels = 24.0, FramePixels = 60.0;
/// Distance of a click from the handle at which it adds a frame.
constexpr double ClickReach = 8.0;
constexpr std::size_t MotionWidth = 8, FrameWidth = 6;
/// The output of the filter that is its handle.
constexpr int HandlePort = 1;

Eigen::Vector3d ToVector(const std::vector<double>& values, std::size_t first)
{
  return { values[first], values[first + 1], values[first + 2] };
}

void SetVector(const Eigen::Vector3d& vector, std::vector<double>& values, std::size_t first)
{
  std::copy(vector.data(), vector.data() + 3, values.begin() + static_cast<std::ptrdiff_t>(first));
}

Eigen::Matrix3d ToRotation(const Eigen::Vector3d& degrees)
{
  const double angle = degrees.norm();
  return Eigen::AngleAxisd(
    angle * Pi / 180.0, angle > 0.0 ? Eigen::Vector3d(degrees / angle) : Eigen::Vector3d::UnitZ())
    .toRotationMatrix();
}

/// Returns the rotation vector in degrees. Of those that differ by full turns, it is the one
/// closest to `before`, so that a frame can be dragged around several times.
Eigen::Vector3d ToRotationVector(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& before)
{
  const Eigen::AngleAxisd turn(rotation);
  const double degrees = turn.angle() * 180.0 / Pi;
  const double full = std::round((before.dot(turn.axis()) - degrees) / 360.0);
  return (degrees + 360.0 * full) * turn.axis();
}

Eigen::Matrix3d RotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

} // namespace

pqShapeMotionWidget::pqShapeMotionWidget(
  vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(filter, group, { "Motions", "Frames" }, parent)
{
  this->AddHelp(
    tr("Drag the ball to translate, with Shift along the axis; the knob to rotate and scale; the "
       "tip of the axis to tilt. Keys [ ] - + rotate and scale. Click the curve to add a frame, "
       "drag its tip to rotate the shape there, press Delete to remove it. Esc undoes a drag."));
  this->AddRow("Motions");
  this->AddRow("Frames");
  this->TakeShortcut(Qt::Key_Plus); // in ParaView these keys grow and shrink a selection
  this->TakeShortcut(Qt::Key_Minus);
  const auto addLines = [this](
                          vtkSmartPointer<vtkPolyData>& lines, vtkSmartPointer<vtkActor>& actor)
  {
    lines = vtkSmartPointer<vtkPolyData>::New();
    actor = pqShapeDisplay::MakeCurve(lines);
    actor->GetProperty()->SetColor(1.0, 0.55, 0.05);
    this->AddActor(actor);
  };
  addLines(this->CurveLines, this->CurveActor);
  addLines(this->RingLines, this->RingActor);
  addLines(this->AxisLines, this->AxisActor);
  addLines(this->BallMarks, this->MarkActor);
  addLines(this->FrameLines, this->FrameActor);
  addLines(this->FrameMarks, this->FrameMarkActor);
  for (vtkSmartPointer<vtkActor>* ball : { &this->BallActor, &this->KnobActor, &this->TipActor })
  {
    *ball = pqShapeDisplay::MakeBall();
    this->AddActor(*ball);
  }
}

bool pqShapeMotionWidget::UpdateSurface()
{
  if (!this->IsReady())
  {
    this->ReadFacts();
  }
  return this->IsReady();
}

void pqShapeMotionWidget::ReadFacts()
{
  auto* filter = vtkSMSourceProxy::SafeDownCast(this->proxy());
  this->Curves.Fetch(filter, HandlePort, this->view() ? this->GetTime() : 0.0);
  const auto parts = static_cast<int>(this->Curves.GetParts().size());
  this->Active = std::max(0, std::min(this->Active, parts - 1));
}

pqShapeMotionWidget::Motion pqShapeMotionWidget::GetMotion(int part) const
{
  const std::vector<double> values = this->GetValues("Motions");
  for (std::size_t i = 0; i + MotionWidth <= values.size(); i += MotionWidth)
  {
    if (values[i] == part)
    {
      return { ToVector(values, i + 1), ToVector(values, i + 4), values[i + 7] };
    }
  }
  return {};
}

void pqShapeMotionWidget::SetMotion(int part, const Motion& motion)
{
  std::vector<double> values = this->GetValues("Motions");
  std::size_t i = 0;
  while (i + MotionWidth <= values.size() && values[i] != part)
  {
    i += MotionWidth;
  }
  values.resize(std::max(values.size(), i + MotionWidth));
  values[i] = part;
  SetVector(motion.Translation, values, i + 1);
  SetVector(motion.Rotation, values, i + 4);
  values[i + 7] = motion.Scale;
  this->SetValues("Motions", values);
}

std::size_t pqShapeMotionWidget::CountFrames() const
{
  return this->GetValues("Frames").size() / FrameWidth;
}

int pqShapeMotionWidget::FindSample(std::size_t frame) const
{
  return this->Curves.FindAtRest(ToVector(this->GetValues("Frames"), FrameWidth * frame));
}

Eigen::Vector3d pqShapeMotionWidget::FindFrameTip(std::size_t frame) const
{
  const pqShapeHandleCurves::Sample& sample = this->Curves.GetSamples()[this->FindSample(frame)];
  const double pixel = pqShapeDisplay::PixelLength(this->GetRenderer(), sample.Position);
  return sample.Position + FramePixels * pixel * sample.Normal;
}

pqShapeMotionWidget::Gizmo pqShapeMotionWidget::MakeGizmo()
{
  Gizmo gizmo;
  gizmo.Part = this->Curves.GetParts()[this->Active];
  vtkRenderer* renderer = this->GetRenderer();
  const int* view = renderer->GetSize();
  const double pixel = pqShapeDisplay::PixelLength(renderer, gizmo.Part.Centre);
  const double visible = std::min(view[0], view[1]) / pqShapeDisplay::PixelScale(renderer);
  gizmo.Radius =
    pixel * std::max(SmallestRing, std::min(gizmo.Part.Radius / pixel, LargestRing * visible));
  gizmo.Knob = gizmo.Part.Centre + gizmo.Radius * gizmo.Part.Axes.col(0);
  gizmo.Tip = gizmo.Part.Centre + (gizmo.Radius + AxisPixels * pixel) * gizmo.Part.Axes.col(2);
  return gizmo;
}

int pqShapeMotionWidget::FindPart(const Eigen::Vector2d& pixel)
{
  vtkRenderer* renderer = this->GetRenderer();
  const auto near = [&](const Eigen::Vector3d& position, double radius)
  {
    return (pqShapeDisplay::ToPixel(renderer, position) - pixel).norm() <=
      pqShapeDisplay::PixelScale(renderer) * (radius + GrabPixels);
  };
  for (std::size_t i = 0; i < this->CountFrames(); ++i)
  {
    if (near(this->FindFrameTip(i), 0.5 * DotPixels))
    {
      return FirstFrame + static_cast<int>(i);
    }
  }
  const Gizmo gizmo = this->MakeGizmo();
  if (near(gizmo.Part.Centre, BallPixels))
  {
    return FirstBall + this->Active;
  }
  if (near(gizmo.Knob, KnobPixels))
  {
    return Knob;
  }
  if (near(gizmo.Tip, KnobPixels))
  {
    return Axis;
  }
  const std::vector<pqShapeHandleCurves::Part>& parts = this->Curves.GetParts();
  for (int i = 0; i < std::min(static_cast<int>(parts.size()), FirstFrame - FirstBall); ++i)
  {
    if (near(parts[i].Centre, 0.5 * DotPixels))
    {
      return FirstBall + i;
    }
  }
  return None;
}

void pqShapeMotionWidget::Grab(int part, const Eigen::Vector2d& pixel, bool shift, bool control)
{
  this->Grabbed = part;
  this->Shift = shift;
  this->Control = control;
  this->FirstPixel = pixel;
  if (part >= FirstFrame)
  {
    const auto frame = static_cast<std::size_t>(part - FirstFrame);
    const pqShapeHandleCurves::Sample& sample = this->Curves.GetSamples()[this->FindSample(frame)];
    this->Active = sample.Part;
    this->FirstOrigin = sample.Position;
    this->FirstNormal = sample.Normal;
    this->FirstTip = this->FindFrameTip(frame);
    this->FirstTurn = ToVector(this->GetValues("Frames"), FrameWidth * frame + 3);
  }
  else if (part >= FirstBall)
  {
    this->Active = part - FirstBall;
  }
  this->First = this->MakeGizmo();
  this->FirstMotion = this->GetMotion(this->Active);
}

bool pqShapeMotionWidget::Drag(const Eigen::Vector2d& pixel)
{
  if (this->Grabbed >= FirstFrame)
  {
    return this->DragFrame(pixel);
  }
  if (this->Grabbed >= FirstBall)
  {
    return this->DragBall(pixel);
  }
  return this->Grabbed == Knob ? this->DragKnob(pixel) : this->DragAxis(pixel);
}

bool pqShapeMotionWidget::FindInPlane(const Eigen::Vector2d& pixel, const Eigen::Vector3d& origin,
  const Eigen::Vector3d& normal, Eigen::Vector3d& position) const
{
  const pqShapeDisplay::Ray ray = pqShapeDisplay::ToRay(this->GetRenderer(), pixel);
  const double along = normal.dot(origin - ray.Near) / normal.dot(ray.Direction);
  position = ray.Near + along * ray.Direction;
  return along > ray.First && std::isfinite(along); // else the pixel shows nothing of the plane
}

bool pqShapeMotionWidget::Pull(
  const Eigen::Vector2d& pixel, const Eigen::Vector3d& from, Eigen::Vector3d& to) const
{
  const Eigen::Vector3d forward(this->GetRenderer()->GetActiveCamera()->GetDirectionOfProjection());
  const Eigen::Vector2d start = pqShapeDisplay::ToPixel(this->GetRenderer(), from);
  return this->FindInPlane(start + pixel - this->FirstPixel, from, forward, to);
}

bool pqShapeMotionWidget::DragBall(const Eigen::Vector2d& pixel)
{
  const Eigen::Vector3d& centre = this->First.Part.Centre;
  Eigen::Vector3d shift;
  if (this->Shift)
  {
    // The position of the axis under the mouse: in the plane through the axis that faces the viewer
    // best.
    const Eigen::Vector3d axis = this->First.Part.Axes.col(2);
    const Eigen::Vector2d start = pqShapeDisplay::ToPixel(this->GetRenderer(), centre);
    const pqShapeDisplay::Ray ray = pqShapeDisplay::ToRay(this->GetRenderer(), start);
    const Eigen::Vector3d across = axis.cross(ray.Direction);
    if (!this->FindInPlane(start + pixel - this->FirstPixel, centre, across.cross(axis), shift))
    {
      return false;
    }
    shift = axis.dot(shift - centre) * axis;
  }
  else if (this->Pull(pixel, centre, shift))
  {
    shift -= centre;
  }
  else
  {
    return false;
  }
  Motion motion = this->FirstMotion;
  motion.Translation += shift;
  this->SetMotion(this->Active, motion);
  return true;
}

bool pqShapeMotionWidget::DragKnob(const Eigen::Vector2d& pixel)
{
  const Eigen::Matrix3d& axes = this->First.Part.Axes;
  const Eigen::Vector3d& centre = this->First.Part.Centre;
  Eigen::Vector3d before, after;
  if (!this->FindInPlane(this->FirstPixel, centre, axes.col(2), before) ||
    !this->FindInPlane(pixel, centre, axes.col(2), after))
  {
    return false;
  }
  const Eigen::Vector3d from = axes.transpose() * (before - centre);
  const Eigen::Vector3d to = axes.transpose() * (after - centre);
  if (!(from.norm() > 0.0 && to.norm() > 0.0))
  {
    return false;
  }
  Motion motion = this->FirstMotion;
  if (!this->Control)
  {
    const double angle = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
    motion.Rotation = ToRotationVector(
      Eigen::AngleAxisd(angle, axes.col(2)) * ToRotation(this->FirstMotion.Rotation),
      this->FirstMotion.Rotation);
  }
  if (!this->Shift)
  {
    motion.Scale *= to.norm() / from.norm();
  }
  this->SetMotion(this->Active, motion);
  return true;
}

bool pqShapeMotionWidget::DragAxis(const Eigen::Vector2d& pixel)
{
  const Eigen::Vector3d& centre = this->First.Part.Centre;
  Eigen::Vector3d tip;
  if (!this->Pull(pixel, this->First.Tip, tip) || !((tip - centre).norm() > 0.0))
  {
    return false;
  }
  Motion motion = this->FirstMotion;
  motion.Rotation = ToRotationVector(RotationBetween(this->First.Part.Axes.col(2), tip - centre) *
      ToRotation(this->FirstMotion.Rotation),
    this->FirstMotion.Rotation);
  this->SetMotion(this->Active, motion);
  return true;
}

bool pqShapeMotionWidget::DragFrame(const Eigen::Vector2d& pixel)
{
  Eigen::Vector3d tip;
  if (!this->Pull(pixel, this->FirstTip, tip) || !((tip - this->FirstOrigin).norm() > 0.0))
  {
    return false;
  }
  const auto frame = static_cast<std::size_t>(this->Grabbed - FirstFrame);
  std::vector<double> values = this->GetValues("Frames");
  const std::size_t first = FrameWidth * frame + 3;
  // The frame is rotated before its part moves.
  const Eigen::Matrix3d moved = ToRotation(this->FirstMotion.Rotation);
  const Eigen::Matrix3d pulled = RotationBetween(this->FirstNormal, tip - this->FirstOrigin);
  SetVector(ToRotationVector(moved.transpose() * pulled * moved * ToRotation(this->FirstTurn),
              ToVector(values, first)),
    values, first);
  this->SetValues("Frames", values);
  return true;
}

bool pqShapeMotionWidget::Click(const Eigen::Vector2d& pixel)
{
  const int index = this->Curves.FindUnder(this->GetRenderer(), pixel, ClickReach);
  if (index < 0)
  {
    return false;
  }
  const pqShapeHandleCurves::Sample sample = this->Curves.GetSamples()[index];
  this->Active = sample.Part;
  for (std::size_t i = 0; i < this->CountFrames(); ++i)
  {
    if (this->Curves.GetSamples()[this->FindSample(i)].Rest == sample.Rest)
    {
      return true;
    }
  }
  this->Change(
    [&]
    {
      std::vector<double> values = this->GetValues("Frames");
      values.resize(values.size() + FrameWidth);
      SetVector(sample.Rest, values, values.size() - FrameWidth);
      SetVector(sample.Turn, values, values.size() - 3); // so far, interpolated: nothing changes
      this->SetValues("Frames", values);
    });
  return true;
}

bool pqShapeMotionWidget::PressKey(const std::string& key)
{
  const double turn = key == "bracketleft" ? KeyDegrees : key == "bracketright" ? -KeyDegrees : 0.0;
  const bool larger = key == "plus" || key == "equal" || key == "KP_Add";
  const bool smaller = key == "minus" || key == "KP_Subtract";
  const int hovered = this->GetHovered();
  if (key == "Delete" && hovered >= FirstFrame)
  {
    this->Change(
      [&]
      {
        std::vector<double> values = this->GetValues("Frames");
        const auto first = values.begin() +
          static_cast<std::ptrdiff_t>(FrameWidth) *
            static_cast<std::ptrdiff_t>(hovered - FirstFrame);
        values.erase(first, first + static_cast<std::ptrdiff_t>(FrameWidth));
        this->SetValues("Frames", values);
      });
    return true;
  }
  if (turn == 0.0 && !larger && !smaller)
  {
    return false;
  }
  this->Burst(
    [&]
    {
      Motion motion = this->GetMotion(this->Active);
      const Eigen::AngleAxisd step(
        turn * Pi / 180.0, Eigen::Vector3d(this->MakeGizmo().Part.Axes.col(2)));
      motion.Rotation = turn == 0.0
        ? motion.Rotation
        : ToRotationVector(step * ToRotation(motion.Rotation), motion.Rotation);
      motion.Scale *= larger ? KeyFactor : smaller ? 1.0 / KeyFactor : 1.0;
      this->SetMotion(this->Active, motion);
    });
  return true;
}
