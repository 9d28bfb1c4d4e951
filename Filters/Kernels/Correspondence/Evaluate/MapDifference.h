#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

struct MapDifferenceOptions
{
  /// k: functions of the first surface that the operators act on; of the second, twice as many are
  /// used, or as many as it has points.
  int NumberOfEigenpairs = 50;
};

/// What a difference operator does to a surface's functions.
struct DifferenceOperator
{
  Eigen::MatrixXd Matrix; ///< k x k, in the eigenbasis of the first surface
  /// n: <d, D d> / <d, d> for the function d of this space that is nearest to a point: around it,
  /// how much longer its functions become by the map.
  Eigen::VectorXd Field;
  Eigen::VectorXd Eigenvalues;    ///< those farthest from 1 first, by their logarithm
  Eigen::MatrixXd Eigenfunctions; ///< n x as many: large where the surfaces differ so much
};

struct MapDifferenceResult
{
  DifferenceOperator Area; ///< of <f, g> = the integral of f g; Field: the ratio of areas
  /// Of the integral of grad f . grad g. Field: (s / t + t / s) / 2 for stretches s and t, where
  /// functions vary as much in all directions; t / s on a part so thin that they vary along it
  /// only.
  DifferenceOperator Conformal;
  int Undetermined = 0; ///< functions of the second surface that the map says too little of
};

/// How many eigenfunctions of an operator there are, or k.
inline constexpr int DifferenceEigenfunctions = 10;

/**
 * Where two surfaces differ, as operators on functions of the first (Rustamov et al., "Map-based
 * exploration of intrinsic shape differences and variability", 2013).
 *
 * F takes functions of `first` to `second`: F f is the combination of eigenfunctions of `second`
 * whose values at the images are nearest to f, by least squares in the areas of `first`. Then
 * <f, V g> = <F f, F g> (equation 4 there) and <f, R g> = <F f, F g> with the products of gradients
 * (equation 6): V = F' F, R = L1^+ F' L2 F in the eigenbases, with eigenvalues L1 and L2. V is the
 * identity if the map keeps areas, R if it keeps angles; constants, which have no gradient,
 * are left out of R: their rows and columns are 0.
 *
 * Combinations of which less than a thousandth of the largest share lies on the image, as on a part
 * of `second` that nothing goes to, do not count, and are counted in Undetermined.
 *
 * first, second: 2-manifolds, open or closed. map: where the points of `first` go. Throws
 * InvalidInput if they are not such ones or have fewer points than NumberOfEigenpairs asks for;
 * SolveFailure, Aborted.
 */
MapDifferenceResult MapDifference(const Surface& first, const Surface& second,
  const SurfacePoints& map, const MapDifferenceOptions& options = {},
  const Progress& progress = {});

} // namespace shape
