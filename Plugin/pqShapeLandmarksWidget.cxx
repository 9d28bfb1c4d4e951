#include "pqShapeLandmarksWidget.h"

#include "pqShapeDisplay.h"
#include "pqShapePlacement.h"

#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMStringVectorProperty.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqFileDialog.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <cstddef>

namespace
{

constexpr double LandmarkGrabPixels = 9.0;
const char* const PositionFunctions[] = { "Points", "TargetPoints" };

} // namespace

pqShapeLandmarksWidget::pqShapeLandmarksWidget(
  vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(filter, group, { "Points", "TargetPoints", "Names" }, parent)
  , Target(group->GetProperty("TargetSurface"), [this] { this->RequestUpdate(); })
  , Pick(new QPushButton(tr("Pick"), this))
  , Table(new pqShapeLandmarkList(
      [this](const pqShapeLandmarkTable& landmarks) { this->SetTable(landmarks); }, this))
{
  this->AddButtons();
  const QString help = group->GetProperty("TargetSurface")
    ? tr(
        "Press Pick, then click a position on one surface and the corresponding one on the other. "
        "Esc cancels the open half of a pair. Points can be dragged. Delete removes the pair under "
        "the mouse.")
    : tr(
        "Press Pick, then click positions on the surface. Esc ends picking. Points can be dragged. "
        "Delete removes the point under the mouse.");
  this->AddHelp(help);
  this->Table->setObjectName("Landmarks");
  this->AddWidget(this->Table);
  for (const char* function : { "Points", "TargetPoints", "Names", "TargetSurface" })
  {
    if (vtkSMProperty* property = this->GetProperty(function))
    {
      pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(UpdateTable()));
    }
  }
  this->UpdateTable();
}

void pqShapeLandmarksWidget::AddButtons()
{
  auto* row = new QWidget(this);
  row->setObjectName("Buttons");
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Pick->setObjectName("Pick");
  this->Pick->setCheckable(true);
  layout->addWidget(this->Pick);
  QObject::connect(this->Pick, &QPushButton::toggled, this,
    [this]
    {
      this->Half.reset();
      this->RequestRender();
    });
  if (this->GetProperty("Names"))
  {
    auto* load = new QPushButton(tr("Load..."), row);
    auto* save = new QPushButton(tr("Save..."), row);
    load->setObjectName("Load");
    save->setObjectName("Save");
    layout->addWidget(load);
    layout->addWidget(save);
    QObject::connect(load, &QPushButton::clicked, this, [this] { this->Load(); });
    QObject::connect(save, &QPushButton::clicked, this, [this] { this->Save(); });
  }
  this->AddWidget(row);
}

void pqShapeLandmarksWidget::deselect()
{
  this->Pick->setChecked(false);
  this->Superclass::deselect();
}

vtkSMProperty* pqShapeLandmarksWidget::GetInput(int side) const
{
  return this->GetProperty(side == 0 ? "Surface" : "TargetSurface");
}

bool pqShapeLandmarksWidget::HasTarget() const
{
  return pqShapePlacement::FindSource(this->GetInput(1)) != nullptr;
}

const pqShapeSurface& pqShapeLandmarksWidget::GetSide(int side) const
{
  return side == 0 ? this->GetSurface() : this->Target;
}

pqShapeLandmarksWidget::Positions pqShapeLandmarksWidget::GetPositions(int side) const
{
  const std::vector<double> values = this->GetValues(PositionFunctions[side]);
  Positions positions;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
  {
    positions.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
  return positions;
}

void pqShapeLandmarksWidget::SetPositions(int side, const Positions& positions)
{
  std::vector<double> values;
  for (const Eigen::Vector3d& position : positions)
  {
    values.insert(values.end(), position.data(), position.data() + 3);
  }
  this->SetValues(PositionFunctions[side], values);
}

std::vector<std::string> pqShapeLandmarksWidget::GetNames() const
{
  auto* property = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty("Names"));
  return property ? property->GetElements() : std::vector<std::string>();
}

