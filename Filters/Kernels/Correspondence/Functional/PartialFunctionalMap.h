#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct PartialFunctionalMapOptions
{
  int Samples = 1000;   ///< points of the part used by the refinement; >= 10
  int Eigenpairs = 120; ///< maximum number of eigenfunctions of the full surface; >= 10
  int First = 15;       ///< eigenfunctions of the full surface at the start; >= 3
  int Step = 5;         ///< eigenfunctions added in each refinement; >= 1
};

/**
 * Computes the map from a bent part of a surface to the full surface, and the map back.
 *
 * Both are brought to one scale. The part then has fewer eigenfunctions below a frequency than the
 * full surface, about in proportion to its area (Weyl's law). Functional maps from the full surface
 * to the part are therefore rectangular: each side has the number of eigenvalues below the same
 * bound (Rodola, Cosmo, Bronstein, Torsello and Cremers, "Partial functional correspondence", 2017,
 * section 3). The start is the map of samples by EmbedByLandmarks. It is refined as in
 * RefineByZoomOut (Melzi and others 2019, section on partial shapes), but only the points of the
 * part are used: points of the full surface need not have a partner.
 *
 * Each point of the full surface goes to the position on the part whose image is nearest. Distances
 * are those of the full surface's eigenfunctions divided by the roots of their eigenvalues
 * (ComputeSpectralEmbedding). Points inside the part's image return to the points that are mapped
 * there, and others go near the cut.
 *
 * part, whole: RequireConnected, the part and the full surface. landmarks: at least three, {point
 * of the part, point of the full surface}. scale: lengths on the full surface divided by those on
 * the part. In the result, AToB is the map of the part and BToA that of the full surface. Throws
 * InvalidInput, SolveFailure, Aborted.
 */
SurfaceMaps ComputePartialFunctionalMap(const Surface& part, const Surface& whole,
  const Landmarks& landmarks, double scale, const PartialFunctionalMapOptions& options = {},
  const Progress& progress = {});

} // namespace shape
