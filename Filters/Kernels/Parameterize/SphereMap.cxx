#include "Parameterize/SphereMap.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Surface.h"
#include "Parameterize/Private/MoebiusCentering.h"
#include "Parameterize/Private/SphereLike.h"
#include "Parameterize/Private/SphericalReinsertion.h"
#include "Parameterize/SphericalRelaxation.h"
#include "Parameterize/SphericalTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace shape
{
namespace
{

void Check(const Surface& surface, const SphereMapOptions& options)
{
  if (!(options.TimeStep > 0.0) || options.MaximumIterations < 1 || options.FreeIterations < 0 ||
    !(options.Tolerance >= 0.0 && options.Tolerance < 1.0) || !(options.LargestRepair >= 0.0) ||
    !(options.AreaWeight >= 0.0) || options.RelaxationSweeps < 0)
  {
    throw InvalidInput(
      "an option of the sphere map is out of range; the time step and the number "
      "of iterations must be positive, the tolerance must be less than 1, and no option may be "
      "negative");
  }
  RequireSphereLike(surface, "a sphere map");
}

/// Returns the surface scaled to area 1, with its centre at the origin.
Mesh Normalised(const Mesh& surface)
{
  const double size = ComputeLongestBoxEdge(surface.Points);
  Mesh mesh = surface;
  mesh.Points.rowwise() -= surface.Points.colwise().mean();
  mesh.Points /= size;
  const double area = ComputePointAreas(mesh).sum();
  if (!mesh.Points.allFinite() || !(area > 0.0))
  {
    throw InvalidInput(
      "the surface's area is zero in double precision (the longest edge of its box is " +
      FormatNumber(size) + "); scale the surface, or check its coordinates");
  }
  mesh.Points /= std::sqrt(area);
  return mesh;
}

/// The flow from `mesh` to the unit sphere.
class ConformalFlow
{
public:
  ConformalFlow(Mesh mesh, const Eigen::SparseMatrix<double>& stiffness)
    : Moving(std::move(mesh))
    , Stiffness(stiffness)
  {
  }

  void Step(double timeStep, const Progress& progress)
  {
    // Kazhdan et al. 2012, equation 9: (M_t + dt L_0) x = M_t x_t. Unlike in mean curvature flow,
    // the stiffness L_0 is that of the given surface. The flow shrinks the surface, so it is scaled
    // back to area 1.
    this->Recentre();
    const Eigen::VectorXd masses = ComputePointAreas(this->Moving);
    Eigen::SparseMatrix<double> system = timeStep * this->Stiffness;
    system.diagonal() += masses;
    this->Solver.Factorize(system, progress);
    this->Moving.Points = this->Solver.Solve(masses.asDiagonal() * this->Moving.Points);
    this->Recentre();
  }

  /// Returns the directions of the points from the origin; x for a point at the origin.
  Eigen::MatrixXd OnSphere() const
  {
    Eigen::MatrixXd sphere = this->Moving.Points;
    for (Eigen::Index i = 0; i < sphere.rows(); ++i)
    {
      const double length = sphere.row(i).norm();
      sphere.row(i) =
        length > 0.0 ? Eigen::RowVector3d(sphere.row(i) / length) : Eigen::RowVector3d::UnitX();
    }
    return sphere;
  }

  void Hold(const Eigen::MatrixXd& sphere) { this->Moving.Points = sphere; }

private:
  /// Scales to area 1 and moves the area-weighted mean to the origin.
  void Recentre()
  {
    Eigen::MatrixXd& points = this->Moving.Points;
    const Eigen::VectorXd masses = ComputePointAreas(this->Moving);
    const Eigen::RowVector3d mean = masses.transpose() * points / masses.sum();
    points.rowwise() -= mean;
    points /= std::sqrt(masses.sum());
    if (!points.allFinite())
    {
      throw SolveFailure("the flow to the sphere lost the surface's area; remesh its longest and "
                         "thinnest triangles");
    }
  }

  Mesh Moving;
  const Eigen::SparseMatrix<double>& Stiffness;
  SparseCholesky Solver;
};

/// Returns the mean of (s1 / s2 + s2 / s1) / 2 over the given surface, with s1 and s2 the map's
/// singular values: 1 if conformal. Each triangle, flipped or not, contributes at most 1000.
double MeanDistortion(const Mesh& mesh, const TriangleAngles& angles, const Eigen::MatrixXd& sphere)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = sphere.row(mesh.Triangles(t, 0));
    const Eigen::RowVector3d b = sphere.row(mesh.Triangles(t, 1));
    const Eigen::RowVector3d c = sphere.row(mesh.Triangles(t, 2));
    // With the triangle's area A: four times the Dirichlet energy, 2 A (s1^2 + s2^2), and four
    // times the image's area, 4 A s1 s2.
    const double energy = angles.Cotangents(t, 0) * (c - b).squaredNorm() +
      angles.Cotangents(t, 1) * (a - c).squaredNorm() +
      angles.Cotangents(t, 2) * (b - a).squaredNorm();
    const double area = 2.0 * (b - a).cross(c - a).norm();
    sum += angles.Areas(t) * (energy < 1000.0 * area ? energy / area : 1000.0);
  }
  return sum / angles.Areas.sum();
}

