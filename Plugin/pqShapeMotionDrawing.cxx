// What pqShapeMotionWidget draws.
#include "pqShapeMotionWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapeGrips.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cmath>
#include <cstddef>

namespace
{

using namespace pqShapeGrips;

/// Width of the handle, and length of the normals between frames.
constexpr double HandlePixels = 3.0, NormalPixels = 24.0;
/// Number of normals that are drawn along the handle if it has frames.
constexpr std::size_t DrawnNormals = 64;

} // namespace

void pqShapeMotionWidget::DrawFrames()
{
  vtkRenderer* renderer = this->GetRenderer();
  const std::vector<pqShapeHandleCurves::Sample>& samples = this->Curves.GetSamples();
  std::vector<Eigen::Vector3d> positions, tips;
  std::vector<std::pair<int, int>> lines;
  const auto addLine = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    lines.emplace_back(static_cast<int>(positions.size()), static_cast<int>(positions.size()) + 1);
    positions.insert(positions.end(), { from, to });
  };
  const std::size_t frames = this->CountFrames();
  for (std::size_t i = 0; i < frames; ++i)
  {
    tips.push_back(this->FindFrameTip(i));
    addLine(samples[this->FindSample(i)].Position, tips.back());
  }
  const std::size_t stride = samples.size() / DrawnNormals + 1;
  for (std::size_t i = 0; i < samples.size() && frames > 0; i += stride)
  {
    const double pixel = pqShapeDisplay::PixelLength(renderer, samples[i].Position);
    addLine(samples[i].Position, samples[i].Position + NormalPixels * pixel * samples[i].Normal);
  }
  pqShapeDisplay::SetLines(this->FrameLines, positions, lines);
  pqShapeDisplay::SetWidth(this->FrameActor, renderer, RingPixels);
  pqShapeDisplay::SetMarks(this->FrameMarks, tips);
  pqShapeDisplay::SetWidth(this->FrameMarkActor, renderer, DotPixels);
}

void pqShapeMotionWidget::Draw()
{
  vtkRenderer* renderer = this->GetRenderer();
  const Gizmo gizmo = this->MakeGizmo();
  std::vector<Eigen::Vector3d> positions;
  for (const pqShapeHandleCurves::Sample& sample : this->Curves.GetSamples())
  {
    positions.push_back(sample.Position);
  }
  pqShapeDisplay::SetLines(this->CurveLines, positions, this->Curves.GetSegments());
  pqShapeDisplay::SetWidth(this->CurveActor, renderer, HandlePixels);
  const Eigen::Vector3d& centre = gizmo.Part.Centre;
  std::vector<Eigen::Vector3d> ring;
  for (int i = 0; i <= RingSegments; ++i)
  {
    const double angle = 2.0 * Pi * i / RingSegments;
    ring.emplace_back(centre +
      gizmo.Radius *
        (std::cos(angle) * gizmo.Part.Axes.col(0) + std::sin(angle) * gizmo.Part.Axes.col(1)));
  }
  pqShapeDisplay::SetCurve(this->RingLines, ring);
  pqShapeDisplay::SetWidth(this->RingActor, renderer, RingPixels);
  pqShapeDisplay::SetCurve(this->AxisLines, { centre, gizmo.Tip });
  pqShapeDisplay::SetWidth(this->AxisActor, renderer, RingPixels);
  std::vector<Eigen::Vector3d> others;
  for (std::size_t i = 0; i < this->Curves.GetParts().size(); ++i)
  {
    if (static_cast<int>(i) != this->Active)
    {
      others.push_back(this->Curves.GetParts()[i].Centre);
    }
  }
  pqShapeDisplay::SetMarks(this->BallMarks, others);
  pqShapeDisplay::SetWidth(this->MarkActor, renderer, DotPixels);
  this->DrawFrames();

  const double pixel = pqShapeDisplay::PixelLength(renderer, centre);
  pqShapeDisplay::PlaceBall(this->BallActor, centre, BallPixels * pixel);
  pqShapeDisplay::PlaceBall(this->KnobActor, gizmo.Knob, KnobPixels * pixel);
  pqShapeDisplay::PlaceBall(this->TipActor, gizmo.Tip, KnobPixels * pixel);
  const auto paint = [](vtkActor* actor, bool bright)
  { actor->GetProperty()->SetColor(1.0, bright ? 0.85 : 0.55, bright ? 0.4 : 0.05); };
  paint(this->BallActor, this->GetHovered() == FirstBall + this->Active);
  paint(this->KnobActor, this->GetHovered() == Knob);
  paint(this->TipActor, this->GetHovered() == Axis);
  paint(this->FrameMarkActor, this->GetHovered() >= FirstFrame);
}
