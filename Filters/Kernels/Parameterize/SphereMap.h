#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Methods for the sphere map, the most conformal first. Each is tried if the previous one leaves
/// flipped triangles.
enum class SphereMapMethod
{
  ConformalFlow, ///< the flow with cotangent weights
  PositiveFlow,  ///< the flow with weights of at least 0.01: not conformal at obtuse angles
  /// inserts point by point, starting from a tetrahedron: balances areas, not angles
  GlobalReinsertion
};

struct SphereMapOptions
{
  /// The first method to try.
  SphereMapMethod First = SphereMapMethod::ConformalFlow;
  double TimeStep = 0.03;     ///< time step of the flow, for a surface of area 1
  int FreeIterations = 5;     ///< steps before the flow is projected onto the sphere
  int MaximumIterations = 60; ///< maximum number of steps of the flow
  double Tolerance =
    /// in [0, 1): the flow stops when the mean conformal distortion gains relatively less than this
    1e-4;
  /// maximum share of the points that may be reinserted after ConformalFlow
  double LargestRepair = 0.01;
  double AreaWeight = 1.0;    ///< GlobalReinsertion: weight of equal areas relative to equal angles
  int RelaxationSweeps = 400; ///< sweeps over the reinserted points and two rings around them
};

struct SphereMapResult
{
  Eigen::MatrixXd Points; ///< n x 3: the image of each point, on the unit sphere
  SphereMapMethod Method = SphereMapMethod::ConformalFlow;
  int Iterations = 0;            ///< steps of the flow of Method
  int FlipsBeforeRelaxation = 0; ///< triangles that the first method left flipped
  int Reinserted = 0;            ///< points that were moved to repair Method's flipped triangles
  double MeanLength = 0.0;       ///< length of the image's area-weighted mean: 0 up to rounding
  double SmallestArea = 0.0;     ///< minimum area of a spherical triangle; all areas add up to 4 pi
};

/**
 * Maps a closed surface of genus 0 one-to-one to the unit sphere around the origin, nearly
 * conformally. No triangle is flipped: det[a, b, c] > 0 beyond rounding error, in the given order
 * of the corners. A surface that faces inwards is mirrored. The image covers the sphere once.
 *
 * The method is conformalised mean curvature flow (Kazhdan, Solomon & Ben-Chen 2012, equation 9).
 * Each implicit step solves (M_t + dt L_0) x = M_t x_t, with the stiffness of the given surface and
 * the lumped masses of the moving one. After the first steps it is projected onto the sphere.
 * Flipped triangles are repaired by ReinsertFlipped and RelaxOnSphere; if that fails, the other
 * methods are tried. Finally CenterOnSphere moves the image's mean, weighted by the areas of the
 * given surface, to the origin.
 *
 * A conformal map shrinks extremities exponentially with their length over their girth (a figure's
 * fingers to 1e-25). If later computations need larger triangles, set First to GlobalReinsertion;
 * AreaWeight is passed to ReinsertAll.
 *
 * The thread count changes the image by rounding only, and by up to 1e-6 at reinserted points.
 * Translating or scaling the input changes the result by rounding only. Rotating the input rotates
 * the result, except at reinserted points. GlobalReinsertion depends on the connectivity alone;
 * only the final centring uses the shape.
 *
 * Throws InvalidInput if an option is out of range or the surface is not closed, has several
 * components, genus > 0, no extent, or unused points. Throws SolveFailure with the number of
 * flipped triangles if any remain.
 */
SphereMapResult MapToSphere(
  const Surface& surface, const SphereMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
