#include "vtkShapePastedData.h"

#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "CutPaste/Seam.h"
#include "Geometry/SurfaceWelding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// The sources of the tuples of the result. The first tuples are from one part, the next from the
/// other part, and the last are between two of these.
struct Sources
{
  std::vector<vtkIdType> First;
  std::vector<vtkIdType> Second;
  std::vector<std::array<int, 2>> Midpoints;
};

bool AreAlike(vtkAbstractArray* one, vtkAbstractArray* other)
{
  return one && other && one->GetDataType() == other->GetDataType() &&
    one->GetNumberOfComponents() == other->GetNumberOfComponents();
}

/// Copies the tuples `from` of an array to the result, beginning at `at`. If there is no array, the
/// tuples become zeros or empty strings.
void CopyTuples(
  vtkAbstractArray* values, const std::vector<vtkIdType>& from, vtkIdType at, vtkAbstractArray* to)
{
  const auto count = static_cast<vtkIdType>(from.size());
  if (values)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      to->SetTuple(at + i, from[i], values);
    }
  }
  else if (auto* numbers = vtkDataArray::SafeDownCast(to))
  {
    for (vtkIdType i = at; i < at + count; ++i)
    {
      for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
      {
        numbers->SetComponent(i, k, 0.0);
      }
    }
  }
}

/// Copies all arrays of both parts to the result's tuples.
void Merge(vtkDataSetAttributes* first, vtkDataSetAttributes* second, const Sources& sources,
  vtkDataSetAttributes* result)
{
  const auto append = [&](vtkAbstractArray* like, vtkAbstractArray* one, vtkAbstractArray* other)
  {
    const std::string name = like->GetName() ? like->GetName() : "";
    // Arrays without a name cannot be paired. Ghost markers and global ids are no longer valid.
    if (name.empty() || name == vtkDataSetAttributes::GhostArrayName() ||
      like == first->GetGlobalIds() || like == second->GetGlobalIds() ||
      result->HasArray(name.c_str()))
    {
      return;
    }
    auto array = vtkSmartPointer<vtkAbstractArray>::Take(like->NewInstance());
    array->SetName(name.c_str());
    array->SetNumberOfComponents(like->GetNumberOfComponents());
    array->SetNumberOfTuples(static_cast<vtkIdType>(
      sources.First.size() + sources.Second.size() + sources.Midpoints.size()));
    CopyTuples(one, sources.First, 0, array);
    CopyTuples(other, sources.Second, static_cast<vtkIdType>(sources.First.size()), array);
    result->AddArray(array);
  };
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = first->GetAbstractArray(i);
    vtkAbstractArray* other =
      array->GetName() ? second->GetAbstractArray(array->GetName()) : nullptr;
    // An array that only one part has, or that has another type on the other part, is zero there.
    append(array, array, AreAlike(array, other) ? other : nullptr);
  }
  for (int i = 0; i < second->GetNumberOfArrays(); ++i)
  {
    append(second->GetAbstractArray(i), nullptr, second->GetAbstractArray(i));
  }
  // Normals are omitted, because the feature has been rotated.
  for (const int role : { vtkDataSetAttributes::SCALARS, vtkDataSetAttributes::VECTORS,
         vtkDataSetAttributes::TCOORDS, vtkDataSetAttributes::TENSORS })
  {
    vtkAbstractArray* array = first->GetAbstractAttribute(role);
    if (array && array->GetName() && result->HasArray(array->GetName()))
    {
      result->SetActiveAttribute(array->GetName(), role);
    }
  }
}

/// Sets each tuple between two others to their mean, or to the first if there is no mean.
void FillMiddles(const Sources& sources, vtkDataSetAttributes* result)
{
  const auto first = static_cast<vtkIdType>(sources.First.size() + sources.Second.size());
  for (int i = 0; i < result->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = result->GetAbstractArray(i);
    auto* numbers = vtkShapeConvert::AreValues(array) ? vtkDataArray::SafeDownCast(array) : nullptr;
    for (std::size_t m = 0; m < sources.Midpoints.size(); ++m)
    {
      const auto [a, b] = sources.Midpoints[m];
      const vtkIdType at = first + static_cast<vtkIdType>(m);
      array->SetTuple(at, a, array);
      for (int k = 0; numbers && k < numbers->GetNumberOfComponents(); ++k)
      {
        numbers->SetComponent(
          at, k, 0.5 * (numbers->GetComponent(a, k) + numbers->GetComponent(b, k)));
      }
    }
  }
}

/// Returns the values of an array at the given points.
Eigen::MatrixXd ToMatrix(vtkDataArray* array, const std::vector<int>& points)
{
  Eigen::MatrixXd values(static_cast<Eigen::Index>(points.size()), array->GetNumberOfComponents());
  for (Eigen::Index row = 0; row < values.rows(); ++row)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      values(row, k) = array->GetComponent(points[row], k);
    }
  }
  return values;
}

