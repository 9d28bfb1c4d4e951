#include "Harmonic/Private/ScaledBoundary.h"

#include "Base/Errors.h"
#include "Fmm/FmmLatticeOrder.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Solids/Nesting.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

/// The points that triangles use, in an order that depends on their coordinates alone and puts
/// neighbours side by side: searches and sums run through memory that is at hand.
std::vector<int> UsedPointsByPosition(const Mesh& boundary, const Topology& topology)
{
  std::vector<int> used;
  for (int i = 0; i < boundary.Points.rows(); ++i)
  {
    if (topology.ComponentId(i) >= 0)
    {
      used.push_back(i);
    }
  }
  const auto position = [&](int i)
  {
    return std::array<double, 3>{ boundary.Points(i, 0), boundary.Points(i, 1),
      boundary.Points(i, 2) };
  };
  std::stable_sort(
    used.begin(), used.end(), [&](int a, int b) { return position(a) < position(b); });
  const Eigen::MatrixXd places = boundary.Points(used, Eigen::all);
  const FmmLatticeOrder order =
    OrderOnLattice(places, { places.colwise().minCoeff(), ComputeLongestBoxEdge(places) });
  std::vector<int> ordered;
  ordered.reserve(used.size());
  for (const int k : order.Ids)
  {
    ordered.push_back(used[k]);
  }
  return ordered;
}

/// The triangles, each from its lowest corner, in ascending order.
Eigen::MatrixXi Sorted(const Eigen::MatrixXi& triangles)
{
  std::vector<std::array<int, 3>> rows(triangles.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    rows[t] = { triangles(t, 0), triangles(t, 1), triangles(t, 2) };
    std::rotate(rows[t].begin(), std::min_element(rows[t].begin(), rows[t].end()), rows[t].end());
  }
  std::sort(rows.begin(), rows.end());
  Eigen::MatrixXi sorted(triangles.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    sorted.row(t) << rows[t][0], rows[t][1], rows[t][2];
  }
  return sorted;
}

/// Throws InvalidInput unless one component alone faces outwards: the others bound voids.
void RequireOneSolid(const Mesh& oriented)
{
  const Topology topology = ComputeTopology(oriented);
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(topology.Components);
  for (Eigen::Index t = 0; t < oriented.Triangles.rows(); ++t)
  {
    volumes(topology.ComponentId(oriented.Triangles(t, 0))) +=
      GetCorners(oriented, t).determinant();
  }
  const auto solids = (volumes.array() > 0.0).count();
  if (solids != 1)
  {
    throw InvalidInput("the boundary bounds " + std::to_string(solids) +
      " solids that do not touch; map each by itself (Connectivity separates them)");
  }
}

} // namespace

void RequireSupportedFeatures(
  const VolumeFeatures& features, const HarmonicVolumeMapOptions& options)
{
  const auto positive = [](double value, const char* name)
  {
    if (!(value > 0.0) || !std::isfinite(value))
    {
      throw InvalidInput(std::string(name) + " must be a finite number greater than 0");
    }
  };
  positive(options.FeatureWeight, "FeatureWeight");
  positive(options.MostRefined, "MostRefined");
  positive(options.CollocationRatio, "CollocationRatio");
  positive(options.SourceRatio, "SourceRatio");
  positive(options.SingularValueThreshold, "SingularValueThreshold");
  positive(options.MaximumMemory, "MaximumMemory");
  positive(options.MaximumLevels, "MaximumLevels");
  positive(options.SourceSubsets, "SourceSubsets");
  const auto notNegative = [](double value, const char* name)
  {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw InvalidInput(std::string(name) + " must be a finite number not less than 0");
    }
  };
  notNegative(options.Tolerance, "Tolerance");
  notNegative(options.OffsetDistance, "OffsetDistance");
  notNegative(options.LeastGain, "LeastGain");
  const Eigen::Index count = features.Points.rows();
  if (features.Targets.rows() != count || features.Points.cols() != 3 ||
    features.Targets.cols() != 3 ||
    (features.Weights.size() != 0 && features.Weights.size() != count))
  {
    throw InvalidInput("there are " + std::to_string(count) + " features, " +
      std::to_string(features.Targets.rows()) + " images and " +
      std::to_string(features.Weights.size()) + " weights; give one of each for a feature");
  }
  RequireFinite(features.Points, "the list of feature positions");
  RequireFinite(features.Targets, "the list of feature images");
  RequireFinite(features.Weights, "the list of feature weights");
  if (features.Weights.size() != 0 && features.Weights.minCoeff() <= 0.0)
  {
    Eigen::Index first = 0;
    const int bad = static_cast<int>((features.Weights.array() <= 0.0).count());
    (features.Weights.array() <= 0.0).maxCoeff(&first);
    throw InvalidInput(std::to_string(bad) +
      " feature points have a weight that is not greater than 0 (first at feature point " +
      std::to_string(first) + "); leave them out or give them positive weights");
  }
}

ScaledBoundary ScaleBoundary(const Mesh& boundary, const Eigen::MatrixXd& targets)
{
  const Topology topology = RequireClosedSurface(boundary, "the boundary");
  if (targets.rows() != boundary.Points.rows() || targets.cols() != 3)
  {
    throw InvalidInput("the boundary has " + std::to_string(boundary.Points.rows()) +
      " points and its map " + std::to_string(targets.rows()) + " rows of " +
      std::to_string(targets.cols()) + " numbers; give each point three coordinates");
  }
  RequireFinite(targets, "the boundary map");

  const std::vector<int> used = UsedPointsByPosition(boundary, topology);
  std::vector<int> newId(boundary.Points.rows(), -1);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    newId[used[i]] = static_cast<int>(i);
  }
  ScaledBoundary scaled;
  Mesh& surface = scaled.Surface;
  surface.Points = boundary.Points(used, Eigen::all);
  surface.Triangles = boundary.Triangles.unaryExpr([&](int i) { return newId[i]; });
  scaled.Origin = surface.Points.colwise().minCoeff();
  scaled.Size = ComputeLongestBoxEdge(surface.Points);
  surface.Points = (surface.Points.rowwise() - scaled.Origin) / scaled.Size;
  surface = OrientByNesting(surface, "the boundary");
  surface.Triangles = Sorted(surface.Triangles);
  RequireOneSolid(surface);
  if (!(ComputeEnclosedVolume(surface) > 1e-12))
  {
    throw InvalidInput("the boundary encloses no volume; give the surface of a solid");
  }
  scaled.Targets = targets(used, Eigen::all);
  scaled.TargetOrigin = scaled.Targets.colwise().minCoeff();
  const double targetSize = ComputeLongestBoxEdge(scaled.Targets);
  scaled.TargetSize = targetSize > 0.0 ? targetSize : 1.0;
  scaled.Targets = (scaled.Targets.rowwise() - scaled.TargetOrigin) / scaled.TargetSize;
  return scaled;
}

} // namespace shape
