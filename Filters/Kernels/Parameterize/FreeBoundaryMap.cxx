#include "Parameterize/FreeBoundaryMap.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/BoundaryLoops.h"
#include "Parameterize/ConformalFlattening.h"
#include "Parameterize/ConvexCombination.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

std::string CountOf(const std::vector<int>& flipped, const Mesh& surface)
{
  return std::to_string(flipped.size()) + " of " + std::to_string(surface.Triangles.rows()) +
    " triangles (first triangle " + std::to_string(flipped[0]) + ")";
}

double ComputePlanarArea(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& image)
{
  Mesh flat{ Eigen::MatrixXd::Zero(image.rows(), 3), triangles };
  flat.Points.leftCols(2) = image;
  return ComputeArea(flat);
}

/// Computes Tutte's map with the longest loop on the unit circle.
Eigen::MatrixXd CircularMap(
  const Mesh& surface, const std::vector<std::vector<int>>& loops, const Progress& progress)
{
  const std::vector<int>& loop = loops.front();
  // The loop's points are mapped to equal angles. Like uniform weights, this ignores lengths.
  Eigen::MatrixXd positions(loop.size(), 2);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const double angle =
      2.0 * M_PI * static_cast<double>(i) / static_cast<double>(positions.rows());
    positions.row(i) << std::cos(angle), std::sin(angle);
  }
  const Mesh filled = FillWithFans(surface, { loops.begin() + 1, loops.end() });
  return SolveConvexCombination(filled, CombinationWeights::Uniform, loop, positions, progress)
    .topRows(surface.Points.rows());
}

/// Moves and rotates the image into the standard position that the header defines.
void Settle(const Eigen::MatrixXi& triangles, Eigen::MatrixXd& image)
{
  Mesh flat{ Eigen::MatrixXd::Zero(image.rows(), 3), triangles };
  flat.Points.leftCols(2) = image;
  const Eigen::VectorXd weights = ComputePointAreas(flat);
  image.rowwise() -= (weights.transpose() * image / weights.sum()).eval();
  // The axes of the second moments; x is the longer one.
  const Eigen::Matrix2d moments = image.transpose() * weights.asDiagonal() * image;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moments);
  constexpr double clear = 1e-6; // relative; smaller values are rounding error
  const double size = std::sqrt(solver.eigenvalues().sum() / weights.sum());
  Eigen::Index first = 0; // the first point off the centre
  while (first + 1 < image.rows() && image.row(first).norm() < 0.1 * size)
  {
    ++first;
  }
  Eigen::Vector2d axis = solver.eigenvectors().col(1);
  if (solver.eigenvalues()(1) - solver.eigenvalues()(0) < clear * solver.eigenvalues()(1))
  {
    axis = image.row(first).normalized();
  }
  const Eigen::ArrayXd along = (image * axis).array();
  // The third moment decides the direction of x.
  const double third = (weights.array() * along.cube()).sum() / weights.sum();
  const double sense =
    std::abs(third) > clear * size * size * size ? third : static_cast<double>(along(first));
  axis *= sense < 0.0 ? -1.0 : 1.0;
  Eigen::Matrix2d axes;
  axes << axis(0), -axis(1), axis(1), axis(0);
  image *= axes;
}

} // namespace

FreeBoundaryMapResult MapWithFreeBoundary(
  const Surface& surface, const FreeBoundaryMapOptions& options, const Progress& progress)
{
  progress(0.0);
  // Outline:
  // 1. The surface is scaled to area 1.
  // 2. The conformal map. It is the result if it flips no triangle and no refinement is requested.
  // 3. If it flips a triangle, refinement starts from Tutte's map, which flips none.
  // 4. The image is scaled to area 1 and refined.
  // 5. It is moved to the standard position, scaled back and checked.
  const double area = ComputeArea(surface);
  if (!(area > 0.0))
  {
    RequireSurfaceWithBoundary(surface, LoopCount::AtLeastOne);
    throw InvalidInput("the surface has no area; check the coordinates of its points");
  }
  // Step 1: area 1.
  Mesh unit = surface;
  unit.Points.rowwise() -= surface.Points().row(0);
  unit.Points /= std::sqrt(area);

  FreeBoundaryMapResult result;
  // Step 2: the conformal map. Refinement takes most of the time.
  const double conformal = options.Refine ? 0.2 : 0.8;
  Eigen::MatrixXd image =
    FlattenConformally(unit, progress.Part(0.0, conformal, "flattening conformally"));
  const std::vector<std::vector<int>> loops = FindManifoldBoundaryLoops(surface);
  for (std::size_t i = 0; i < loops.front().size(); ++i)
  {
    const int next = loops.front()[(i + 1) % loops.front().size()];
    result.LoopLength +=
      (surface.Points().row(next) - surface.Points().row(loops.front()[i])).norm();
  }
  std::vector<int> flipped = FindInvertedTriangles(surface.Triangles(), image);
  if (!flipped.empty() && !options.Refine)
  {
    throw SolveFailure("the conformal map flips " + CountOf(flipped, surface) +
      "; set Refine to SymmetricDirichlet");
  }
  if (!flipped.empty())
  {
    // Step 3: Tutte's map.
    result.IsConformal = false;
    image = CircularMap(unit, loops, progress.Part(0.2, 0.3));
    flipped = FindInvertedTriangles(surface.Triangles(), image);
    if (!flipped.empty())
    {
      throw SolveFailure("Tutte's map of the longest open loop to a circle leaves " +
        CountOf(flipped, surface) +
        " too small for double precision: an extremity shrinks exponentially with the ratio of its "
        "length to its girth; cut the surface open along its extremities, or cut them off with "
        "Shape Cut Feature");
    }
  }
  // Step 4: refinement.
  image /= std::sqrt(ComputePlanarArea(surface.Triangles(), image));
  if (options.Refine)
  {
    const InjectiveRefinementResult refined = RefineInjectively(
      unit, image, {}, options.Refinement, progress.Part(0.3, 1.0, "lowering the distortion"));
    image = refined.Points;
    result.Iterations = refined.Iterations;
    result.MeasureBefore = refined.StartEnergy;
    result.MeasureAfter = refined.Energy;
    if (options.Refinement.Measure == Distortion::ConformalAMIPS)
    {
      image /= std::sqrt(ComputePlanarArea(surface.Triangles(), image));
    }
  }
  // Step 5. Rounding in the rotation can flip a tiny triangle, so the check comes last.
  Settle(surface.Triangles(), image);
  flipped = FindInvertedTriangles(surface.Triangles(), image);
  if (!flipped.empty())
  {
    throw SolveFailure("rounding flips " + CountOf(flipped, surface) +
      ", which are too small for double precision; " +
      (options.Refine ? "cut the surface open along its extremities"
                      : "set Refine to SymmetricDirichlet"));
  }
  result.Points = Eigen::MatrixXd::Zero(image.rows(), 3);
  result.Points.leftCols(2) = std::sqrt(area) * image;
  progress(1.0);
  return result;
}

} // namespace shape