/// Blends the arrays that both parts have, unless they identify something.
void Blend(const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature,
  const vtkShapePastedData::Part& target, const vtkShapePastedData::Part& featurePart, double width,
  vtkPointData* result)
{
  const Eigen::VectorXd& depths = feature.Deformation().Arrivals();
  const double reach = width * depths.maxCoeff();
  const std::vector<int>& loop = feature.Base().Loop;
  const Eigen::MatrixXd& points = feature.Surface().Points();
  const auto first = static_cast<vtkIdType>(pasted.TargetPoints.size());
  vtkPointData* targetData = target.Data->GetPointData();
  vtkPointData* featureData = featurePart.Data->GetPointData();
  for (int i = 0; i < targetData->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = targetData->GetArray(i);
    vtkDataArray* own =
      array && array->GetName() ? featureData->GetArray(array->GetName()) : nullptr;
    vtkDataArray* to = own ? result->GetArray(array->GetName()) : nullptr;
    if (!to || !AreAlike(array, own) || !vtkShapeConvert::AreValues(array))
    {
      continue;
    }
    // Colours are blended as numbers and rounded.
    const bool isColour = array->GetDataType() == VTK_UNSIGNED_CHAR;
    Eigen::MatrixXd values = ToMatrix(own, featurePart.Points);
    const Eigen::MatrixXd differences =
      shape::PullBack(pasted.Position.Cover.Positions, target.Triangles.Surface.Triangles,
        ToMatrix(array, target.Points)) -
      vtkShapeConvert::Rows(values, loop);
    values = shape::BlendAtSeam(
      values, points, differences, vtkShapeConvert::Rows(points, loop), depths, reach);
    for (Eigen::Index p = 0; p < values.rows(); ++p)
    {
      for (Eigen::Index k = 0; k < values.cols(); ++k)
      {
        to->SetComponent(first + p, static_cast<int>(k),
          isColour ? std::clamp(std::round(values(p, k)), 0.0, 255.0) : values(p, k));
      }
    }
  }
}

/// Returns the cell of the target for each triangle of the band: a cell at one of its corners.
std::vector<vtkIdType> CellsUnderBand(
  const shape::PastedFeature& pasted, const shape::NumberedSurface& target)
{
  const shape::CoveredRegion& cover = pasted.Position.Cover;
  const auto loop = cover.Loop.rows();
  std::map<int, int> around; // a covered triangle at each point of the ring
  for (const int triangle : cover.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      around.emplace(target.Surface.Triangles(triangle, k), triangle);
    }
  }
  std::vector<vtkIdType> cells;
  for (Eigen::Index t = 0; t < pasted.Position.Join.Triangles.rows(); ++t)
  {
    const int corner =
      pasted.Position.Join.Triangles.row(t).minCoeff(); // the indices of the loop are the lowest
    const int triangle =
      corner < loop ? cover.Positions.Triangles(corner) : around.at(cover.Ring[corner - loop]);
    cells.push_back(target.Cells(triangle));
  }
  return cells;
}

} // namespace

vtkShapePastedData::Part vtkShapePastedData::Read(
  vtkPolyData* data, const std::string& name, const shape::Progress& progress)
{
  Part part;
  part.Data = data;
  part.Triangles = vtkShapePreciseMap::ToSurface(data, name);
  shape::Mesh& surface = part.Triangles.Surface;
  shape::WeldedSurface welded(surface, progress, name);
  part.WeldedPoints = welded.WeldedPoints;
  part.Triangles.Cells = part.Triangles.Cells(welded.Triangles).eval();
  surface = std::move(welded.Surface);
  std::vector<int> number(surface.Points.rows(), -1);
  for (const int point : surface.Triangles.reshaped())
  {
    number[point] = 0;
  }
  for (int point = 0; point < static_cast<int>(number.size()); ++point)
  {
    if (number[point] == 0)
    {
      number[point] = static_cast<int>(part.Points.size());
      part.Points.push_back(point);
    }
  }
  surface.Points = surface.Points(part.Points, Eigen::all).eval();
  surface.Triangles = surface.Triangles.unaryExpr([&](int point) { return number[point]; }).eval();
  return part;
}

void vtkShapePastedData::Write(const shape::PastedFeature& pasted,
  const shape::FeatureToPaste& feature, const Part& target, const Part& featurePart,
  double blendWidth, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(pasted.Surface, output);
  Sources points{ {}, { featurePart.Points.begin(), featurePart.Points.end() }, pasted.Midpoints };
  for (const int point : pasted.TargetPoints)
  {
    points.First.push_back(target.Points[point]);
  }
  Merge(
    target.Data->GetPointData(), featurePart.Data->GetPointData(), points, output->GetPointData());
  Blend(pasted, feature, target, featurePart, blendWidth, output->GetPointData());
  FillMiddles(points, output->GetPointData());

  Sources cells;
  for (const int triangle : pasted.TargetTriangles)
  {
    cells.First.push_back(target.Triangles.Cells(triangle));
  }
  const std::vector<vtkIdType> band = CellsUnderBand(pasted, target.Triangles);
  cells.First.insert(cells.First.end(), band.begin(), band.end());
  for (const int triangle : pasted.FeatureTriangles)
  {
    cells.Second.push_back(featurePart.Triangles.Cells(triangle));
  }
  Merge(target.Data->GetCellData(), featurePart.Data->GetCellData(), cells, output->GetCellData());

  const auto kept = static_cast<Eigen::Index>(pasted.TargetTriangles.size());
  Eigen::VectorXi parts = Eigen::VectorXi::Constant(pasted.Surface.Triangles.rows(), 2);
  parts.head(kept).setZero();
  parts.segment(kept, pasted.BandTriangles).setOnes();
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(parts, "Part"));
}
