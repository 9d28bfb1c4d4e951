#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Transport/GromovWassersteinCoupling.h"
#include "Correspondence/Transport/SampledCoupling.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

namespace shape
{

struct ShapeCouplingOptions
{
  int Samples = 200; ///< of each shape; >= 4
  int Starts = 32;   ///< couplings that are tried with a quarter of the samples; >= 1
  /// Whether the distances of each shape are divided by their mean, so that sizes may differ.
  bool SameSize = true;
  EntropicCouplingOptions Coupling;
};

struct ShapeCouplingResult
{
  ///@{
  /// For each point of A, the index of its image among the points of B, and the same for B.
  Eigen::VectorXi ImagesOfA, ImagesOfB;
  ///@}
  SampledCoupling Coupling; ///< its weights are shares of the area, volume or length
  /// The root mean square change of the distance of two samples, divided by the mean distance of
  /// two points of A.
  double Distortion = 0.0;
  double Error = 0.0; ///< the share of the mass that does not fit the samples' weights
};

/**
 * Computes the coupling of two shapes of any kind, such as a surface and a curve network or a set
 * of points, that best keeps the distances along them (SolveCoupling: Gromov-Wasserstein; Memoli,
 * "Gromov-Wasserstein distances and the metric approach to object matching", 2011).
 *
 * Distances are lengths of the shortest paths in the graph of the shape's points (BuildPointGraph),
 * so they are up to a tenth too long on surfaces. Samples are the points farthest from those
 * before, after the landmarks; the weight of a sample is what is nearest to it. Two samples are
 * alike if their distances from all others have similar quantiles (the local distributions of
 * distances in section 6 of the paper), and if they have similar distances from the landmarks.
 * Without landmarks, each start has three of its own: the first samples of A, and three samples of
 * B that are as far apart. Each start is coupled with a quarter of the samples; the one with the
 * smallest distortion is coupled with all.
 *
 * The image of a point x is the point y with the smallest distortion relative to the coupling P:
 * the minimum of the sum of (dA(x, i) - dB(y, j))^2 P(i, j). If a symmetry of a shape keeps all
 * distances, the result may contain that symmetry; landmarks prevent it.
 *
 * a, b: shapes in one piece. landmarks: pairs of points of the shapes, which are coupled only to
 * each other. Throws InvalidInput if a shape has several components or too few points, if a
 * landmark is no point, or if an option is out of range; SolveFailure; Aborted.
 */
ShapeCouplingResult CoupleShapes(const ShapeElements& a, const ShapeElements& b,
  const Landmarks& landmarks, const ShapeCouplingOptions& options = {},
  const Progress& progress = {});

} // namespace shape