void pqShapeLandmarksWidget::SetNames(const std::vector<std::string>& names)
{
  if (auto* property = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty("Names")))
  {
    property->SetElements(names);
  }
}

std::vector<pqView*> pqShapeLandmarksWidget::FindViews() const
{
  std::vector<pqView*> views{ this->view() };
  for (pqView* view : pqApplicationCore::instance()->getServerManagerModel()->findItems<pqView*>())
  {
    const bool shows = pqShapePlacement::FindShown(this->GetInput(0), view) ||
      pqShapePlacement::FindShown(this->GetInput(1), view);
    if (view != this->view() && shows)
    {
      views.push_back(view);
    }
  }
  return views;
}

bool pqShapeLandmarksWidget::UpdateSurface()
{
  for (const int side : { 0, 1 })
  {
    if (pqPipelineSource* source = pqShapePlacement::FindSource(this->GetInput(side)))
    {
      QObject::connect(source, &pqPipelineSource::visibilityChanged, this,
        &pqShapeLandmarksWidget::RequestUpdate, Qt::UniqueConnection);
    }
  }
  const bool isThere = this->Superclass::UpdateSurface();
  return isThere && (!this->HasTarget() || this->Target.Update(this->GetTime()));
}

bool pqShapeLandmarksWidget::IsShown(int side) const
{
  pqView* view = this->GetDrawnView();
  if (side == 1 && !this->Target.IsThere())
  {
    return false;
  }
  return pqShapePlacement::FindShown(this->GetInput(side), view) ||
    !pqShapePlacement::FindShown(this->GetInput(1 - side), view);
}

Eigen::Affine3d pqShapeLandmarksWidget::GetTransform(int side) const
{
  return pqShapePlacement::FindTransform(
    pqShapePlacement::FindShown(this->GetInput(side), this->GetDrawnView()));
}

bool pqShapeLandmarksWidget::FindLandmark(const Eigen::Vector2d& pixel, Landmark& landmark) const
{
  const pqShapeDisplay::Ray ray = pqShapeDisplay::ToRay(this->GetRenderer(), pixel);
  bool found = false;
  double nearest = 0.0;
  // The surface that is expected comes first, for two surfaces at the same position.
  const int expected = this->Half ? 1 - this->Half->Side : 0;
  for (const int side : { expected, 1 - expected })
  {
    if (side >= this->CountSides() || !this->IsShown(side))
    {
      continue;
    }
    const Eigen::Affine3d transform = this->GetTransform(side);
    pqShapePlace hit;
    if (this->GetSide(side).FindAlong(pqShapePlacement::Transform(transform.inverse(), ray), hit))
    {
      const double distance = ray.Direction.dot(transform * hit.Position - ray.Near);
      if (!found || distance < nearest)
      {
        found = true;
        nearest = distance;
        landmark = { side, hit.Position };
      }
    }
  }
  return found;
}

int pqShapeLandmarksWidget::FindPart(const Eigen::Vector2d& pixel)
{
  vtkRenderer* renderer = this->GetRenderer();
  double nearest = LandmarkGrabPixels * pqShapeDisplay::PixelScale(renderer);
  int part = 0;
  for (int side = 0; side < this->CountSides(); ++side)
  {
    if (!this->IsShown(side))
    {
      continue;
    }
    const Eigen::Affine3d transform = this->GetTransform(side);
    const Positions positions = this->GetPositions(side);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const double distance =
        (pqShapeDisplay::ToPixel(renderer, transform * positions[i]) - pixel).norm();
      // Positions on the far side are visible, but cannot be grabbed.
      if (distance <= nearest &&
        pqShapeDisplay::FacesViewer(renderer, transform * positions[i],
          transform.linear() * this->GetSide(side).FindClosest(positions[i]).Normal))
      {
        nearest = distance;
        part = 1 + 2 * static_cast<int>(i) + side;
      }
    }
  }
  return part;
}

