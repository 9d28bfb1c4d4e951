#include "Correspondence/Conformal/SphereCommonDomain.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/FitRotation.h"
#include "Laplacian/CotangentWeights.h"
#include "Mesh/HalfEdges.h"
#include "Parameterize/SphereMap.h"
#include "Parameterize/SphericalRelaxation.h"
#include "Parameterize/SphericalTriangles.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace shape
{
namespace
{

constexpr int Grain = 512; // directions
/// Of barycentric coordinates.
constexpr double Rounding = 1e-12;

void RequireLandmarks(
  const Mesh& surface, const std::vector<int>& landmarks, const std::string& name)
{
  for (const int point : landmarks)
  {
    if (point < 0 || point >= surface.Points.rows())
    {
      throw InvalidInput("a landmark of surface " + name + " is point " + std::to_string(point) +
        ", but the surface has " + std::to_string(surface.Points.rows()) +
        " points; number points from 0");
    }
  }
  if (std::set<int>(landmarks.begin(), landmarks.end()).size() < landmarks.size())
  {
    throw InvalidInput(
      "two landmarks of surface " + name + " are the same point; give distinct points");
  }
}

Eigen::MatrixXd OnSphere(const Surface& surface, const std::string& name, const Progress& progress)
{
  try
  {
    return MapToSphere(surface, {}, progress).Points;
  }
  catch (const InvalidInput& problem)
  {
    throw InvalidInput("Surface " + name + ": " + problem.what());
  }
  catch (const SolveFailure& problem)
  {
    throw SolveFailure("Surface " + name + ": " + problem.what());
  }
}

/// The minimum distance between two of them; 2 for one.
/// It is the width of the Gaussians: much wider ones make the matrix of the landmarks nearly
/// singular, much narrower ones concentrate the motion at the landmarks.
double Separation(const Eigen::MatrixXd& positions)
{
  double minimum = 2.0;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < i; ++j)
    {
      minimum = std::min(minimum, (positions.row(i) - positions.row(j)).norm());
    }
  }
  return minimum;
}

/// exp(-|p - q|^2 / (2 width^2)) between all p and q.
Eigen::MatrixXd Gaussians(const Eigen::MatrixXd& p, const Eigen::MatrixXd& q, double width)
{
  Eigen::MatrixXd values(p.rows(), q.rows());
  for (Eigen::Index j = 0; j < q.rows(); ++j)
  {
    values.col(j) =
      (-0.5 / (width * width) * (p.rowwise() - q.row(j)).rowwise().squaredNorm().array()).exp();
  }
  return values;
}

bool AllFaceOutwards(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  return FindFlippedTriangles(triangles, points).empty();
}

/// Moves the landmarks to their targets, and all other points with them, without a flip.
/// The rest of the way is divided into steps, and the field is computed anew for each: the
/// landmarks have moved, and so has the width of the Gaussians. A step that flips a triangle is
/// undone, the points are relaxed, and half the step is tried. After a success the step may double
/// again.
void Warp(const Mesh& surface, const std::vector<int>& landmarks, const Eigen::MatrixXd& goals,
  const SphereCommonDomainOptions& options, Eigen::MatrixXd& points, const Progress& progress)
{
  std::vector<char> isLandmark(points.rows(), 0);
  for (const int landmark : landmarks)
  {
    isLandmark[landmark] = 1;
  }
  std::vector<int> movable;
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    if (isLandmark[i] == 0)
    {
      movable.push_back(i);
    }
  }
  const Eigen::MatrixXd cotangents = ComputeTriangleAngles(surface).Cotangents;
  double rest = 1.0; // of the way
  double step = 1.0 / options.Steps;
  // Of the way: ten thousand such steps would be needed to arrive.
  constexpr double minimumStep = 1e-4;
  while (rest > 0.0)
  {
    progress(0.7 * (1.0 - rest));
    const Eigen::MatrixXd at = points(landmarks, Eigen::all);
    // 1 is the radius of the sphere. The lower limit keeps the exponent finite when two landmarks
    // nearly coincide.
    const double width = std::min(1.0, std::max(Separation(at), 1e-3));
    const Eigen::MatrixXd kernel = Gaussians(at, at, width);
    // Radial basis interpolation: the field takes every landmark to its target.
    const Eigen::MatrixXd weights = kernel.ldlt().solve(goals - at);
    const double share = std::min(1.0, step / rest);
    Eigen::MatrixXd trial = points + share * (Gaussians(points, at, width) * weights);
    trial.rowwise().normalize();
    if (share == 1.0)
    {
      trial(landmarks, Eigen::all) = goals; // but for rounding they are there
    }
    if (AllFaceOutwards(surface.Triangles, trial))
    {
      points = trial;
      rest = share == 1.0 ? 0.0 : rest - step;
      step = std::min(1.0 / options.Steps, 2.0 * step);
      continue;
    }
    step *= 0.5;
    if (step < minimumStep)
    {
      throw SolveFailure("on the unit sphere, landmarks of surface A remain up to " +
        std::to_string((goals - at).rowwise().norm().maxCoeff()) +
        " away from their partners, since moving them further would flip a triangle; check the "
        "order of the landmarks on both surfaces, or remove those closest together");
    }
    // Two sweeps move the points out of the way of the landmarks; complete relaxation is left to
    // the end.
    RelaxOnSphere(points, surface.Triangles, cotangents, movable, 2,
      progress.Part(0.7 * (1.0 - rest), 0.7 * (1.0 - rest)));
  }
  RelaxOnSphere(points, surface.Triangles, cotangents, movable, options.RelaxationSweeps,
    progress.Part(0.7, 1.0));
}

