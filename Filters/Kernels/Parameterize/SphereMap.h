#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// What gave the points their positions, the most conformal first. Each is tried if those before it
/// left flipped triangles.
enum class SphereMapMethod
{
  ConformalFlow,    ///< the flow by cotangent weights
  PositiveFlow,     ///< the same flow, no weight below a hundredth: not conformal at obtuse angles
  GlobalReinsertion ///< point by point from a tetrahedron: balances areas instead of angles
};

struct SphereMapOptions
{
  /// The first that is tried.
  SphereMapMethod First = SphereMapMethod::ConformalFlow;
  double TimeStep = 0.03;     ///< of the flow, for a surface of area 1
  int FreeIterations = 5;     ///< steps before the flow is held on the sphere
  int MaximumIterations = 60; ///< steps of the flow
  double Tolerance =
    1e-4; ///< in [0, 1): relative gain of mean conformal distortion that keeps it going
  double LargestRepair = 0.01; ///< share of the points that may be reinserted after ConformalFlow
  double AreaWeight = 1.0;     ///< equal areas against equal angles in GlobalReinsertion
  int RelaxationSweeps = 400;  ///< of the points that were reinserted and two rings around them
};

struct SphereMapResult
{
  Eigen::MatrixXd Points; ///< n x 3: the image of each point, on the unit sphere
  SphereMapMethod Method = SphereMapMethod::ConformalFlow;
  int Iterations = 0;            ///< steps of the method's flow
  int FlipsBeforeRelaxation = 0; ///< triangles that the first method left flipped
  int Reinserted = 0;            ///< points that were moved to end the method's flips
  double MeanLength = 0.0;       ///< of the area-weighted mean of the image: 0 but for rounding
  double SmallestArea = 0.0;     ///< of a spherical triangle; all of them add up to 4 pi
};

/**
 * Maps a closed surface of genus 0 one to one to the unit sphere around the origin, nearly
 * conformally: no triangle is flipped (det[a, b, c] > 0 beyond rounding error, for the triangles'
 * order as given; a surface that faces inwards is mirrored) and the image covers the sphere once.
 *
 * Conformalised mean-curvature flow (Kazhdan, Solomon & Ben-Chen 2012, equation 9): implicit steps
 * (M_t + dt L_0) x = M_t x_t with the stiffness of the given surface and the lumped masses of the
 * moving one, held on the sphere after the first steps. ReinsertFlipped and RelaxOnSphere if
 * triangles flip, the other methods if that is not enough. CenterOnSphere: the mean of the
 * image, weighted by the areas of the given surface, is the origin.
 *
 * A conformal map shrinks extremities exponentially with their length over their girth (a figure's
 * fingers to 1e-25). Where the image must stay coarse enough to compute on, let First be
 * GlobalReinsertion; AreaWeight is that of ReinsertAll.
 *
 * The thread count changes the image by rounding, and by up to 1e-6 at points that were reinserted.
 * Translation and scale of the input change the result by rounding only, and rotating the input
 * rotates the result, except at points that were reinserted. GlobalReinsertion sees the shape only
 * when it centres: its result depends on the connectivity alone.
 *
 * Throws InvalidInput if an option is out of range or the surface is not closed, has several
 * components, genus > 0, no extent, or points that no triangle uses; SolveFailure if flipped
 * triangles remain: with their count.
 */
SphereMapResult MapToSphere(
  const Surface& surface, const SphereMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
