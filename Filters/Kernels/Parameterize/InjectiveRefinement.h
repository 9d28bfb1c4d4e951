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
  double Exponent = 1.0;       ///< of the exponential measures; > 0
  double Scale = 1.0;          ///< lengths of the surface count times this; > 0
  int MaximumIterations = 300; ///< >= 0
  /// Ends when each of five iterations gains no more than this share; in [0, 1).
  double Tolerance = 1e-5;
};

struct InjectiveRefinementResult
{
  Eigen::MatrixXd Points; ///< n x 2
  /// Mean of the measure over the surface's area at the start; of an exponential one after
  /// SymmetricDirichlet.
  double StartEnergy = 0.0;
  double Energy = 0.0; ///< the same at the end
  int Iterations = 0;  ///< systems solved
};

/**
 * Moves the points of a planar image of a surface so that the mean distortion falls, without ever
 * flipping a triangle: scalable locally injective mappings (Rabinovich, Poranne, Panozzo and
 * Sorkine-Hornung 2017). Each iteration replaces the measure by a weighted quadratic form with the
 * same gradient (section 3.2 there), goes to its minimum, but less than 0.8 of the way to the first
 * flip, and halves the step until the energy falls (Armijo). All systems share one pattern, whose
 * elimination order is found once.
 *
 * Points that are free on the boundary move as well: images of far parts may come to overlap,
 * though no triangle is flipped. Exponential measures start from the result of SymmetricDirichlet.
 *
 * surface: each component with at least one triangle, every point used. start: n x 2, every
 * triangle counter-clockwise. fixed: points that stay. Throws InvalidInput if an option is out
 * of range or a triangle of the start is not counter-clockwise, SolveFailure if the measure
 * exceeds double precision at the start; Aborted, after one factorisation at most.
 */
InjectiveRefinementResult RefineInjectively(const Mesh& surface, const Eigen::MatrixXd& start,
  const std::vector<int>& fixed = {}, const InjectiveRefinementOptions& options = {},
  const Progress& progress = {});

} // namespace shape
