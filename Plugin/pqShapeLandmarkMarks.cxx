#include "pqShapeLandmarkMarks.h"

#include "pqShapeDisplay.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cstddef>

namespace
{

constexpr double MarkPixels = 6.0, HoveredMarkPixels = 8.0, LinePixels = 1.5, TextOffset = 9.0;
constexpr int TextSize = 15;
constexpr double FaintOpacity = 0.3;
/// Orange on Surface A, blue on Surface B; the last is for hovered marks.
constexpr double MarkColors[3][3] = { { 1.0, 0.55, 0.05 }, { 0.15, 0.55, 1.0 }, { 1.0, 0.9, 0.4 } };

} // namespace

pqShapeLandmarkMarks::pqShapeLandmarkMarks(const std::function<void(vtkProp*)>& add)
  : Add(add)
  , Lines(vtkSmartPointer<vtkPolyData>::New())
  , LinesActor(pqShapeDisplay::MakeCurve(this->Lines))
{
  this->LinesActor->GetProperty()->SetColor(0.55, 0.55, 0.55);
  this->Add(this->LinesActor);
}

void pqShapeLandmarkMarks::Draw(vtkRenderer* renderer,
  const std::vector<pqShapeLandmarkMark>& marks, const std::vector<Eigen::Vector3d>& lines)
{
  while (this->Balls.size() < marks.size())
  {
    this->Balls.push_back(pqShapeDisplay::MakeBall());
    this->Texts.push_back(vtkSmartPointer<vtkTextActor>::New());
    vtkTextActor* text = this->Texts.back();
    text->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    text->GetTextProperty()->SetFontSize(TextSize);
    text->GetTextProperty()->BoldOn();
    text->GetTextProperty()->ShadowOn();
    this->Add(this->Balls.back());
    this->Add(text);
  }
  for (std::size_t i = 0; i < this->Balls.size(); ++i)
  {
    vtkActor* ball = this->Balls[i];
    vtkTextActor* text = this->Texts[i];
    ball->SetVisibility(i < marks.size());
    text->SetVisibility(i < marks.size());
    if (i >= marks.size())
    {
      continue;
    }
    const pqShapeLandmarkMark& mark = marks[i];
    const double* color = MarkColors[mark.Hovered ? 2 : mark.Side];
    const double opacity = mark.Visible ? 1.0 : FaintOpacity;
    pqShapeDisplay::PlaceBall(ball, mark.Position,
      (mark.Hovered ? HoveredMarkPixels : MarkPixels) *
        pqShapeDisplay::PixelLength(renderer, mark.Position));
    ball->GetProperty()->SetColor(color[0], color[1], color[2]);
    ball->GetProperty()->SetOpacity(opacity);
    const Eigen::Vector2d pixel = pqShapeDisplay::ToPixel(renderer, mark.Position).array() +
      TextOffset * pqShapeDisplay::PixelScale(renderer);
    text->SetInput(mark.Text.c_str());
    text->SetPosition(pixel.x(), pixel.y());
    text->GetTextProperty()->SetOpacity(opacity);
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (i % 2 == 0)
    {
      cells->InsertNextCell(2);
    }
    cells->InsertCellPoint(points->InsertNextPoint(lines[i].data()));
  }
  this->Lines->SetPoints(points);
  this->Lines->SetLines(cells);
  pqShapeDisplay::SetWidth(this->LinesActor, renderer, LinePixels);
}
