#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct PartialFunctionalMapOptions
{
  int Samples = 1000;   ///< points of the part that the refinement uses; >= 10
  int Eigenpairs = 120; ///< of the whole, at most; >= 10
  int First = 15;       ///< of the whole, at the start; >= 3
  int Step = 5;         ///< by which they become more; >= 1
};

/**
 * Where a part of a surface that is bent lies on the whole, and the other way.
 *
 * Both are taken at one scale, so that the part has fewer eigenfunctions up to a frequency than the
 * whole, about in proportion to its area (Weyl's law); functional maps from the whole to the part
 * are rectangular, with as many rows and columns as the surfaces have eigenvalues up to the same
 * bound (Rodola, Cosmo, Bronstein, Torsello and Cremers, "Partial functional correspondence", 2017,
 * section 3). They begin with the map of samples by EmbedByLandmarks and are refined as in
 * RefineByZoomOut (Melzi and others 2019, section on partial shapes), from the part's points alone,
 * for those of the whole need not have a partner.
 *
 * The whole's points go to the positions on the part whose images are nearest in the whole's
 * eigenfunctions over the roots of their eigenvalues (ComputeSpectralEmbedding): those in the
 * images to what they are images of, the others near the cut.
 *
 * part, whole: RequireConnected, landmarks: at least three, {point of the part, point of the
 * whole}. scale: lengths on the whole over those on the part. AToB of the result is the part's map,
 * BToA the whole's. Throws InvalidInput, SolveFailure, Aborted.
 */
SurfaceMaps ComputePartialFunctionalMap(const Surface& part, const Surface& whole,
  const Landmarks& landmarks, double scale, const PartialFunctionalMapOptions& options = {},
  const Progress& progress = {});

} // namespace shape