void pqShapeLandmarksWidget::Grab(int part, const Eigen::Vector2d& pixel, bool, bool)
{
  this->GrabbedIndex = static_cast<std::size_t>((part - 1) / 2);
  this->GrabbedSide = (part - 1) % 2;
  this->Offset = pqShapeDisplay::ToPixel(this->GetRenderer(),
                   this->GetTransform(this->GrabbedSide) *
                     this->GetPositions(this->GrabbedSide)[this->GrabbedIndex]) -
    pixel;
}

bool pqShapeLandmarksWidget::Drag(const Eigen::Vector2d& pixel)
{
  Positions positions = this->GetPositions(this->GrabbedSide);
  const pqShapeDisplay::Ray ray = pqShapeDisplay::ToRay(this->GetRenderer(), pixel + this->Offset);
  pqShapePlace hit;
  if (this->GrabbedIndex >= positions.size() || // an undo during the drag removed it
    !this->GetSide(this->GrabbedSide)
       .FindAlong(
         pqShapePlacement::Transform(this->GetTransform(this->GrabbedSide).inverse(), ray), hit))
  {
    return false;
  }
  positions[this->GrabbedIndex] = hit.Position;
  this->SetPositions(this->GrabbedSide, positions);
  return true;
}

bool pqShapeLandmarksWidget::Click(const Eigen::Vector2d& pixel)
{
  Landmark landmark;
  if (!this->Pick->isChecked() || !this->FindLandmark(pixel, landmark))
  {
    return false;
  }
  this->Append(landmark);
  return true;
}

void pqShapeLandmarksWidget::Append(const Landmark& landmark)
{
  const auto append = [this](const Landmark& added)
  {
    Positions positions = this->GetPositions(added.Side);
    positions.push_back(added.Position);
    this->SetPositions(added.Side, positions);
  };
  const bool isPaired = this->HasTarget();
  // Landmarks of one surface may have been loaded from a file; then the other half is missing.
  const bool isMissing = isPaired && !this->Half &&
    this->GetPositions(landmark.Side).size() < this->GetPositions(1 - landmark.Side).size();
  if (!isPaired || isMissing)
  {
    this->Change([&] { append(landmark); });
  }
  else if (this->Half && this->Half->Side != landmark.Side)
  {
    const Landmark half = *this->Half;
    this->Half.reset();
    this->Change(
      [&]
      {
        append(half);
        append(landmark);
      });
  }
  else
  {
    this->Half = landmark;
  }
}

void pqShapeLandmarksWidget::Remove(std::size_t index)
{
  this->Change(
    [this, index]
    {
      for (const int side : { 0, 1 })
      {
        Positions positions = this->GetPositions(side);
        if (index < positions.size())
        {
          positions.erase(positions.begin() + static_cast<std::ptrdiff_t>(index));
          this->SetPositions(side, positions);
        }
      }
      std::vector<std::string> names = this->GetNames();
      if (index < names.size())
      {
        names.erase(names.begin() + static_cast<std::ptrdiff_t>(index));
        this->SetNames(names);
      }
    });
}

bool pqShapeLandmarksWidget::PressKey(const std::string& key)
{
  if (key == "Escape" && this->Half)
  {
    this->Half.reset();
  }
  else if (key == "Escape" && this->Pick->isChecked())
  {
    this->Pick->setChecked(false);
  }
  else if (key == "Delete" && this->GetHovered() > 0)
  {
    this->Remove(static_cast<std::size_t>((this->GetHovered() - 1) / 2));
  }
  else
  {
    return false;
  }
  this->RequestRender();
  return true;
}

