#include "vtkShapeFeatureBase.h"

#include "vtkShapeCloud.h"
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
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace
{

const std::string Positions = "LoopCoordinates", Normals = "LoopNormal", Order = "LoopOrder",
                  Facts = "CutFeature.";

/// Returns the numbers of a base in the field data, if they exist.
std::optional<Eigen::RowVectorXd> Fact(
  vtkPolyData* data, const std::string& name, int base, int count)
{
  vtkDataArray* values = data->GetFieldData()->GetArray((Facts + name).c_str());
  if (!values || values->GetNumberOfComponents() != count || base < 0 ||
    base >= values->GetNumberOfTuples())
  {
    return {};
  }
  Eigen::RowVectorXd numbers(count);
  values->GetTuple(base, numbers.data());
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

/// Returns the number of the base at a loop, which is the third of its coordinates; -1 if the loop
/// was not cut.
int FindBase(
  const std::vector<int>& loop, const Eigen::MatrixXd& positions, const Eigen::MatrixXd& normals)
{
  return WasCut(loop, normals) ? static_cast<int>(std::lround(positions(loop.front(), 2))) : -1;
}

/// Returns the loops of the bases in the order in which they were cut: loops that cross gaps are no
/// boundary loops.
std::vector<std::vector<int>> OrderedLoops(vtkPolyData* data, const Eigen::MatrixXd& positions)
{
  const Eigen::VectorXd order = vtkShapeConvert::ToPointArray(data, Order, 1, "the Feature");
  std::map<std::pair<int, int>, int> points; // by base and order
  for (int point = 0; point < static_cast<int>(order.size()); ++point)
  {
    if (order(point) > 0.0)
    {
      points.insert({ { static_cast<int>(std::lround(positions(point, 2))),
                        static_cast<int>(std::lround(order(point))) },
        point });
    }
  }
  std::vector<std::vector<int>> loops;
  int last = -1;
  for (const auto& [place, point] : points)
  {
    if (loops.empty() || place.first != last)
    {
      loops.emplace_back();
    }
    loops.back().push_back(point);
    last = place.first;
  }
  return loops;
}

/// Returns the loops to join, the one at the seed first.
std::vector<std::vector<int>> ChooseLoops(vtkPolyData* data, const shape::Mesh& feature,
  const Eigen::MatrixXd& positions, const Eigen::MatrixXd& normals,
  const shape::JoinedLoops& joined)
{
  const int index = joined.LoopIndex;
  std::vector<std::vector<int>> loops;
  if (vtkShapeCloud::IsPointCloud(data))
  {
    loops.push_back(vtkShapeCloud::FindLoop(data));
    if (loops.front().empty())
    {
      throw shape::InvalidInput("the Feature is a point cloud without a loop: points alone have no "
                                "boundary along which they could be joined; cut it with Shape Cut "
                                "Feature, or add a closed polyline through its outer points");
    }
  }
  else if (normals.rows() > 0 && data->GetPointData()->HasArray(Order.c_str()))
  {
    loops = OrderedLoops(data, positions);
  }
  else
  {
    loops = shape::FindBoundaryLoops(feature).Loops;
  }
  const auto count = static_cast<int>(loops.size());
  if (count == 0)
  {
    throw shape::InvalidInput(
      "the Feature has no open loop; cut it from its surface with Shape Cut Feature");
  }
  if (index < 0 || index >= count)
  {
    throw shape::InvalidInput("Loop Index is " + std::to_string(index) + ", but the Feature has " +
      std::to_string(count) + " open loops; choose one of them, numbered from 0");
  }
  // By default, the first loop at which the feature was cut, even if another loop is longer.
  const auto baseOf = [&](int loop) { return FindBase(loops[loop], positions, normals); };
  int first = index;
  for (int loop = 0; index == 0 && loop < count; ++loop)
  {
    const int base = baseOf(loop);
    if (base >= 0 && (baseOf(first) < 0 || base < baseOf(first)))
    {
      first = loop;
    }
  }
  std::vector<std::vector<int>> chosen = { loops[first] };
  for (int loop = 0; joined.Loops == shape::JoinedLoops::LoopsType::All && loop < count; ++loop)
  {
    // Loops that were not cut are holes of the surface, and stay, unless the seed is at one.
    if (loop != first && (baseOf(loop) >= 0) == (baseOf(first) >= 0))
    {
      chosen.push_back(loops[loop]);
    }
  }
  return chosen;
}

} // namespace

void vtkShapeFeatureBase::Write(const std::vector<shape::FeatureFootprint>& all,
  const std::vector<int>& ids, bool crossesGaps, vtkPolyData* feature)
{
  if (all.empty())
  {
    return;
  }
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(ids.size()), 3);
  Eigen::MatrixXd normals = positions;
  Eigen::VectorXi order = Eigen::VectorXi::Zero(positions.rows());
  const auto bases = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd seeds(bases, 3), planes(bases, 3), axes(bases, 3), radii(bases, 1),
    refined(bases, 1);
  bool returns = true;
  for (Eigen::Index k = 0; k < bases; ++k)
  {
    const shape::FeatureFootprint& base = all[k];
    // Points are found by position, because points on a seam are duplicated, and all copies must
    // store the base.
    std::map<int, Eigen::Index> rows; // of the loop, by the position on the surface
    for (std::size_t i = 0; i < base.Loop.size(); ++i)
    {
      rows[ids[base.Loop[i]]] = static_cast<Eigen::Index>(i);
    }
    for (Eigen::Index point = 0; point < positions.rows(); ++point)
    {
      const auto row = rows.find(ids[point]);
      if (row != rows.end())
      {
        positions.row(point) << base.LoopPositions.row(row->second), static_cast<double>(k);
        normals.row(point) = base.Normals.row(row->second);
        order(point) = static_cast<int>(row->second) + 1;
      }
    }
    seeds.row(k) = base.Origin;
    planes.row(k) = base.Normal;
    axes.row(k) = base.XAxis;
    radii(k) = base.ConformalRadius;
    refined(k) = base.IsRefined ? 1.0 : 0.0;
    returns = returns && base.ReturnsInPlace;
  }
  feature->GetPointData()->AddArray(vtkShapeConvert::ToArray(positions, Positions));
  feature->GetPointData()->AddArray(vtkShapeConvert::ToArray(normals, Normals));
  if (crossesGaps)
  {
    feature->GetPointData()->AddArray(vtkShapeConvert::ToIntegers(order, Order));
  }
  const std::pair<const char*, const Eigen::MatrixXd&> facts[] = { { "Seed", seeds },
    { "SeedNormal", planes }, { "SeedDirection", axes }, { "ConformalRadius", radii },
    { "Refined", refined } };
  for (const auto& [fact, values] : facts)
  {
    feature->GetFieldData()->AddArray(vtkShapeConvert::ToArray(values, Facts + fact));
  }
  vtkShapeConvert::AddFact(feature, Facts + "ReturnsInPlace", returns ? 1.0 : 0.0);
}

