#pragma once

#include "Base/Progress.h"
#include "Distortion/SimplexElements.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// The choices of a filter that refines its result: no refinement, or one of Distortion.
enum class RefineType
{
  None = 0,
  SymmetricDirichlet = 1,
  ExponentialSymmetricDirichlet = 2,
  AMIPS = 3,
  ConformalAMIPS = 4,
  Hencky = 5,
  ARAP = 6
};

/// Returns the measure of a choice other than None.
Distortion GetMeasure(RefineType refine);

struct InjectiveRefinementOptions
{
  Distortion Measure = Distortion::SymmetricDirichlet;
  double Exponent = 1.0;       ///< exponent e of the exponential measures; > 0
  double Scale = 1.0;          ///< factor by which a surface's lengths are multiplied; > 0
  int MaximumIterations = 300; ///< >= 0
  /// Stops when each of five successive iterations lowers the energy by at most this share;
  /// in [0, 1).
  double Tolerance = 1e-5;
};

struct InjectiveRefinementResult
{
  Eigen::MatrixXd Points; ///< n x 2 or n x 3
  /// Mean of the measure, weighted by size, at the start. For an exponential measure, this start is
  /// the result with SymmetricDirichlet.
  double StartEnergy = 0.0;
  double Energy = 0.0; ///< mean of the measure, weighted by size, at the end
  int Iterations = 0;  ///< number of linear systems solved
};

/// How points may move.
template <int Dimension>
struct PointMotion
{
  using Position = Eigen::Matrix<double, 1, Dimension>;
  /// for each point, the number of its directions: 0 if it is fixed, Dimension if it is free
  std::vector<int> Freedom;
  ///@{
  /// For points that are neither fixed nor free: the orthonormal directions (columns) at a
  /// position, and the permitted position nearest to another one.
  std::function<Eigen::Matrix<double, Dimension, Eigen::Dynamic>(int, const Position&)> Directions;
  std::function<Position(int, const Position&)> Nearest;
  ///@}
};

/**
 * Moves the points of simplices to lower the mean distortion, without inverting a simplex: scalable
 * locally injective mappings (Rabinovich, Poranne, Panozzo and Sorkine-Hornung 2017), in the plane
 * or in space. Each iteration replaces the measure by a weighted quadratic form with the same
 * gradient (section 3.2) and moves towards its minimum, at most 0.8 of the way to the first
 * inversion. The step is halved until the energy decreases (Armijo). All systems share one sparsity
 * pattern, whose elimination order is computed once. An exponential measure starts from the result
 * with SymmetricDirichlet.
 *
 * start: n x Dimension, with every simplex positive (exact predicates). Points without a simplex do
 * not move. Throws InvalidInput if an option is out of range. Throws SolveFailure if the measure at
 * the start exceeds the range of double. Throws Aborted; an abort takes effect after at most one
 * factorisation.
 */
template <int Dimension>
InjectiveRefinementResult RefineInjectively(const SimplexElements<Dimension>& elements,
  const Eigen::MatrixXd& start, const PointMotion<Dimension>& motion,
  const InjectiveRefinementOptions& options = {}, const Progress& progress = {});

/**
 * Lowers the distortion of the planar image of a surface. Boundary points that are not fixed move
 * too. So distant parts of the image may overlap, although no triangle is flipped.
 *
 * surface: every point is a corner of a triangle. start: n x 2, with every triangle
 * counter-clockwise. fixed: points that do not move; if there are none, the first point is fixed.
 * Throws InvalidInput if a triangle of the start is not counter-clockwise, and what the function
 * above throws.
 */
InjectiveRefinementResult RefineInjectively(const Mesh& surface, const Eigen::MatrixXd& start,
  const std::vector<int>& fixed = {}, const InjectiveRefinementOptions& options = {},
  const Progress& progress = {});

} // namespace shape