void pqShapeLandmarksWidget::Draw()
{
  vtkRenderer* renderer = this->GetRenderer();
  std::vector<pqShapeLandmarkMark> marks;
  Positions ends[2];
  const std::vector<std::string> names = this->GetNames();
  for (int side = 0; side < this->CountSides(); ++side)
  {
    if (!this->IsShown(side))
    {
      continue;
    }
    const Eigen::Affine3d transform = this->GetTransform(side);
    const auto add = [&](const Eigen::Vector3d& position, const std::string& text, bool hovered)
    {
      const Eigen::Vector3d shown = transform * position;
      const Eigen::Vector3d normal =
        transform.linear() * this->GetSide(side).FindClosest(position).Normal;
      marks.push_back(
        { shown, text, side, pqShapeDisplay::FacesViewer(renderer, shown, normal), hovered });
      ends[side].push_back(shown);
    };
    const Positions positions = this->GetPositions(side);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const std::string number = std::to_string(i + 1);
      const bool isNamed = i < names.size() && !names[i].empty();
      add(positions[i], isNamed ? number + " " + names[i] : number,
        this->GetHovered() > 0 && static_cast<std::size_t>((this->GetHovered() - 1) / 2) == i);
    }
    if (this->Half && this->Half->Side == side)
    {
      add(this->Half->Position, std::to_string(positions.size() + 1), true);
      ends[side].pop_back();
    }
  }
  Positions lines;
  for (std::size_t i = 0; i < std::min(ends[0].size(), ends[1].size()); ++i)
  {
    lines.push_back(ends[0][i]);
    lines.push_back(ends[1][i]);
  }
  std::unique_ptr<pqShapeLandmarkMarks>& drawn = this->Marks[this->GetOverlay()];
  if (!drawn)
  {
    drawn =
      std::make_unique<pqShapeLandmarkMarks>([this](vtkProp* actor) { this->AddActor(actor); });
  }
  drawn->Draw(renderer, marks, lines);
}

pqShapeLandmarkTable pqShapeLandmarksWidget::GetTable() const
{
  // The table is updated by the event of a new value, which comes before the panel's copy of it.
  const auto read = [this](const char* function)
  {
    vtkSMProperty* property = this->GetProperty(function);
    return property ? vtkSMPropertyHelper(property).GetDoubleArray() : std::vector<double>();
  };
  return { read("Points"), read("TargetPoints"), this->GetNames() };
}

void pqShapeLandmarksWidget::SetTable(const pqShapeLandmarkTable& landmarks)
{
  this->Change(
    [&]
    {
      this->SetValues("Points", landmarks.Points);
      this->SetValues("TargetPoints", landmarks.TargetPoints);
      this->SetNames(landmarks.Names);
    });
  this->UpdateTable(); // an entry that is no position is replaced by the last one
}

void pqShapeLandmarksWidget::UpdateTable()
{
  this->Table->Show(this->GetTable(), this->GetProperty("Names") != nullptr, this->HasTarget());
}

void pqShapeLandmarksWidget::Load()
{
  pqFileDialog dialog(nullptr, pqCoreUtilities::mainWidget(), tr("Load Landmarks"), QString(),
    tr("Landmarks (*.csv *.fcsv *.mrk.json *.pp *.pts *.tps)"));
  dialog.setObjectName("LoadLandmarks");
  dialog.setFileMode(pqFileDialog::ExistingFile);
  pqShapeLandmarkTable table;
  if (dialog.exec() != QDialog::Accepted ||
    !pqShapeLandmarkFiles::Read(dialog.getSelectedFiles().first(), table))
  {
    return;
  }
  this->Half.reset();
  // Landmarks of one surface are those of A; after those of A, they are those of B.
  pqShapeLandmarkTable landmarks = this->GetTable();
  if (this->HasTarget() && table.TargetPoints.empty() && !landmarks.Points.empty() &&
    landmarks.TargetPoints.empty())
  {
    landmarks.TargetPoints = table.Points;
    this->SetTable(landmarks);
    return;
  }
  this->SetTable(table);
}

void pqShapeLandmarksWidget::Save()
{
  pqFileDialog dialog(nullptr, pqCoreUtilities::mainWidget(), tr("Save Landmarks"), QString(),
    tr("Comma-separated values (*.csv);;Landmark Editor (*.pts);;tpsDig (*.tps)"));
  dialog.setObjectName("SaveLandmarks");
  dialog.setFileMode(pqFileDialog::AnyFile);
  if (dialog.exec() != QDialog::Accepted)
  {
    return;
  }
  const QString path = dialog.getSelectedFiles().first();
  const QString problem = pqShapeLandmarkFiles::Write(path, this->GetTable());
  if (!problem.isEmpty())
  {
    QMessageBox::critical(this, tr("Save Landmarks"), problem);
  }
}
