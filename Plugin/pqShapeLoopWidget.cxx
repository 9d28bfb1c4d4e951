#include "pqShapeLoopWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapeFetch.h"
#include "pqShapePorts.h"

#include "vtkActor.h"
#include "vtkPVDataInformation.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include <QPushButton>

#include <cstddef>

namespace
{

constexpr double CurvePixels = 3.0, MarkPixels = 10.0, LoopGrabPixels = 8.0, HoveredPixels = 7.0;
/// Number of surface positions through which the curve between two positions is drawn.
constexpr int Samples = 12;
constexpr std::size_t MinimumPositions = 3;

} // namespace

pqShapeLoopWidget::pqShapeLoopWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(filter, group, { "Points" }, parent)
  , Button(new QPushButton(tr("Draw Loop"), this))
  , Curve(vtkSmartPointer<vtkPolyData>::New())
  , Marks(vtkSmartPointer<vtkPolyData>::New())
  , HiddenMarks(vtkSmartPointer<vtkPolyData>::New())
{
  this->Button->setObjectName("DrawLoop");
  this->Button->setCheckable(true);
  this->AddWidget(this->Button);
  this->AddHelp(
    tr("Click positions on the surface. Double-click or Enter closes the loop, Backspace "
       "removes the last position, Esc cancels. Positions of a closed loop can be dragged. "
       "Delete removes the position under the mouse."));
  this->AddRow("Points");
  QObject::connect(this->Button, &QPushButton::toggled, this,
    [this]
    {
      this->Drawn.clear();
      this->ShowSurface();
      this->RequestRender();
    });

  this->CurveActor = pqShapeDisplay::MakeCurve(this->Curve);
  this->MarksActor = pqShapeDisplay::MakeCurve(this->Marks);
  this->HiddenMarksActor = pqShapeDisplay::MakeCurve(this->HiddenMarks);
  this->HoveredActor = pqShapeDisplay::MakeBall();
  this->CurveActor->GetProperty()->SetColor(1.0, 0.55, 0.05);
  this->MarksActor->GetProperty()->SetColor(1.0, 0.55, 0.05);
  this->HiddenMarksActor->GetProperty()->SetColor(0.55, 0.4, 0.25);
  this->HoveredActor->GetProperty()->SetColor(1.0, 0.85, 0.4);
  this->AddActor(this->CurveActor);
  this->AddActor(this->MarksActor);
  this->AddActor(this->HiddenMarksActor);
  this->AddActor(this->HoveredActor);
}

void pqShapeLoopWidget::deselect()
{
  this->Button->setChecked(false);
  this->Superclass::deselect();
}

void pqShapeLoopWidget::ShowSurface()
{
  if (!this->view())
  {
    return;
  }
  pqOutputPort* port = pqShapePorts::FindInput(
    this->proxy(), this->proxy()->GetPropertyName(this->GetProperty("Surface")));
  if (this->IsDrawing() && port && !pqShapePorts::IsVisible(port, this->view()))
  {
    this->ShownSurface = port;
    pqShapePorts::SetVisible(port, this->view(), true);
  }
  else if (!this->IsDrawing() && this->ShownSurface)
  {
    const auto* filter =
      pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
        this->proxy());
    // Without a result, there is nothing else to see.
    if (filter && filter->getOutputPort(0)->getDataInformation()->GetNumberOfPoints() > 0)
    {
      pqShapePorts::SetVisible(this->ShownSurface, this->view(), false);
    }
    this->ShownSurface.clear();
  }
}

bool pqShapeLoopWidget::IsDrawing() const
{
  return this->Button->isChecked();
}

