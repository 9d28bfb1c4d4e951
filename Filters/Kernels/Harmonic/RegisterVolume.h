#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <Eigen/Core>

namespace shape
{

struct RegisterVolumeOptions
{
  /// First move, turn and scale the solid onto the target (FindCongruence). If false, the solid
  /// starts where it is.
  bool Align = true;
  /// Weight of the distortion in the last stage; > 0. With less, the image follows the target's
  /// detail more closely, and the solid is distorted more.
  double DistortionWeight = 1e-5;
  /// Largest number of steps in each stage; >= 1.
  int MaximumIterations = 100;
};

/// How near the image of a solid is to the target, and how distorted.
struct RegistrationQuality
{
  ///@{
  /// Distances of positions on the image of the boundary from the target, and back
  /// (ComputeDistancesToSurface), divided by the longest side of the target's box.
  double MeanDistance = 0.0;
  double MaximumDistance = 0.0; ///< the Hausdorff distance
  ///@}
  double Distortion = 0.0; ///< mean symmetric Dirichlet energy; 6 for an isometry
};

struct RegisterVolumeResult
{
  Eigen::MatrixXd Targets;           ///< n x 3: the images of the boundary's points
  TetrahedralizeResult Solid;        ///< the solid inside the boundary
  Eigen::MatrixXd SolidTargets;      ///< the images of its points; none of its cells is inverted
  RegistrationQuality Before, After; ///< of the start, and of the result
  int Iterations = 0;                ///< steps of all stages
};

/**
 * Maps a solid onto the solid inside another surface, without landmarks.
 *
 * The solid is filled with tetrahedra. The unknowns are the images of the points of its boundary,
 * which determine a harmonic map of the tetrahedra. They descend on the sum of two terms:
 * - the mean squared distance from the image of the boundary to the target, and back, by closest
 *   points, as in iterative closest points (Besl and McKay, "A method for registration of 3-D
 *   shapes", 1992);
 * - DistortionWeight times the mean symmetric Dirichlet energy |J|^2 + |J^-1|^2 of the map (Smith
 *   and Schaefer, "Bijective parameterization with free boundaries", 2015). It is infinite if a
 *   tetrahedron is inverted. The start inverts none, so no step does.
 *
 * Lengths are relative to the start, which may be scaled. The gradient needs one more solve with
 * the factorised matrix of the map. Steps follow the limited-memory BFGS method (Nocedal and
 * Wright, "Numerical optimization", 2006, algorithm 7.4). Its first approximation is the Hessian at
 * an isometry, so the first steps are smooth over a length that decreases with the weight. In
 * four stages, the weight decreases from 1000 times DistortionWeight: first the pose is found, then
 * the detail.
 *
 * The result is a local minimum: parts that are near each other at the start are matched. A
 * protrusion far from its counterpart may be matched to another one.
 *
 * boundary: closed, as for Tetrahedralize. target: a surface with an area, closed or open. Throws
 * InvalidInput if a surface cannot be used, or an option is out of range; SolveFailure if the
 * tetrahedra are so flat that there is no harmonic map; the exceptions of Tetrahedralize; Aborted.
 */
RegisterVolumeResult RegisterVolume(const Surface& boundary, const Surface& target,
  const RegisterVolumeOptions& options = {}, const Progress& progress = {});

} // namespace shape
