#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

struct MapDifferenceOptions
{
  /// k: number of eigenfunctions of the first surface that the operators act on. Of the second
  /// surface, 2 k are used, or as many as it has points.
  int NumberOfEigenpairs = 50;
};

/// A difference operator on the functions of a surface, and its spectrum.
struct DifferenceOperator
{
  Eigen::MatrixXd Matrix; ///< k x k, in the eigenbasis of the first surface
  /// n: <d, D d> / <d, d> for the function d of this space that is nearest to a delta at the point.
  /// It measures by how much the map scales the norms of functions around the point.
  Eigen::VectorXd Field;
  Eigen::VectorXd Eigenvalues;    ///< the farthest from 1 first, by their logarithm
  Eigen::MatrixXd Eigenfunctions; ///< n x their number: large where the surfaces differ accordingly
};

struct MapDifferenceResult
{
  DifferenceOperator Area; ///< for <f, g> = the integral of f g; Field: the ratio of areas
  /// For the integral of grad f . grad g. For stretches s and t, Field is (s / t + t / s) / 2 if
  /// functions vary equally in all directions. On a part so thin that they only vary along it, it
  /// is t / s.
  DifferenceOperator Conformal;
  int Undetermined = 0; ///< functions of the second surface that the map does not determine
};

/// The maximum number of eigenfunctions returned for an operator; at most k are.
inline constexpr int DifferenceEigenfunctions = 10;

/**
 * Computes where two surfaces differ, as operators on functions of the first one (Rustamov et al.,
 * "Map-based exploration of intrinsic shape differences and variability", 2013).
 *
 * F takes functions of `first` to `second`: F f is the combination of eigenfunctions of `second`
 * whose values at the images are nearest to f, by least squares weighted with the areas of `first`.
 * Then <f, V g> = <F f, F g> (equation 4 of the paper) and, with the products of gradients, <f, R
 * g> = <F f, F g> (equation 6). In the eigenbases, with eigenvalues L1 and L2, V = F' F and R =
 * L1^+ F' L2 F. V is the identity if the map keeps areas, R if it keeps angles. Constants have no
 * gradient: their rows and columns of R are 0.
 *
 * Some combinations of eigenfunctions are concentrated where the map reaches nothing, such as on a
 * part of `second` without a partner. If the share of a combination on the image is less than a
 * thousandth of the largest such share, it is ignored; Undetermined is their number.
 *
 * first, second: 2-manifolds, open or closed. map: the images of the points of `first`. Throws
 * InvalidInput if they are not, or have fewer points than NumberOfEigenpairs requires;
 * SolveFailure, Aborted.
 */
MapDifferenceResult MapDifference(const Surface& first, const Surface& second,
  const SurfacePoints& map, const MapDifferenceOptions& options = {},
  const Progress& progress = {});

} // namespace shape
