#pragma once

#include "Base/Progress.h"
#include "Harmonic/ChargeSet.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct VolumeRegistrationOptions
{
  /// First move, turn and scale the solid onto the target (FindCongruence). Without it, the solid
  /// starts where it is.
  bool Align = true;
  /// Weight of the distortion in the last stage; > 0. Less follows the target's detail more closely
  /// and distorts the solid more.
  double DistortionWeight = 1e-5;
  /// Largest number of descent steps in each of the three stages; >= 1.
  int MaximumIterations = 60;
};

/// How near and how regular the image of a solid is. Distances are between its boundary and the
/// target, in both directions, divided by the longest side of the target's box.
struct RegistrationQuality
{
  double MeanDistance = 0.0;    ///< root mean square, by area
  double MaximumDistance = 0.0; ///< at the points of both surfaces
  double Distortion = 0.0;      ///< mean symmetric Dirichlet energy; 6 for a similarity
};

struct VolumeRegistrationResult
{
  ChargeSet Map;                     ///< the map of the solid
  Eigen::MatrixXd Targets;           ///< n x 3: the images of the boundary's points
  RegistrationQuality Before, After; ///< of the start, and of Map
  int Iterations = 0;                ///< descent steps of all stages
};

/**
 * Maps a solid onto another one, of which only the surface is given, without any landmarks.
 *
 * The unknowns are the images of the boundary's points. They determine a harmonic map of the solid
 * (LinearVolumeMap). The images descend on the sum of two terms:
 * - the mean squared distance from the image of the boundary to the target, and back, by closest
 *   points, as in iterative closest points (Besl and McKay, "A method for registration of 3-D
 *   shapes", 1992);
 * - DistortionWeight times the mean symmetric Dirichlet energy |J|^2 + |J^-1|^2 of the map inside
 *   the solid and close below its boundary, relative to the start (Smith and Schaefer, "Bijective
 *   parameterization with free boundaries", 2015). It is infinite where the map folds, so the map
 *   does not fold at these positions.
 *
 * The gradient of the distortion is that of LinearVolumeMap: one transposed solve. Steps follow the
 * limited-memory BFGS method, with a Sobolev gradient as its first step: the gradient is smoothed
 * over a length along the boundary (Renka and Neuberger, "Minimal surfaces and Sobolev gradients",
 * 1995). In three stages, this length and the weight decrease, from the pose to the detail.
 *
 * The result is a local minimum: parts that are near each other at the start are matched. A
 * protrusion that is far from its counterpart may be matched to another one. Each step needs a fit
 * and a gradient, so a boundary of a few thousand points is enough.
 *
 * boundary: as for ComputeHarmonicVolumeMap. target: a surface with an area, closed or open. Throws
 * InvalidInput if a surface cannot be used, or an option is out of range; SolveFailure if the start
 * cannot be fitted, or the solid is too thin for a position inside; Aborted.
 */
VolumeRegistrationResult RegisterVolume(const Surface& boundary, const Surface& target,
  const VolumeRegistrationOptions& options = {}, const Progress& progress = {});

} // namespace shape
