#pragma once

#include "Base/Progress.h"
#include "Harmonic/FiniteElementMap.h"

#include <vector>

namespace shape
{

/// A connected part of the core of a repair. No two parts share a point, so each is untangled by
/// itself.
struct CorePart
{
  std::vector<int> Tetrahedra; ///< ascending
  std::vector<int> Points;     ///< ascending; these are the first points of Elements
  /// The part as UntanglePart made it, in coordinates of its own numbering; Images: its map.
  FiniteElements Elements;
  /// Whether the image of its boundary crosses itself. Then no inner points make all tetrahedra
  /// positive.
  bool Crosses = false;
  bool IsUntangled = false; ///< whether no tetrahedron is inverted
};

/**
 * Moves inner points of a part until no image of a tetrahedron is inverted. part.Elements has the
 * images to begin with. If a harmonic map between the points around the inverted tetrahedra inverts
 * much fewer, inner points start there, and at the given images only if tetrahedra stay inverted.
 * Tetrahedra are split unless the part crosses itself: that takes long, and cannot help.
 *
 * maximumWork: see UntangleOptions. Returns the work that was done. Throws what Untangle throws.
 */
double UntanglePart(CorePart& part, double maximumWork, const Progress& progress);

} // namespace shape
