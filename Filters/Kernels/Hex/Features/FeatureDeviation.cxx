#include "Hex/Features/FeatureDeviation.h"

#include "Mesh/QuadSurface.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Lines between points.
struct Segments
{
  const Eigen::MatrixXd& Points;
  std::vector<std::array<int, 2>> Ends;

  double Length(const std::array<int, 2>& ends) const
  {
    return (this->Points.row(ends[0]) - this->Points.row(ends[1])).norm();
  }

  /// As triangles without area.
  Mesh AsMesh() const
  {
    Mesh mesh{ this->Points, Eigen::MatrixXi(static_cast<Eigen::Index>(this->Ends.size()), 3) };
    for (Eigen::Index i = 0; i < mesh.Triangles.rows(); ++i)
    {
      mesh.Triangles.row(i) << this->Ends[i][0], this->Ends[i][1], this->Ends[i][1];
    }
    return mesh;
  }

  /// Their ends and places between, about as many altogether as asked for.
  Eigen::MatrixXd Positions(int count) const
  {
    double whole = 0.0;
    for (const std::array<int, 2>& ends : this->Ends)
    {
      whole += this->Length(ends);
    }
    std::vector<Eigen::RowVector3d> positions;
    for (const std::array<int, 2>& ends : this->Ends)
    {
      const int steps =
        1 + (whole > 0.0 ? static_cast<int>(std::floor(count * this->Length(ends) / whole)) : 0);
      for (int i = 0; i <= steps; ++i)
      {
        const double share = static_cast<double>(i) / steps;
        positions.emplace_back(
          (1.0 - share) * this->Points.row(ends[0]) + share * this->Points.row(ends[1]));
      }
    }
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(positions.size()), 3);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      rows.row(i) = positions[i];
    }
    return rows;
  }
};

Segments CurvesOf(const Mesh& surface, const SurfaceFeatures& features)
{
  Segments curves{ surface.Points, {} };
  for (const FeatureCurve& curve : features.Curves)
  {
    const std::size_t count = curve.Points.size();
    for (std::size_t i = 0; i + (curve.Closed ? 0 : 1) < count; ++i)
    {
      curves.Ends.push_back({ curve.Points[i], curve.Points[(i + 1) % count] });
    }
  }
  return curves;
}

Segments ChainsOf(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf)
{
  Segments chains{ points, {} };
  const QuadSurface boundary(quads);
  for (const auto& [edge, quad] : boundary.Edges())
  {
    if (edge.first < edge.second &&
      patchOf(quad) != patchOf(boundary.QuadAt({ edge.second, edge.first })))
    {
      chains.Ends.push_back({ edge.first, edge.second });
    }
  }
  return chains;
}

constexpr int ComparedAlong = 20000; // places along curves, and along chains

SampledDistances Compare(const Segments& curves, const Segments& chains,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads)
{
  if (curves.Ends.empty())
  {
    return {};
  }
  const SurfaceLocator near(
    chains.Ends.empty() ? Mesh{ points, SplitQuads(quads) } : chains.AsMesh());
  Eigen::MatrixXd positions = curves.Positions(ComparedAlong);
  ClosestPoints closest = near.Find(positions);
  return { std::move(positions), std::move(closest.Positions), std::move(closest.Distances) };
}

} // namespace

FeatureDeviation CompareCreases(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf)
{
  FeatureDeviation fit;
  const std::set<int> used(quads.data(), quads.data() + quads.size());
  for (const int corner : features.Corners)
  {
    const auto at = std::find_if(used.begin(), used.end(),
      [&](int point) { return points.row(point) == surface.Points.row(corner); });
    if (at != used.end())
    {
      fit.CornerPoints.push_back(*at);
    }
  }
  const Segments curves = CurvesOf(surface, features), chains = ChainsOf(points, quads, patchOf);
  if (curves.Ends.empty())
  {
    return fit;
  }
  fit.Distance = Compare(curves, chains, points, quads).Distances.maxCoeff();
  if (!chains.Ends.empty())
  {
    const SurfaceLocator along(curves.AsMesh());
    fit.Distance =
      std::max(fit.Distance, along.Find(chains.Positions(ComparedAlong)).Distances.maxCoeff());
  }
  return fit;
}

SampledDistances ComputeDistancesToCurves(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf)
{
  return Compare(CurvesOf(surface, features), ChainsOf(points, quads, patchOf), points, quads);
}

} // namespace shape