/// The barycentric coordinates of the position where a direction meets a triangle; one is negative
/// if the position is outside.
/// The determinant of the direction and two corners is proportional to the weight of the third.
Eigen::RowVector3d WeightsOf(const Eigen::Matrix3d& corners, const Eigen::RowVector3d& direction)
{
  Eigen::RowVector3d weights;
  for (int k = 0; k < 3; ++k)
  {
    weights(k) =
      ComputeSphericalDeterminant(direction, corners.row((k + 1) % 3), corners.row((k + 2) % 3));
  }
  return weights / weights.cwiseAbs().sum();
}

} // namespace

SurfacePoints LocateDirections(
  const Surface& sphere, const Eigen::MatrixXd& directions, const Progress& progress)
{
  const SurfaceLocator locator(sphere);
  const std::vector<int>& twins = sphere.Twins();
  const Mesh& mesh = sphere;
  SurfacePoints map{ Eigen::VectorXi(directions.rows()), Eigen::MatrixXd(directions.rows(), 3) };
  ParallelFor(
    static_cast<int>(directions.rows()), Grain,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const Eigen::RowVector3d direction = directions.row(i).normalized();
        // A walk from the closest triangle, across the edge that the direction is farthest beyond.
        // If it is cyclic, the best triangle met is the result.
        int triangle = locator.FindOne(direction).Triangle;
        double best = -std::numeric_limits<double>::infinity();
        // The closest triangle is nearly always the one hit or its neighbour; the limit only stops
        // cycles.
        for (int moves = 0; moves < 200; ++moves)
        {
          const Eigen::RowVector3d weights = WeightsOf(GetCorners(mesh, triangle), direction);
          int out = 0;
          // The edge opposite the corner with the most negative weight.
          const double minimum = weights.minCoeff(&out);
          if (minimum > best)
          {
            best = minimum;
            map.Triangles(i) = triangle;
            const Eigen::RowVector3d inside = (weights.array() < Rounding).select(0.0, weights);
            map.Barycentrics.row(i) = inside / inside.sum();
          }
          if (minimum >= -Rounding)
          {
            break;
          }
          triangle = twins[3 * triangle + (out + 1) % 3] / 3;
        }
      }
    },
    progress);
  return map;
}

// 1. Map both surfaces to the unit sphere.
// 2. Rotate A's sphere: its landmarks get as near to those of B as a rotation allows.
// 3. Warp A's sphere until the landmarks coincide, without a flip (Warp).
// 4. Each point goes to the point of the other surface in the same direction (LocateDirections).
SphereCommonDomainResult MapThroughSphere(const Surface& a, const std::vector<int>& landmarksA,
  const Surface& b, const std::vector<int>& landmarksB, const SphereCommonDomainOptions& options,
  const Progress& progress)
{
  RequireOption(options.Steps >= 1, "Steps", options.Steps, "at least 1");
  RequireOption(
    options.RelaxationSweeps >= 0, "RelaxationSweeps", options.RelaxationSweeps, "at least 0");
  if (landmarksA.empty() || landmarksA.size() != landmarksB.size())
  {
    throw InvalidInput("surface A has " + std::to_string(landmarksA.size()) +
      " landmarks, surface B " + std::to_string(landmarksB.size()) +
      "; give the same number for both, at least one");
  }
  if ((ComputeEnclosedVolume(a) < 0.0) != (ComputeEnclosedVolume(b) < 0.0))
  {
    throw InvalidInput("one of the surfaces faces inwards, the other outwards; reverse one with "
                       "Reverse Sense");
  }
  RequireLandmarks(a, landmarksA, "A");
  RequireLandmarks(b, landmarksB, "B");
  SphereCommonDomainResult result;
  result.SphereA = OnSphere(a, "A", progress.Part(0.0, 0.2, "mapping SurfaceA to the sphere"));
  result.SphereB = OnSphere(b, "B", progress.Part(0.2, 0.4, "mapping SurfaceB to the sphere"));
  const Eigen::MatrixXd goals = result.SphereB(landmarksB, Eigen::all);
  const Eigen::Matrix3d turn =
    FitRotation(goals.transpose() * result.SphereA(landmarksA, Eigen::all));
  result.SphereA = (result.SphereA * turn.transpose()).rowwise().normalized().eval();
  Warp(a, landmarksA, goals, options, result.SphereA,
    progress.Part(0.4, 0.8, "aligning the landmarks on the sphere"));

  result.AToB = LocateDirections({ result.SphereB, b.Triangles() }, result.SphereA,
    progress.Part(0.8, 0.9, "composing the maps"));
  result.BToA = LocateDirections({ result.SphereA, a.Triangles() }, result.SphereB,
    progress.Part(0.9, 1.0, "composing the maps"));
  return result;
}

} // namespace shape
