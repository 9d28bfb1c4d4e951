#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Parameterize/PlanarDistortion.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct InjectiveRefinementOptions
{
  Distortion Measure = Distortion::SymmetricDirichlet;
  double Exponent = 1.0;       ///< exponent e of the exponential measures; > 0
  double Scale = 1.0;          ///< factor by which the surface's lengths are multiplied; > 0
  int MaximumIterations = 300; ///< >= 0
  /// Stops when each of five successive iterations lowers the energy by at most this share;
  /// in [0, 1).
  double Tolerance = 1e-5;
};

struct InjectiveRefinementResult
{
  Eigen::MatrixXd Points; ///< n x 2
  /// Area-weighted mean of the measure at the start. For an exponential measure, this start is the
  /// result with SymmetricDirichlet.
  double StartEnergy = 0.0;
  double Energy = 0.0; ///< area-weighted mean of the measure at the end
  int Iterations = 0;  ///< number of linear systems solved
};

/**
 * Moves the points of a planar image of a surface to lower the mean distortion, without flipping a
 * triangle: scalable locally injective mappings (Rabinovich, Poranne, Panozzo and Sorkine-Hornung
 * 2017). Each iteration replaces the measure by a weighted quadratic form with the same gradient
 * (section 3.2) and moves towards its minimum, at most 0.8 of the way to the first flip. The step
 * is halved until the energy decreases (Armijo). All systems share one sparsity pattern, whose
 * elimination order is computed once.
 *
 * Boundary points that are not fixed move too. So distant parts of the image may overlap, although
 * no triangle is flipped. An exponential measure starts from the result with SymmetricDirichlet.
 *
 * surface: every point is a corner of a triangle. start: n x 2, with every triangle
 * counter-clockwise. fixed: points that do not move. Throws InvalidInput if an option is out of
 * range or a triangle of the start is not counter-clockwise. Throws SolveFailure if the measure at
 * the start exceeds the range of double. Throws Aborted; an abort takes effect after at most one
 * factorisation.
 */
InjectiveRefinementResult RefineInjectively(const Mesh& surface, const Eigen::MatrixXd& start,
  const std::vector<int>& fixed = {}, const InjectiveRefinementOptions& options = {},
  const Progress& progress = {});

} // namespace shape
