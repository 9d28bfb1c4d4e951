#pragma once

#include "Base/Progress.h"
#include "Distortion/InjectiveRefinement.h"
#include "Untangle/Private/SlidingBoundary.h"
#include "Untangle/Private/SolidCells.h"

namespace shape
{

/**
 * Moves the points of a solid to lower the mean distortion of its cells, and inverts none
 * (RefineInjectively). A cell's distortion is the mean over its corner tetrahedra, each compared
 * with its rest shape. If there are no rest positions, the rest shapes are regular cells of the
 * target size (ComputeLogarithmicSizes). Means are weighted by the volume at rest.
 *
 * sliding: how boundary points move; null if they are fixed. Cells that are inverted do not count,
 * and their points do not move. The result's Points are those of the solid. Throws whatever
 * RefineInjectively throws.
 */
InjectiveRefinementResult RefineSolid(SolidCells& solid, const SlidingBoundary* sliding,
  const InjectiveRefinementOptions& options, const Progress& progress = {});

} // namespace shape
