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
  double Alpha = 2e-5;         ///< the share of the Dirichlet energy; in (0, 1)
  double FirstAlpha = 3e-2;    ///< where that begins, from which it falls geometrically; < 1
  int AlphaSteps = 40;         ///< iterations in which it falls; >= 0
  double BetaStep = 5e-3;      ///< by which the penalty's weight grows in each iteration; > 0
  int BetaSteps = 100;         ///< iterations after which it stays; >= 1
  int FirstIteration = 1;      ///< where the weights begin, above 1 on maps refined before; >= 1
  int MaximumIterations = 100; ///< >= 1
  double Tolerance = 1e-4;     ///< relative change of the energy at which it ends; >= 0
  bool PinLandmarks = true;    ///< keeps each landmark's image at its partner
  SmacofOptions Scaling;       ///< the embedding in which straight distances are geodesic ones
};

/// A surface and positions of its points whose straight distances are nearly geodesic ones.
struct EmbeddedSurface
{
  shape::Surface Surface;
  Eigen::MatrixXd Embedding; ///< n x d, d <= 32, where the surface's area is 1
};

struct ReversibleHarmonicResult
{
  SurfaceMaps Maps;
  std::vector<double> Energies; ///< after each iteration, at that iteration's weight of the penalty
};

/**
 * Two maps, of each surface onto the other one, that are smooth and nearly each other's inverse
 * (Ezuz, Solomon and Ben-Chen, "Reversible harmonic maps between discrete surfaces", 2019): the
 * minimum of
 *
 *   alpha (tr X12' W1 X12 + tr X21' W2 X21)
 *   + (1 - alpha) (|P21 X12 - X2|^2 + |P12 X21 - X1|^2)
 *   + beta (|P12 X2 - X12|^2 + |P21 X1 - X21|^2)
 *
 * with the masses' norms, areas made 1 and X1, X2 the surfaces' own EmbedBySmacof, by turns over
 * P21, X21, P12 and X12 (half-quadratic splitting, section 5 there): the maps P by exact projection
 * on triangles in twice as many dimensions (TriangleTree), the X by one linear system. Negative
 * cotangent weights are raised to 0. Alpha is larger at first: smoother maps move farther in an
 * iteration. The less it ends at, the nearer the maps are to each other's inverse: at 2e-5 round
 * trips on the pairs of CorrespondencePairs.py are a fifth as long as at 5e-4, and the maps no less
 * smooth.
 *
 * a, b: consistently oriented 2-manifolds of one component, open or closed, of any genus. start:
 * maps to begin at, such as LandmarkCells or a FunctionalMap; a mirrored start stays mirrored.
 * Throws InvalidInput, SolveFailure, Aborted.
 */
ReversibleHarmonicResult ComputeReversibleHarmonicMap(const Surface& a, const Surface& b,
  const SurfaceMaps& start, const Landmarks& landmarks = {},
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

/// The same of surfaces whose embeddings are known. options.Scaling is not used.
ReversibleHarmonicResult ComputeReversibleHarmonicMap(const EmbeddedSurface& a,
  const EmbeddedSurface& b, const SurfaceMaps& start, const Landmarks& landmarks,
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

/**
 * ReversibleHarmonic of the coarse surfaces of a pair, and if these have fewer points than the
 * fine ones the last quarter of the steps of alpha again, of these, from the maps of the coarse
 * ones: the smooth part of the maps, which takes most iterations, is then found. The embedding's
 * samples are those of the coarse surfaces.
 *
 * start: of the coarse surfaces; landmarks: of the coarse ones. Returns the maps of the fine
 * surfaces; Energies are the coarse ones'. Throws InvalidInput, SolveFailure, Aborted.
 */
ReversibleHarmonicResult RefineReversibleHarmonicMap(const CoarsePair& pair,
  const SurfaceMaps& start, const Landmarks& landmarks,
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

} // namespace shape