pqShapeLoopWidget::Positions pqShapeLoopWidget::GetPlaces() const
{
  if (this->IsDrawing())
  {
    return this->Drawn;
  }
  const std::vector<double> values = this->GetValues("Points");
  Positions positions;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
  {
    positions.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
  return positions;
}

void pqShapeLoopWidget::SetPlaces(const Positions& positions)
{
  std::vector<double> values;
  for (const Eigen::Vector3d& position : positions)
  {
    values.insert(values.end(), position.data(), position.data() + 3);
  }
  this->SetValues("Points", values);
}

int pqShapeLoopWidget::FindPart(const Eigen::Vector2d& pixel)
{
  if (this->IsDrawing())
  {
    return 0;
  }
  vtkRenderer* renderer = this->GetRenderer();
  const double reach = LoopGrabPixels * pqShapeDisplay::PixelScale(renderer);
  const Positions positions = this->GetPlaces();
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    // Positions on the far side are visible, but cannot be grabbed.
    if ((pqShapeDisplay::ToPixel(renderer, positions[i]) - pixel).norm() <= reach &&
      this->FacesViewer(positions[i]))
    {
      return static_cast<int>(i) + 1;
    }
  }
  return 0;
}

bool pqShapeLoopWidget::FacesViewer(const Eigen::Vector3d& position) const
{
  return pqShapeDisplay::FacesViewer(
    this->GetRenderer(), position, this->GetSurface().FindClosest(position).Normal);
}

void pqShapeLoopWidget::Grab(int part, const Eigen::Vector2d& pixel, bool, bool)
{
  this->Grabbed = part - 1;
  const Positions positions = this->GetPlaces();
  this->Offset = pqShapeDisplay::ToPixel(
                   this->GetRenderer(), positions[static_cast<std::size_t>(this->Grabbed)]) -
    pixel;
}

bool pqShapeLoopWidget::Drag(const Eigen::Vector2d& pixel)
{
  const auto grabbed = static_cast<std::size_t>(this->Grabbed);
  Positions positions = this->GetPlaces();
  pqShapePlace position;
  if (grabbed >= positions.size() || // an undo during the drag removed it
    !this->GetSurface().FindUnder(this->GetRenderer(), pixel + this->Offset, position))
  {
    return false;
  }
  positions[grabbed] = position.Position;
  this->SetPlaces(positions);
  return true;
}

bool pqShapeLoopWidget::Click(const Eigen::Vector2d& pixel)
{
  pqShapePlace position;
  if (!this->IsDrawing() || !this->GetSurface().FindUnder(this->GetRenderer(), pixel, position))
  {
    return false;
  }
  this->Drawn.push_back(position.Position);
  return true;
}

bool pqShapeLoopWidget::DoubleClick()
{
  if (!this->IsDrawing())
  {
    return false;
  }
  this->Close();
  return true;
}

void pqShapeLoopWidget::Close()
{
  if (this->Drawn.size() < MinimumPositions)
  {
    return;
  }
  const Positions positions = this->Drawn;
  this->Button->setChecked(false);
  this->Change([this, &positions] { this->SetPlaces(positions); });
}

bool pqShapeLoopWidget::PressKey(const std::string& key)
{
  if (this->IsDrawing())
  {
    if (key == "Return" || key == "KP_Enter")
    {
      this->Close();
    }
    else if (key == "Escape")
    {
      this->Button->setChecked(false);
    }
    else if (key == "BackSpace" && !this->Drawn.empty())
    {
      this->Drawn.pop_back();
    }
    else
    {
      return false;
    }
    this->RequestRender();
    return true;
  }
  Positions positions = this->GetPlaces();
  if (key != "Delete" || this->GetHovered() == 0 || positions.size() <= MinimumPositions)
  {
    return false;
  }
  positions.erase(positions.begin() + this->GetHovered() - 1);
  this->Change([this, &positions] { this->SetPlaces(positions); });
  return true;
}

bool pqShapeLoopWidget::TurnWheel(int, bool)
{
  return false;
}