/// Returns the flow's most conformal image on the sphere. If the flow continues, the chords of a
/// coarse surface let the image contract to a few points.
Eigen::MatrixXd FlowToSphere(const Mesh& mesh, const TriangleAngles& angles,
  const Eigen::SparseMatrix<double>& stiffness, const SphereMapOptions& options, int& iterations,
  const Progress& progress)
{
  // After the first free steps the flow continues from the image on the sphere. It stops when three
  // steps in a row gain nothing.
  ConformalFlow flow(mesh, stiffness);
  Eigen::MatrixXd best;
  double minimum = std::numeric_limits<double>::infinity();
  int idle = 0;
  // The number of steps is unknown: 8 to 16 for most surfaces.
  const auto done = [](int steps) { return 1.0 - std::exp(-steps / 5.0); };
  for (; idle < 3 && iterations < options.MaximumIterations; ++iterations)
  {
    flow.Step(options.TimeStep, progress.Part(done(iterations), done(iterations + 1)));
    const Eigen::MatrixXd sphere = flow.OnSphere();
    const double distortion = MeanDistortion(mesh, angles, sphere);
    const bool held = iterations + 1 >= options.FreeIterations;
    // Smaller gains do not count: which step has the minimum would depend on rounding.
    const bool better = distortion < (1.0 - options.Tolerance) * minimum;
    idle = better || !held ? 0 : idle + 1;
    if (better)
    {
      minimum = distortion;
      best = sphere;
    }
    if (held)
    {
      flow.Hold(sphere);
    }
  }
  progress(1.0);
  return best;
}

/// Returns `points` and two rings of neighbours around them.
std::vector<int> Around(const Mesh& mesh, const std::vector<int>& points)
{
  std::vector<char> inside(mesh.Points.rows(), 0);
  for (const int i : points)
  {
    inside[i] = 1;
  }
  for (int ring = 0; ring < 2; ++ring)
  {
    const std::vector<char> before = inside;
    for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
    {
      const Eigen::RowVector3i corners = mesh.Triangles.row(t);
      if (before[corners(0)] || before[corners(1)] || before[corners(2)])
      {
        inside[corners(0)] = inside[corners(1)] = inside[corners(2)] = 1;
      }
    }
  }
  std::vector<int> list;
  for (int i = 0; i < static_cast<int>(inside.size()); ++i)
  {
    if (inside[i])
    {
      list.push_back(i);
    }
  }
  return list;
}

int CountFlips(const Mesh& mesh, const Eigen::MatrixXd& sphere)
{
  return static_cast<int>(FindFlippedTriangles(mesh.Triangles, sphere).size());
}

/// Share of the time of a method until its first image. Few images need repairs.
constexpr double Mapping = 0.9;

