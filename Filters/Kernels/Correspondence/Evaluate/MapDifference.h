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
  /// surface, 2 k eigenfunctions are used, but no more than either surface has points.
  int NumberOfEigenpairs = 50;
  /// How the products of functions on the second surface are integrated.
  enum class ProductsType
  {
    /// Over the second surface: functions are pulled back into its eigenbasis, F f as below.
    Eigenfunctions,
    /// Over the triangles of the first surface with their corners at the images, which is exact for
    /// functions that are linear on them (Corman et al. 2017, section 4). Such operators determine
    /// the lengths of edges: see RecoverMetric.
    Triangles
  };
  ProductsType Products = ProductsType::Eigenfunctions;
};

/// A difference operator on the functions of a surface, and its spectrum.
struct DifferenceOperator
{
  Eigen::MatrixXd Matrix; ///< k x k, in the eigenbasis of the first surface
  /// n values: <d, D d> / <d, d> at each point. D is the operator; d is the combination of the k
  /// eigenfunctions that is nearest to a delta at the point. The value measures by how much the map
  /// scales the norms of functions around the point.
  Eigen::VectorXd Field;
  Eigen::VectorXd Eigenvalues; ///< in decreasing order of |log(eigenvalue)|
  /// n rows, and one column for each of Eigenvalues. An eigenfunction is large where the surfaces
  /// differ by its eigenvalue.
  Eigen::MatrixXd Eigenfunctions;
};

struct MapDifferenceResult
{
  /// The operator for the inner product <f, g> = the integral of f g. Its Field is the ratio of
  /// areas.
  DifferenceOperator Area;
  /// The operator for the inner product <f, g> = the integral of grad f . grad g. Let s and t be
  /// the stretches of the map in its principal directions. If functions vary equally in all
  /// directions, Field is (s / t + t / s) / 2. On a part so thin that functions vary only along it,
  /// Field is t / s, where s is the stretch along the part.
  DifferenceOperator Conformal;
  /// Number of functions on the second surface that the map does not determine.
  int Undetermined = 0;
};

/// The maximum number of eigenfunctions that are returned for an operator; never more than k.
inline constexpr int DifferenceEigenfunctions = 10;

/**
 * Computes the differences between two surfaces as operators on the functions of the first one
 * (Rustamov et al., "Map-based exploration of intrinsic shape differences and variability", 2013).
 *
 * F takes functions on `first` to functions on `second`. F f is a combination of eigenfunctions of
 * `second`. Its values at the images of positions on `first` fit f by least squares, weighted by
 * the areas of `first`. The area operator V satisfies <f, V g> = <F f, F g> (equation 4 of the
 * paper). The conformal operator R satisfies the same equation for the products of gradients
 * (equation 6). In the eigenbases, with eigenvalues L1 and L2, V = F' F and R = L1^+ F' L2 F. V is
 * the identity if the map keeps areas. R is the identity, except for constants, if the map keeps
 * angles. Constants have no gradient, so their rows and columns of R are 0.
 *
 * With Products = Triangles, V = A1^-1 A2 and R = W1^-1 W2, where A and W are the products of the
 * same k functions and of their gradients, on the triangles of `first` as they are and as they are
 * mapped (Corman et al., "Functional characterization of intrinsic and extrinsic geometry", 2017).
 * Undetermined is then 0.
 *
 * Some combinations of eigenfunctions are concentrated outside the image of the map, such as on a
 * part of `second` without a partner. A combination is ignored if the share of its squared norm on
 * the image is less than a thousandth of the largest such share. Undetermined is the number of
 * ignored combinations.
 *
 * first, second: 2-manifolds, open or closed. map: the images of the points of `first`. Throws
 * InvalidInput if a surface is not a 2-manifold or has fewer than NumberOfEigenpairs points, or if
 * `first` has NumberOfEigenpairs or more components; SolveFailure; Aborted.
 */
MapDifferenceResult MapDifference(const Surface& first, const Surface& second,
  const SurfacePoints& map, const MapDifferenceOptions& options = {},
  const Progress& progress = {});

} // namespace shape
