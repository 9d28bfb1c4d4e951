#include "Harmonic/MeshMotion.h"

#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/ScaledBoundary.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

using MethodType = MeshMotionOptions::MethodType;

/// The boundary as a surface of its own, sorted by position: the result does not depend on the
/// numbering, or on pieces.
struct MeshBoundary
{
  std::vector<int> Points; ///< for each of its points, the one of the mesh
  shape::Surface Surface;
};

MeshBoundary TakeBoundary(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles)
{
  SortedSurface sorted = SortByPosition({ points, triangles });
  return { std::move(sorted.Points), Surface(std::move(sorted.Surface)) };
}

/// A displacement that is known everywhere.
struct Field
{
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&, const Progress&)> Evaluate;
  int Centres = 0;
};

RadialBasisOptions GetRadialOptions(const MeshMotionOptions& options)
{
  return { options.Kernel, options.SupportRadius, options.Tolerance, options.MaximumCentres };
}

Field FitField(const MeshBoundary& boundary, const Eigen::MatrixXd& displacements,
  const MeshMotionOptions& options, const Progress& progress)
{
  if (options.Method == MethodType::RadialBasis)
  {
    RadialBasisField field =
      FitRadialBasis(boundary.Surface.Points(), displacements, GetRadialOptions(options), progress);
    const auto centres = static_cast<int>(field.Centres.rows());
    return { [field = std::move(field)](const Eigen::MatrixXd& points, const Progress& part)
      { return Evaluate(field, points, part); },
      centres };
  }
  HarmonicVolumeMapOptions harmonic;
  harmonic.Tolerance = options.Tolerance;
  HarmonicVolumeMapResult result =
    ComputeHarmonicVolumeMap(boundary.Surface, displacements, {}, harmonic, progress);
  const auto charges = static_cast<int>(result.Map.Points.rows());
  const double error = 1e-2 * options.Tolerance;
  return { [map = std::move(result.Map), error](const Eigen::MatrixXd& points, const Progress& part)
    { return Evaluate(map, points, part, std::clamp(error, 1e-10, 1e-6)); },
    charges };
}

/// Returns what is added to the displacement at `points`: the error `left` at the closest position
/// of the boundary, less with the distance.
Eigen::MatrixXd CarryError(const MeshBoundary& boundary, const Eigen::MatrixXd& left,
  const Eigen::MatrixXd& points, const Progress& progress)
{
  constexpr double reach = 4.0; // spacings of the boundary's points
  const Eigen::VectorXd spacings = ComputePointAreas(boundary.Surface).cwiseSqrt();
  const ClosestPoints closest = SurfaceLocator(boundary.Surface).Find(points, progress);
  const Eigen::MatrixXi& triangles = boundary.Surface.Triangles();
  Eigen::MatrixXd carried = PullBack(closest, triangles, left);
  const Eigen::VectorXd reaches = reach * PullBack(closest, triangles, spacings);
  for (Eigen::Index i = 0; i < carried.rows(); ++i)
  {
    const double u = closest.Distances(i) / reaches(i);
    carried.row(i) *= u < 1.0 ? (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u) : 0.0;
  }
  return carried;
}

} // namespace

MeshMotionResult MoveMesh(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& displacements, const MeshMotionOptions& options, const Progress& progress)
{
  // Outline:
  // 1. The displacement is fitted at the boundary.
  // 2. It is evaluated at all points.
  // 3. The error of the fit at the boundary is carried to the points around it.
  RequireValid(GetRadialOptions(options));
  if (displacements.rows() != points.rows() || displacements.cols() != 3)
  {
    throw InvalidInput("the mesh has " + std::to_string(points.rows()) + " points and " +
      std::to_string(displacements.rows()) + " displacements; give each point one");
  }
  RequireFinite(points, "the mesh");
  RequireFinite(displacements, "the displacement of the boundary");
  const MeshBoundary boundary = TakeBoundary(points, triangles);
  const Eigen::MatrixXd given = displacements(boundary.Points, Eigen::all);
  const double largest = given.rowwise().norm().maxCoeff();
  MeshMotionResult result;
  // Step 1.
  const Field field =
    FitField(boundary, given, options, progress.Part(0.0, 0.6, "fitting the displacement"));
  result.Centres = field.Centres;
  // Step 2.
  const Eigen::MatrixXd fitted =
    field.Evaluate(points, progress.Part(0.6, 0.85, "moving the points"));
  // Step 3. An error of rounding is not carried, so that affine maps need no search.
  constexpr double rounding = 1e-12;
  const Eigen::MatrixXd left = given - fitted(boundary.Points, Eigen::all);
  result.BoundaryError = largest > 0.0 ? left.rowwise().norm().maxCoeff() / largest : 0.0;
  result.Points = points + fitted;
  if (result.BoundaryError > rounding)
  {
    result.Points += CarryError(
      boundary, left, points, progress.Part(0.85, 1.0, "correcting the points near the boundary"));
  }
  result.Points(boundary.Points, Eigen::all) = boundary.Surface.Points() + given;
  progress(1.0);
  return result;
}

BoundaryMotion FindBoundaryMotion(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Surface& surface, const Eigen::MatrixXd& images, double tolerance, const Progress& progress)
{
  RequireOption(tolerance >= 0.0 && std::isfinite(tolerance), "MatchTolerance", tolerance,
    "at least 0 and finite");
  const MeshBoundary boundary = TakeBoundary(points, triangles);
  const double within = tolerance * ComputeLongestBoxEdge(points);
  const ClosestPoints closest =
    SurfaceLocator(surface).Find(boundary.Surface.Points(), progress.Part(0.0, 0.5));
  const Eigen::MatrixXd moved =
    PullBack(closest, surface.Triangles(), Eigen::MatrixXd(images - surface.Points()));
  BoundaryMotion motion;
  motion.Displacements = Eigen::MatrixXd::Zero(points.rows(), 3);
  for (std::size_t i = 0; i < boundary.Points.size(); ++i)
  {
    if (closest.Distances(static_cast<Eigen::Index>(i)) <= within)
    {
      motion.Displacements.row(boundary.Points[i]) = moved.row(static_cast<Eigen::Index>(i));
      ++motion.Moving;
    }
    else
    {
      ++motion.Fixed;
    }
  }
  if (motion.Moving == 0)
  {
    throw InvalidInput("no boundary point of the mesh lies on the Boundary: the nearest is at a "
                       "distance of " +
      std::to_string(closest.Distances.minCoeff()) +
      "; use the surface that the mesh was made from, or raise Match Tolerance");
  }
  const std::vector<int> used = FindUsedPoints(surface.Triangles(), surface.Points().rows());
  const ClosestPoints back = SurfaceLocator(boundary.Surface)
                               .Find(surface.Points()(used, Eigen::all), progress.Part(0.5, 1.0));
  motion.Unmatched = static_cast<int>((back.Distances.array() > within).count());
  return motion;
}

} // namespace shape
