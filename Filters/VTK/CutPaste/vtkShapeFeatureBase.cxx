#include "vtkShapeFeatureBase.h"

#include "vtkShapeConvert.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "CutPaste/FootprintLayout.h"
#include "Mesh/BoundaryLoops.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace
{

const std::string Positions = "LoopCoordinates", Normals = "LoopNormal", Facts = "CutFeature.";

/// Returns numbers of the field data, if they exist.
std::optional<Eigen::RowVectorXd> Fact(vtkPolyData* data, const std::string& name, int count)
{
  vtkDataArray* values = data->GetFieldData()->GetArray((Facts + name).c_str());
  if (!values || values->GetNumberOfValues() != count)
  {
    return {};
  }
  Eigen::RowVectorXd numbers(count);
  for (int k = 0; k < count; ++k)
  {
    numbers(k) = values->GetVariantValue(k).ToDouble();
  }
  return numbers;
}

/// Returns the array at the points of the feature, or an empty matrix if there is no such array.
Eigen::MatrixXd LoopArray(vtkPolyData* data, const std::string& name)
{
  return data->GetPointData()->HasArray(name.c_str())
    ? vtkShapeConvert::ToPointArray(data, name, 3, "the Feature")
    : Eigen::MatrixXd(0, 3);
}

/// Returns whether a loop was cut and filled at all of its points.
bool WasCut(const std::vector<int>& loop, const Eigen::MatrixXd& normals)
{
  return normals.rows() > 0 &&
    std::all_of(
      loop.begin(), loop.end(), [&](int point) { return normals.row(point).squaredNorm() > 0.0; });
}

std::vector<int> ChooseLoop(const shape::Mesh& feature, const Eigen::MatrixXd& normals, int index)
{
  const std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(feature).Loops;
  if (loops.empty())
  {
    throw shape::InvalidInput(
      "the Feature has no open loop; cut it from its surface with Shape Cut Feature");
  }
  if (index < 0 || index >= static_cast<int>(loops.size()))
  {
    throw shape::InvalidInput("Loop Index is " + std::to_string(index) + ", but the Feature has " +
      std::to_string(loops.size()) + " open loops; choose one of them, numbered from 0");
  }
  const auto wasCut = std::find_if(loops.begin(), loops.end(),
    [&](const std::vector<int>& loop) { return WasCut(loop, normals); });
  // By default, the loop at which the feature was cut, even if another loop is longer.
  return index == 0 && wasCut != loops.end() ? *wasCut : loops[index];
}

} // namespace

void vtkShapeFeatureBase::Write(const shape::CutFeatureResult& cut, vtkPolyData* feature)
{
  if (!cut.Base)
  {
    return;
  }
  const shape::FeatureFootprint& base = *cut.Base;
  // Points are found by position, because points on a seam are duplicated, and all copies must
  // store the base.
  std::map<int, Eigen::Index> rows; // of the loop, by the position on the surface
  for (std::size_t i = 0; i < base.Loop.size(); ++i)
  {
    rows[cut.Feature.Ids[base.Loop[i]]] = static_cast<Eigen::Index>(i);
  }
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(cut.Feature.Surface.Points.rows(), 3);
  Eigen::MatrixXd normals = positions;
  for (Eigen::Index point = 0; point < positions.rows(); ++point)
  {
    const auto row = rows.find(cut.Feature.Ids[point]);
    if (row != rows.end())
    {
      positions.row(point).head(2) = base.LoopPositions.row(row->second);
      normals.row(point) = base.Normals.row(row->second);
    }
  }
  feature->GetPointData()->AddArray(vtkShapeConvert::ToArray(positions, Positions));
  feature->GetPointData()->AddArray(vtkShapeConvert::ToArray(normals, Normals));
  const std::pair<const char*, Eigen::RowVector3d> facts[] = { { "Seed", cut.Seed },
    { "SeedNormal", base.Normal }, { "SeedDirection", base.XAxis } };
  for (const auto& [fact, value] : facts)
  {
    feature->GetFieldData()->AddArray(vtkShapeConvert::ToArray(value, Facts + fact));
  }
  vtkShapeConvert::AddFact(feature, Facts + "ConformalRadius", base.ConformalRadius);
  vtkShapeConvert::AddFact(feature, Facts + "Refined", base.IsRefined ? 1.0 : 0.0);
  vtkShapeConvert::AddFact(feature, Facts + "ReturnsInPlace", base.ReturnsInPlace ? 1.0 : 0.0);
}

vtkShapeFeatureBase::Feature vtkShapeFeatureBase::Read(
  vtkPolyData* data, const shape::Mesh& surface, int loopIndex, const shape::Progress& progress)
{
  const Eigen::MatrixXd positions = LoopArray(data, Positions);
  Eigen::MatrixXd normals = LoopArray(data, Normals);
  const auto normal = Fact(data, "SeedNormal", 3), axis = Fact(data, "SeedDirection", 3);
  // A base is used only if it is complete.
  if (positions.rows() == 0 || !normal || !axis)
  {
    normals.resize(0, 3);
  }
  const std::vector<int> loop = ChooseLoop(surface, normals, loopIndex);
  if (!WasCut(loop, normals))
  {
    // The feature was not made by Shape Cut Feature, or its hole was not filled.
    return { shape::BuildFootprintOnOwnFill(surface, loop, progress), true };
  }
  const auto radius = Fact(data, "ConformalRadius", 1), refined = Fact(data, "Refined", 1);
  return { { loop, vtkShapeConvert::Rows(positions, loop).leftCols(2),
             vtkShapeConvert::Rows(normals, loop), *normal, *axis, radius ? (*radius)(0) : 0.0,
             refined && (*refined)(0) != 0.0 },
    false };
}
