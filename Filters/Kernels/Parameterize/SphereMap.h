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
  /// the flow with all weights raised to at least 0.01: not conformal at obtuse angles
  PositiveFlow,
  /// points inserted one by one, starting from a tetrahedron: balances areas rather than angles
  GlobalReinsertion
};

struct SphereMapOptions
{
  /// The first method to try.
  SphereMapMethod First = SphereMapMethod::ConformalFlow;
  double TimeStep = 0.03;     ///< time step of the flow, for a surface of area 1
  int FreeIterations = 5;     ///< from this step on, each result is projected onto the sphere
  int MaximumIterations = 60; ///< maximum number of steps of the flow
  /// The flow stops after three steps in a row that fail to lower the mean conformal distortion by
  /// this share; in [0, 1).
  double Tolerance = 1e-4;
  /// After ConformalFlow, at most this share of the points may be reinserted, or 16 points if that
  /// is more; >= 0.
  double LargestRepair = 0.01;
  double AreaWeight = 1.0; ///< GlobalReinsertion: weight of equal areas relative to equal angles
  /// maximum number of sweeps over the reinserted points and two rings around them
  int RelaxationSweeps = 400;
};

struct SphereMapResult
{
  Eigen::MatrixXd Points; ///< n x 3: the image of each point, on the unit sphere
  SphereMapMethod Method = SphereMapMethod::ConformalFlow;
  int Iterations = 0; ///< number of steps of the flow
  /// number of flipped triangles in the image by the method First, before any repair
  int FlipsBeforeRelaxation = 0;
  /// number of points that were reinserted to repair flipped triangles
  int Reinserted = 0;
  /// distance of the image's area-weighted mean from the origin: 0 up to rounding
  double MeanLength = 0.0;
  double SmallestArea = 0.0; ///< minimum area of a spherical triangle; all areas add up to 4 pi
};

/**
 * Maps a closed surface of genus 0 one-to-one to the unit sphere around the origin, nearly
 * conformally. The image covers the sphere once, and no triangle is flipped: for its corners in the
 * given order, det[a, b, c] > 0 beyond rounding error. So the image of a surface that faces inwards
 * is mirrored.
 *
 * The method is conformalised mean curvature flow (Kazhdan, Solomon & Ben-Chen 2012, equation 9).
 * Each implicit step solves (M_t + dt L_0) x = M_t x_t, with the stiffness matrix L_0 of the given
 * surface and the lumped masses M_t of the moving surface. After the first steps, each result is
 * projected onto the sphere. ReinsertFlipped and RelaxOnSphere repair flipped triangles; if they
 * fail, the next method is tried. Finally CenterOnSphere moves the image's mean, weighted by the
 * areas of the given surface, to the origin.
 *
 * A conformal map shrinks an extremity exponentially with the ratio of its length to its girth (the
 * fingers of a figure to 1e-25). If later computations need larger triangles, set First to
 * GlobalReinsertion; AreaWeight is passed to ReinsertAll.
 *
 * The number of threads changes reinserted points by up to 1e-6, and the other points by rounding
 * only. Translating or scaling the input changes the result by rounding only. Rotating the input
 * rotates the result, except at reinserted points. The image of GlobalReinsertion depends on the
 * connectivity alone, up to the final centring.
 *
 * Throws InvalidInput if an option is out of range or the surface is not closed. Also throws
 * InvalidInput if the surface has several components, genus > 0, unused points or no area. Throws
 * SolveFailure with the number of flipped triangles if every method fails. Throws Aborted.
 */
SphereMapResult MapToSphere(
  const Surface& surface, const SphereMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
