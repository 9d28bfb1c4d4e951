#include "vtkShapePaintArray.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeList.h"
#include "vtkShapePositions.h"
#include "vtkShapeSeenInput.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"

#include <cmath>

vtkStandardNewMacro(vtkShapePaintArray);

namespace
{

constexpr int StrokeWidth = 5; // numbers for each stroke

} // namespace

/// The last surface and what was painted on it.
struct vtkShapePaintArray::Kept
{
  vtkShapeSeenInput Input;
  Eigen::VectorXd Initial;
  std::unique_ptr<shape::SurfacePainter> Painter;
};

vtkShapePaintArray::vtkShapePaintArray()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
}

vtkShapePaintArray::~vtkShapePaintArray() = default;

void vtkShapePaintArray::SetNumberOfStrokes(int count)
{
  vtkShapeList::Resize(this, this->Strokes, count, StrokeWidth);
}

void vtkShapePaintArray::SetStrokes(
  int index, double mode, double radius, double strength, double value, double points)
{
  vtkShapeList::Set(
    this, "Strokes", this->Strokes, index, { mode, radius, strength, value, points });
}

void vtkShapePaintArray::SetNumberOfStrokePoints(int count)
{
  vtkShapeList::Resize(this, this->StrokePoints, count, 3);
}

void vtkShapePaintArray::SetStrokePoints(int index, double x, double y, double z)
{
  vtkShapeList::Set(this, "Stroke Points", this->StrokePoints, index, { x, y, z });
}

std::vector<shape::BrushStroke> vtkShapePaintArray::MakeStrokes() const
{
  const Eigen::MatrixXd positions = vtkShapePositions::ToRows(this->StrokePoints);
  std::vector<shape::BrushStroke> strokes;
  Eigen::Index used = 0;
  for (std::size_t first = 0; first < this->Strokes.size(); first += StrokeWidth)
  {
    const std::string name = " of stroke " + std::to_string(strokes.size());
    const double* numbers = &this->Strokes[first];
    shape::RequireOption(numbers[0] == 0.0 || numbers[0] == 1.0 || numbers[0] == 2.0, "Mode" + name,
      numbers[0], "0 (Set), 1 (Add) or 2 (Smooth)");
    const auto left = static_cast<double>(positions.rows() - used);
    shape::RequireOption(
      numbers[4] >= 0.0 && numbers[4] <= left && numbers[4] == std::floor(numbers[4]),
      "Number of points" + name, numbers[4],
      "an integer, at most the " + std::to_string(positions.rows() - used) +
        " Stroke Points that are left for it");
    shape::BrushStroke stroke;
    stroke.Mode = static_cast<shape::BrushStroke::ModeType>(static_cast<int>(numbers[0]));
    stroke.Radius = numbers[1];
    stroke.Strength = numbers[2];
    stroke.Value = numbers[3];
    stroke.Positions = positions.middleRows(used, static_cast<Eigen::Index>(numbers[4]));
    used += stroke.Positions.rows();
    strokes.push_back(stroke);
  }
  if (used != positions.rows())
  {
    throw shape::InvalidInput("Strokes have " + std::to_string(used) + " points, and there are " +
      std::to_string(positions.rows()) +
      " Stroke Points; give each stroke the number of its points");
  }
  return strokes;
}

Eigen::VectorXd vtkShapePaintArray::MakeInitialValues() const
{
  vtkPolyData* whole = this->GetGatheredInput(0).Data;
  if (whole->GetPointData()->GetAbstractArray(this->ArrayName.c_str()))
  {
    return vtkShapeConvert::ToPointArray(whole, this->ArrayName, 1, "the Input").col(0);
  }
  return Eigen::VectorXd::Constant(whole->GetNumberOfPoints(), this->InitialValue);
}

void vtkShapePaintArray::Execute(const shape::Progress& progress)
{
  shape::RequireOption(
    std::isfinite(this->InitialValue), "Initial Value", this->InitialValue, "finite");
  if (this->ArrayName.empty())
  {
    throw shape::InvalidInput("Array Name is empty; give the array to paint a name");
  }
  const std::vector<shape::BrushStroke> strokes = this->MakeStrokes();
  const GatheredInput& whole = this->GetGatheredInput(0);
  const Eigen::VectorXd initial = this->MakeInitialValues();
  Kept& kept = *this->Cache;
  if (kept.Input.IsNew(*this, 0, whole.Data) || !kept.Painter || kept.Initial != initial)
  {
    kept.Painter.reset(); // an error below must not leave the last surface
    kept.Initial = initial;
    kept.Painter = std::make_unique<shape::SurfacePainter>(
      vtkShapeConvert::ToMesh(whole.Data, "the surface"), initial);
  }
  const Eigen::VectorXd& values = kept.Painter->Paint(strokes, progress);
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), output,
    { { this->ArrayName, vtkShapeConvert::Rows(values, whole.OwnPoints) } });
  vtkShapeComposite::ActivateScalars(output, { this->ArrayName });
  progress(1.0);
}