void pqShapeLoopWidget::Draw()
{
  const Positions positions = this->GetPlaces();
  this->DrawCurve(positions);
  this->DrawMarks(positions);
  pqShapeDisplay::SetWidth(this->CurveActor, this->GetRenderer(), CurvePixels);
  pqShapeDisplay::SetWidth(this->MarksActor, this->GetRenderer(), MarkPixels);
  pqShapeDisplay::SetWidth(this->HiddenMarksActor, this->GetRenderer(), MarkPixels);
  const int hovered = this->GetHovered();
  const bool bright = hovered > 0 && static_cast<std::size_t>(hovered) <= positions.size();
  this->HoveredActor->SetVisibility(bright);
  if (bright)
  {
    const Eigen::Vector3d& position = positions[static_cast<std::size_t>(hovered) - 1];
    pqShapeDisplay::PlaceBall(this->HoveredActor, position,
      HoveredPixels * pqShapeDisplay::PixelLength(this->GetRenderer(), position));
  }
}

/// During the update of the filter, nothing is fetched: UpdateSurface follows it.
void pqShapeLoopWidget::ReadFacts()
{
  this->IsCutOutdated = true;
}

bool pqShapeLoopWidget::UpdateSurface()
{
  const bool isThere = this->Superclass::UpdateSurface();
  if (this->IsCutOutdated)
  {
    this->IsCutOutdated = false;
    this->FetchCut();
    this->Shown.clear(); // to be drawn again
    this->RequestRender();
  }
  return isThere;
}

void pqShapeLoopWidget::FetchCut()
{
  this->Cut = nullptr;
  auto* filter = vtkSMSourceProxy::SafeDownCast(this->proxy());
  const Positions positions = this->IsDrawing() ? Positions() : this->GetPlaces();
  // A refused loop was not cut: the output is that of another one.
  if (!filter || positions.empty() || this->IsRefused() ||
    filter->GetDataInformation(0)->GetNumberOfPoints() == 0)
  {
    return;
  }
  const pqScopedUndoExclude exclude; // a drag, which is one step of undo, may not have ended
  const vtkSmartPointer<vtkSMSourceProxy> edges =
    pqShapeFetch::NewFilter("FeatureEdges", filter, 0);
  for (const char* kind : { "FeatureEdges", "NonManifoldEdges", "ManifoldEdges" })
  {
    vtkSMPropertyHelper(edges, kind).Set(0);
  }
  edges->UpdateVTKObjects();
  edges->UpdatePipeline(this->GetTime());
  this->Cut = vtkPolyData::SafeDownCast(pqShapeFetch::Fetch(edges, 0, this->GetTime()));
  this->CutPositions = positions;
}

void pqShapeLoopWidget::DrawCurve(const Positions& positions)
{
  const bool closed = !this->IsDrawing();
  const int version = this->GetSurface().GetVersion();
  if (positions == this->Shown && closed == this->ShownClosed && version == this->ShownVersion)
  {
    return;
  }
  this->Shown = positions;
  this->ShownClosed = closed;
  this->ShownVersion = version;
  if (closed && this->Cut && positions == this->CutPositions)
  {
    // without the arrays, by which it would be coloured
    this->Curve->SetPoints(this->Cut->GetPoints());
    this->Curve->SetLines(this->Cut->GetLines());
    return;
  }
  Positions curve;
  const std::size_t segments =
    positions.empty() || closed ? positions.size() : positions.size() - 1;
  for (std::size_t i = 0; i < segments; ++i)
  {
    const Eigen::Vector3d& from = positions[i];
    const Eigen::Vector3d& to = positions[(i + 1) % positions.size()];
    for (int k = 0; k < Samples; ++k)
    {
      curve.push_back(
        this->GetSurface().FindClosest(from + (to - from) * k / double(Samples)).Position);
    }
  }
  if (segments > 0)
  {
    curve.push_back(positions[segments % positions.size()]);
  }
  pqShapeDisplay::SetCurve(this->Curve, curve);
}

void pqShapeLoopWidget::DrawMarks(const Positions& positions)
{
  Positions near, hidden;
  for (const Eigen::Vector3d& position : positions)
  {
    (this->FacesViewer(position) ? near : hidden).push_back(position);
  }
  pqShapeDisplay::SetMarks(this->Marks, near);
  pqShapeDisplay::SetMarks(this->HiddenMarks, hidden);
}