/// Runs one method completely, up to a centred map. Returns false if flipped triangles remain.
bool Attempt(const Mesh& mesh, SphereMapMethod method, const SphereMapOptions& options,
  SphereMapResult& result, const Progress& progress)
{
  // Outline:
  // 1. A first image on the sphere, by the flow or by global reinsertion.
  // 2. It is mirrored if it faces inwards.
  // 3. It is centred. If triangles are flipped, their points are reinserted and relaxed, and it is
  //    centred again.
  const int n = static_cast<int>(mesh.Points.rows());
  const TriangleAngles angles = ComputeTriangleAngles(mesh);
  result.Method = method;
  result.Iterations = 0;
  result.Reinserted = 0;
  // The number of points that may be reinserted. A conformal map with many flipped triangles is
  // not repaired: the next method is tried.
  int maximum = n;
  // Step 1: the first image.
  if (method == SphereMapMethod::GlobalReinsertion)
  {
    result.Points = ReinsertAll(
      mesh.Triangles, n, options.AreaWeight, progress.Part(0.0, Mapping, "mapping to the sphere"))
                      .Points;
  }
  else
  {
    Eigen::SparseMatrix<double> stiffness =
      BuildCotangentStiffness(mesh.Triangles, angles.Cotangents, n);
    if (method == SphereMapMethod::PositiveFlow)
    {
      stiffness = BuildPositiveStiffness(stiffness, 0.01);
    }
    else
    {
      maximum = std::max(16, static_cast<int>(options.LargestRepair * n));
    }
    result.Points = FlowToSphere(mesh, angles, stiffness, options, result.Iterations,
      progress.Part(0.0, Mapping, "mapping to the sphere"));
    // Step 2: orientation.
    if (ComputeSolidAngles(mesh.Triangles, result.Points).sum() < 0.0)
    {
      result.Points = -result.Points;
    }
  }
  // Step 3. Centring may flip a triangle again: it preserves circles, but not straight edges.
  const Eigen::VectorXd areas = ComputePointAreas(mesh);
  const int rounds = 8;
  for (int round = 0; round < rounds; ++round)
  {
    const double repairing = (1.0 - Mapping) / rounds;
    const Progress part =
      progress.Part(Mapping + round * repairing, Mapping + (round + 1) * repairing);
    const MoebiusCenteringResult centred =
      CenterOnSphere(result.Points, areas, {}, part.Part(0.0, 0.1));
    result.Points = centred.Points;
    result.MeanLength = centred.MeanLength;
    const int flips = CountFlips(mesh, result.Points);
    if (round == 0 && method == options.First)
    {
      result.FlipsBeforeRelaxation = flips;
    }
    if (flips == 0)
    {
      return ComputeCoveringDegree(mesh.Triangles, result.Points) == 1;
    }
    const SphericalReinsertionResult repaired = ReinsertFlipped(
      mesh.Triangles, result.Points, maximum, part.Part(0.1, 0.7, "repairing inverted triangles"));
    if (!repaired.Reached)
    {
      return false;
    }
    result.Points = repaired.Points;
    result.Reinserted += static_cast<int>(repaired.Reinserted.size());
    RelaxOnSphere(result.Points, mesh.Triangles, angles.Cotangents,
      Around(mesh, repaired.Reinserted), options.RelaxationSweeps,
      part.Part(0.7, 1.0, "relaxing the triangles"));
  }
  return false;
}

} // namespace

SphereMapResult MapToSphere(
  const Surface& surface, const SphereMapOptions& options, const Progress& progress)
{
  Check(surface, options);
  const Mesh mesh = Normalised(surface);
  SphereMapResult result;
  std::string failure;
  // The checks compute the surface's topology. The first method succeeds for most surfaces.
  double begin = 0.18, end = 0.92;
  progress(begin);
  for (const SphereMapMethod method : { SphereMapMethod::ConformalFlow,
         SphereMapMethod::PositiveFlow, SphereMapMethod::GlobalReinsertion })
  {
    if (method < options.First)
    {
      continue;
    }
    try
    {
      if (Attempt(mesh, method, options, result, progress.Part(begin, end)))
      {
        result.SmallestArea = ComputeSolidAngles(mesh.Triangles, result.Points).minCoeff();
        progress(1.0);
        return result;
      }
      const std::vector<int> flipped = FindFlippedTriangles(mesh.Triangles, result.Points);
      failure = flipped.empty() ? "the image does not cover the sphere exactly once"
                                : std::to_string(flipped.size()) +
          " triangles stay flipped on the sphere (first triangle " + std::to_string(flipped[0]) +
          ")";
      failure += "; remesh the surface's longest and thinnest parts";
    }
    catch (const SolveFailure& error)
    {
      failure = error.what();
    }
    begin = std::exchange(end, 0.5 * (1.0 + end));
  }
  throw SolveFailure(failure);
}

} // namespace shape
