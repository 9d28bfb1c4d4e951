#include "vtkShapeFeatures.h"

#include "vtkShapeConvert.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Geometry/FeatureCurves.h"
#include "Mesh/Topology.h"

#include <algorithm>

namespace
{

/// The ids of the points of a curve.
using Path = std::vector<int>;

std::vector<Path> Paths(vtkPolyData* data)
{
  std::vector<Path> paths;
  bool open = false; // whether the last curve consists of lines of two points
  for (const Path& path : vtkShapeConvert::ToLines(data))
  {
    // Many readers and filters write a polyline as separate segments; consecutive ones are joined.
    if (open && path.size() == 2 && paths.back().back() == path.front())
    {
      paths.back().push_back(path.back());
      continue;
    }
    open = path.size() == 2;
    paths.push_back(path);
  }
  return paths;
}

std::vector<shape::Curve> Curves(vtkPolyData* data, const std::vector<Path>& paths)
{
  const Eigen::MatrixXd points = vtkShapeConvert::ToPoints(data);
  std::vector<shape::Curve> curves;
  for (const Path& path : paths)
  {
    curves.push_back(vtkShapeConvert::Rows(points, path));
  }
  return curves;
}

Eigen::VectorXd Weights(vtkPolyData* feature, double defaultWeight, const std::string& name)
{
  if (!feature->GetPointData()->HasArray("Weight"))
  {
    return Eigen::VectorXd::Constant(feature->GetNumberOfPoints(), defaultWeight);
  }
  const Eigen::VectorXd weights = vtkShapeConvert::ToPointArray(feature, "Weight", 1, name);
  shape::RequireFinite(weights, "the Weight of " + name);
  Eigen::Index first = 0;
  if (!(weights.minCoeff(&first) > 0.0))
  {
    throw shape::InvalidInput(name + " has a Weight that is not greater than 0 (first at point " +
      std::to_string(first) + "); remove that point or set a positive weight");
  }
  return weights;
}

shape::VolumeFeatures ByArcLength(vtkPolyData* feature, vtkPolyData* target, double longestStep,
  const Eigen::VectorXd& weights, const std::string& name)
{
  const std::vector<Path> paths = Paths(feature);
  const shape::MatchedCurves matched =
    shape::MatchCurves(Curves(feature, paths), Curves(target, Paths(target)), longestStep, name);
  shape::VolumeFeatures result{ matched.Points, matched.Targets, matched.Positions };
  for (Eigen::Index i = 0; i < result.Weights.size(); ++i)
  {
    const Path& path = paths[matched.Curves(i)];
    const auto before = static_cast<std::size_t>(matched.Positions(i));
    const double t = matched.Positions(i) - static_cast<double>(before);
    const std::size_t after = std::min(before + 1, path.size() - 1);
    result.Weights(i) = (1.0 - t) * weights(path[before]) + t * weights(path[after]);
  }
  return result;
}

shape::VolumeFeatures ByOrder(vtkPolyData* feature, vtkPolyData* target,
  const Eigen::VectorXd& weights, const std::string& name)
{
  if (feature->GetNumberOfPoints() != target->GetNumberOfPoints())
  {
    throw shape::InvalidInput(name + " has " + std::to_string(feature->GetNumberOfPoints()) +
      " points, but its target has " + std::to_string(target->GetNumberOfPoints()) +
      " points; points are paired by their order, so use equally many, or use curves, or add the "
      "map array");
  }
  return { vtkShapeConvert::ToPoints(feature), vtkShapeConvert::ToPoints(target), weights };
}

void Append(shape::VolumeFeatures& all, const shape::VolumeFeatures& part)
{
  const Eigen::Index count = part.Points.rows(), total = all.Points.rows() + count;
  all.Points.conservativeResize(total, 3);
  all.Targets.conservativeResize(total, 3);
  all.Weights.conservativeResize(total);
  all.Points.bottomRows(count) = part.Points;
  all.Targets.bottomRows(count) = part.Targets;
  all.Weights.tail(count) = part.Weights;
}

} // namespace

shape::VolumeFeatures vtkShapeFeatures::Read(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray, double defaultWeight,
  double longestStep)
{
  shape::VolumeFeatures all;
  std::size_t used = 0;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    vtkPolyData* feature = features[i];
    const std::string name = "feature " + std::to_string(i);
    const bool carries = feature->GetPointData()->HasArray(mapArray.c_str());
    if (!carries && used == targets.size())
    {
      throw shape::InvalidInput(name + " has no point array '" + mapArray +
        "', and no TargetFeatures are left to pair with it (" + std::to_string(targets.size()) +
        " connected); add the array, or connect its target");
    }
    const Eigen::VectorXd weights = Weights(feature, defaultWeight, name);
    shape::VolumeFeatures part;
    if (carries)
    {
      part = { vtkShapeConvert::ToPoints(feature),
        vtkShapeConvert::ToPointArray(feature, mapArray, 3, name), weights };
    }
    else if (feature->GetNumberOfLines() > 0)
    {
      part = ByArcLength(feature, targets[used++], longestStep, weights, name);
    }
    else
    {
      part = ByOrder(feature, targets[used++], weights, name);
    }
    shape::RequireFinite(part.Points, name);
    shape::RequireFinite(part.Targets, "the map of " + name);
    Append(all, part);
  }
  if (used < targets.size())
  {
    throw shape::InvalidInput("there are " + std::to_string(targets.size()) +
      " TargetFeatures, but only " + std::to_string(used) +
      " Features without a map array; disconnect the other targets, or connect their Features");
  }
  return all;
}

/// Surfaces are fitted exactly, as boundaries of regions. Points and curves are still fitted in the
/// least-squares sense.
vtkShapeFeatures::Split vtkShapeFeatures::TakeSurfaces(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray)
{
  Split split;
  std::size_t used = 0;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    vtkPolyData* feature = features[i];
    const std::string name = "feature " + std::to_string(i);
    const bool carries = feature->GetPointData()->HasArray(mapArray.c_str());
    vtkPolyData* target = !carries && used < targets.size() ? targets[used++] : nullptr;
    if (feature->GetNumberOfPolys() + feature->GetNumberOfStrips() == 0)
    {
      if (!feature->GetPointData()->HasArray("Weight"))
      {
        throw shape::InvalidInput(name +
          " is not a surface, so Exact cannot fit its image exactly (by the maximum principle of "
          "harmonic maps); add a point array 'Weight' to fit the image in the least-squares sense, "
          "or turn Exact off");
      }
      split.Features.push_back(feature);
      if (target)
      {
        split.Targets.push_back(target);
      }
      continue;
    }
    const shape::Mesh mesh = vtkShapeConvert::ToMesh(feature, name);
    if (!carries && !target)
    {
      throw shape::InvalidInput(name + " has no point array '" + mapArray +
        "', and no TargetFeatures are left to pair with it (" + std::to_string(targets.size()) +
        " connected); add the array, or connect its target");
    }
    const Eigen::MatrixXd images = carries
      ? vtkShapeConvert::ToPointArray(feature, mapArray, 3, name)
      : ByOrder(feature, target, {}, name).Targets;
    split.Surfaces.push_back({ mesh, images, name });
  }
  split.Targets.insert(split.Targets.end(), targets.begin() + used, targets.end());
  return split;
}
