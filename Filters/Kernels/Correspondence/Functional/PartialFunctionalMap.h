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
 * Both surfaces are first brought to the same scale. By Weyl's law, the number of eigenvalues below
 * a bound is about proportional to the area, so the part has fewer of them than the full surface.
 * Functional maps from the full surface to the part are therefore rectangular: their rows and
 * columns belong to the eigenvalues of the two surfaces below the same bound (Rodola, Cosmo,
 * Bronstein, Torsello and Cremers, "Partial functional correspondence", 2017, section 3). The first
 * map takes each sample of the part to the point of the full surface with the nearest row of
 * EmbedByLandmarks. This map is refined by the method of RefineByZoomOut (Melzi and others 2019,
 * section on partial shapes). Only samples of the part are used, since points of the full surface
 * need not have a partner.
 *
 * The map back takes each point of the full surface to the position on the part whose image is
 * nearest to it. Distances are measured in the full surface's ComputeSpectralEmbedding: its
 * eigenfunctions divided by the roots of their eigenvalues. A point inside the part's image returns
 * to the point that is mapped there; other points go near the cut.
 *
 * part, whole: the part and the full surface; RequireConnected must accept both. landmarks: at
 * least three pairs {point of the part, point of the full surface}. scale: lengths on the full
 * surface divided by those on the part. In the result, AToB maps the part to the full surface, and
 * BToA maps the full surface to the part. Throws InvalidInput, SolveFailure, Aborted.
 */
SurfaceMaps ComputePartialFunctionalMap(const Surface& part, const Surface& whole,
  const Landmarks& landmarks, double scale, const PartialFunctionalMapOptions& options = {},
  const Progress& progress = {});

} // namespace shape
