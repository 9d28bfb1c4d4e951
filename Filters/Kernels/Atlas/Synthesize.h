#pragma once

#include "Base/Progress.h"
#include "Harmonic/FiniteElementMap.h"
#include "Mesh/Surface.h"
#include "Quality/CellSimplices.h"

#include <Eigen/Core>

namespace shape
{

/// Values at n points of a linear model with K modes: at the weights w, they are
/// Mean + sum_k w_k Mode_k.
struct ModeValues
{
  Eigen::MatrixXd Mean;  ///< n x d
  Eigen::MatrixXd Modes; ///< n x d K: mode k in the columns d k to d k + d - 1
};

/// Returns Mean + sum_k weights(k) Mode_k (n x d). A mode without a weight counts as 0. Throws
/// InvalidInput if there are more weights than modes, or a weight is not finite.
Eigen::MatrixXd Synthesize(const ModeValues& values, const Eigen::VectorXd& weights);

struct SynthesizeOptions
{
  /// Approximate number of tetrahedra that fill the template: 1,000 to 100,000,000. It is larger if
  /// the template has many triangles.
  int Tetrahedra = 100000;
  bool Untangle = true; ///< whether inverted cells are untangled (ComputeFoldFreeMap)
  /// Hexahedra below this scaled Jacobian are improved (RaiseSampleQuality); 0 to 1. 0: none.
  double WantedScaledJacobian = 0.3;
};

/// Throws InvalidInput if an option is out of range.
void RequireValid(const SynthesizeOptions& options);

/**
 * Extends the mean and the modes of a shape from the template's surface to its inside: each
 * coordinate is the harmonic function with these boundary values. A harmonic function is linear in
 * its boundary values. The map of the sample at any weights is therefore the same sum of the maps
 * of the mean and of the modes, and no further system has to be solved. Linear finite elements
 * (ComputeFiniteElements) meet the boundary values exactly, and one factorisation serves all modes.
 *
 * surface: the template, closed. images: the mean and the modes at its points, d = 3. The result
 * has the coordinates of the mean in the columns 0 to 2 of Images, and those of mode k in the
 * columns 3 k + 3 to 3 k + 5. Throws like RequireValid and ComputeFiniteElements.
 */
FiniteElements SolveModes(const Surface& surface, const ModeValues& images,
  const SynthesizeOptions& options = {}, const Progress& progress = {});

/// Where the mean and the modes take points in or near the template.
struct CarriedModes : ModeValues
{
  /// n: 1 if the point is farther from the template than NearTemplate. Its mean is then its own
  /// position, and its modes are 0: it does not move. Otherwise 0.
  Eigen::VectorXi OutsideDomain;
  /// n: distance from the template / its longest side; 0 inside
  Eigen::VectorXd Distances;
};

/// Boundary points of hexahedra may leave the surface a little (RelaxBoundaryOfWorst). Points up to
/// this distance outside, divided by the template's longest side, are moved by the linear function
/// of the nearest tetrahedron.
constexpr double NearTemplate = 0.01;

/// Evaluates the maps of SolveModes at points (n x 3, finite). Throws Aborted.
CarriedModes CarryModes(
  const FiniteElementMap& map, const Eigen::MatrixXd& points, const Progress& progress = {});

/// Marks each cell that a map inverts: a simplex has not the orientation that it has at rest, by
/// exact predicates. Simplices without volume at rest, and cells without solid simplices, are not
/// inverted. rest, moved: n x 3. Returns 1 or 0 for each cell.
Eigen::VectorXi FindInvertedCells(
  const CellSimplices& cells, const Eigen::MatrixXd& rest, const Eigen::MatrixXd& moved);

} // namespace shape
