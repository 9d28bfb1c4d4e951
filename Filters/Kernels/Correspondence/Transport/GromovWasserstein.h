#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Transport/GromovWassersteinCoupling.h"
#include "Correspondence/Transport/SampledCoupling.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Numbers at the points of two surfaces that corresponding points should share. Each column is
/// divided by its range over both surfaces. The cost of a pair is the mean over the columns of the
/// squared difference.
struct PairFeatures
{
  Eigen::MatrixXd OfA, OfB;   ///< nA x f and nB x f, finite; f may be 0
  double FeatureWeight = 0.5; ///< MetricSpaces::CostWeight
};

struct GromovWassersteinOptions
{
  int Samples = 500;   ///< samples of each surface; >= 10
  int Eigenpairs = 60; ///< eigenpairs of each surface, to extend the map to all points; >= 2
  EntropicCouplingOptions Coupling;
  PairFeatures Features;
  /// Sets of landmarks, each of which starts one coupling; not used if landmarks are given. If
  /// there are no sets, FindLandmarks gives two: its Pairs and its Rival.
  std::vector<Landmarks> Starts;
};

struct GromovWassersteinResult
{
  SurfaceMaps Maps;
  /// The root mean square difference between the distance of two samples and the distance of their
  /// images, divided by the root of the area.
  double Distortion = 0.0;
  double FeatureCost = 0.0; ///< EntropicCoupling::Cost
  double Error = 0.0;       ///< the share of the mass that does not fit the samples' weights
  SampledCoupling Coupling;
  Landmarks Start; ///< the given landmarks, or those from which the best coupling started
};

/**
 * Computes corresponding points of two surfaces by the coupling of samples that best keeps the
 * distances along the surfaces (SolveCoupling; Solomon, Peyre, Kim and Sra, "Entropic metric
 * alignment for correspondence problems", 2016). The coupling may be one to many if the shapes
 * differ.
 *
 * The weight of a sample is the area nearest to it. The entropy is decreased twice: first on a
 * quarter of the samples; then, from eight times its final value, on all samples. The two points of
 * a landmark are samples that are coupled only to each other. The start is the similarity of the
 * samples' positions relative to the landmarks (EmbedByLandmarks). Without landmarks, no samples
 * are fixed. Each set of Starts then gives a coupling on a quarter of the samples, and the coupling
 * with the smallest cost is used: its squared distortion, or the mean of that and the cost of the
 * features, by their weight.
 *
 * The map of samples is extended to all points by "soft" functional maps (section 4 of the paper).
 * The image of a sample is the mean of B's eigenfunctions over the samples coupled to it. The
 * eigenfunctions of A are fitted to these images by least squares, which gives an image of every
 * point. The point is mapped to a position on B near this image (FindNearestSurfacePoints).
 *
 * a, b: consistently oriented 2-manifolds of one component, open or closed, of any genus, with a
 * triangle at each point. Sizes may differ. Throws InvalidInput if the input is not as required;
 * SolveFailure; Aborted.
 */
GromovWassersteinResult ComputeGromovWassersteinMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const GromovWassersteinOptions& options = {},
  const Progress& progress = {});

} // namespace shape