vtkShapeFeatureBase::Feature vtkShapeFeatureBase::Read(vtkPolyData* data,
  const shape::Mesh& surface, const shape::JoinedLoops& joined, const shape::Progress& progress)
{
  const Eigen::MatrixXd positions = LoopArray(data, Positions);
  Eigen::MatrixXd normals = LoopArray(data, Normals);
  // A base is used only if it is complete.
  if (positions.rows() == 0 || !Fact(data, "SeedNormal", 0, 3) ||
    !Fact(data, "SeedDirection", 0, 3))
  {
    normals.resize(0, 3);
  }
  Feature feature{ {}, false };
  const std::vector<std::vector<int>> loops =
    ChooseLoops(data, surface, positions, normals, joined);
  for (const std::vector<int>& loop : loops)
  {
    const auto done = static_cast<double>(feature.Bases.size());
    const int base = FindBase(loop, positions, normals);
    const auto normal = Fact(data, "SeedNormal", base, 3);
    const auto axis = Fact(data, "SeedDirection", base, 3);
    if (!normal || !axis)
    {
      // The feature was not made by Shape Cut Feature, or its hole was not filled.
      const auto count = static_cast<double>(loops.size());
      feature.Bases.push_back(shape::BuildFootprintOnOwnFill(
        surface, loop, progress.Part(done / count, (done + 1.0) / count)));
      feature.HasOwnFill = true;
      continue;
    }
    const auto seed = Fact(data, "Seed", base, 3), radius = Fact(data, "ConformalRadius", base, 1),
               refined = Fact(data, "Refined", base, 1);
    feature.Bases.push_back({ loop, vtkShapeConvert::Rows(positions, loop).leftCols(2),
      vtkShapeConvert::Rows(normals, loop), *normal, *axis,
      // Features that earlier versions cut have one base, and its position is not needed.
      seed ? Eigen::RowVector3d(*seed) : Eigen::RowVector3d::Zero(), radius ? (*radius)(0) : 0.0,
      refined && (*refined)(0) != 0.0 });
  }
  return feature;
}
