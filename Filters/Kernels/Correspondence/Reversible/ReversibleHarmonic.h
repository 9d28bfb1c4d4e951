#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Spectrum/Smacof.h"

#include <vector>

namespace shape
{

struct ReversibleHarmonicOptions
{
  double Alpha = 2e-5; ///< final weight of the Dirichlet energy; in (0, 1)
  /// Initial weight of the Dirichlet energy, which decreases geometrically to Alpha; in (0, 1).
  double FirstAlpha = 3e-2;
  int AlphaSteps = 40;    ///< number of iterations from FirstAlpha to Alpha; >= 0
  double BetaStep = 5e-3; ///< increase of the penalty's weight in each iteration; > 0
  int BetaSteps = 100;    ///< number of iterations in which the penalty increases; >= 1
  /// The number of the first iteration; >= 1. The weights of an iteration depend on its number. A
  /// number above 1 continues earlier iterations.
  int FirstIteration = 1;
  int MaximumIterations = 100; ///< maximum number of iterations; >= 1
  double Tolerance = 1e-4;     ///< relative change of the energy at which the iteration stops; >= 0
  bool PinLandmarks = true;    ///< whether each landmark's image stays at its partner
  /// Options of the embedding, in which straight distances approximate geodesic ones.
  SmacofOptions Scaling;
};

/// A surface and an embedding of its points in which straight distances approximate geodesic ones.
struct EmbeddedSurface
{
  shape::Surface Surface;
  Eigen::MatrixXd Embedding; ///< n x d, d <= 32; the surface's area is scaled to 1
};

struct ReversibleHarmonicResult
{
  SurfaceMaps Maps;
  /// The energy after each iteration, with the weights of that iteration.
  std::vector<double> Energies;
};

/**
 * Computes a map from each surface onto the other one. The two maps are smooth and nearly inverse
 * to each other (Ezuz, Solomon and Ben-Chen, "Reversible harmonic maps between discrete surfaces",
 * 2019). They minimise
 *
 *   alpha (tr X12' W1 X12 + tr X21' W2 X21)
 *   + (1 - alpha) (|P21 X12 - X2|^2 + |P12 X21 - X1|^2)
 *   + beta (|P12 X2 - X12|^2 + |P21 X1 - X21|^2)
 *
 * in the norms of the mass matrices, with areas scaled to 1. X1 and X2 are the EmbedBySmacof
 * positions of the surfaces, W1 and W2 their stiffness matrices. P12 maps the points of the first
 * surface to the second one. X12 is a variable for the images of these points; the penalty beta
 * keeps it near P12 X2. P21 and X21 are the same for the other direction. P21, X21, P12 and X12 are
 * updated in turn (half-quadratic splitting, section 5 of the paper). Each P is found by exact
 * projection onto triangles, in twice as many dimensions as the embedding has (TriangleTree). Each
 * X is the solution of one linear system. Negative cotangent weights are raised to 0.
 *
 * Alpha is larger at first because smoother maps move farther in an iteration. The smaller the
 * final alpha, the closer the maps are to inverses of each other. On the pairs of
 * CorrespondencePairs.py, the round-trip errors for a final alpha of 2e-5 are a fifth of the errors
 * for 5e-4, and the maps are equally smooth.
 *
 * a, b: consistently oriented 2-manifolds of one component, open or closed, of any genus. start:
 * initial maps, such as those of MapByLandmarkCells or ComputeFunctionalMap; if they are mirrored,
 * the result is mirrored too. Throws InvalidInput if an option is out of range; SolveFailure;
 * Aborted.
 */
ReversibleHarmonicResult ComputeReversibleHarmonicMap(const Surface& a, const Surface& b,
  const SurfaceMaps& start, const Landmarks& landmarks = {},
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

/// Does the same for surfaces with known embeddings. options.Scaling is not used.
ReversibleHarmonicResult ComputeReversibleHarmonicMap(const EmbeddedSurface& a,
  const EmbeddedSurface& b, const SurfaceMaps& start, const Landmarks& landmarks,
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

/**
 * Computes the maps on the coarse surfaces of a pair. If these have fewer points than the fine
 * ones, it then repeats the last quarter of the alpha steps on the fine surfaces, starting from the
 * coarse maps. By then, the smooth part of the maps is known, which takes most of the iterations.
 * The embeddings use the samples of the coarse surfaces.
 *
 * start, landmarks: maps and landmarks of the coarse surfaces. Returns the maps of the fine
 * surfaces, but the Energies of the iterations on the coarse surfaces. Throws InvalidInput,
 * SolveFailure, Aborted.
 */
ReversibleHarmonicResult RefineReversibleHarmonicMap(const CoarsePair& pair,
  const SurfaceMaps& start, const Landmarks& landmarks,
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

} // namespace shape
