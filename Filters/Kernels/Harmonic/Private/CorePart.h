#pragma once

#include "Base/Progress.h"
#include "Harmonic/FiniteElementMap.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// A connected part of the core of a repair. No two parts share a point, so each is untangled by
/// itself.
struct CorePart
{
  std::vector<int> Tetrahedra; ///< ascending
  /// Ascending; these are the first points of Elements: all points or, if the part was filled anew,
  /// those of its boundary.
  std::vector<int> Points;
  /// The part as UntanglePart made it, in coordinates of its own numbering; Images: its map.
  FiniteElements Elements;
  /// Whether the image of its boundary crosses itself. Then no inner points make all tetrahedra
  /// positive.
  bool Crosses = false;
  bool IsUntangled = false; ///< whether no tetrahedron is inverted
};

/// Returns the points where the boundary of a core touches itself: its triangles around them are
/// several fans. They hold the core on all sides, and TetGen does not fill its image.
std::vector<int> FindPinches(const Surface& boundary);

/**
 * Moves inner points of a part until no image of a tetrahedron is inverted. part.Elements has the
 * images to begin with. If a harmonic map between the points around the inverted tetrahedra inverts
 * much fewer, inner points start there, and at the given images only if tetrahedra stay inverted.
 * Tetrahedra are split unless the part crosses itself: that takes long, and cannot help.
 *
 * If tetrahedra stay inverted then, the image is filled with new tetrahedra, and these are mapped
 * to the part: where the image is long and thin, they have the points inside that the part's lack.
 *
 * maximumWork: see UntangleOptions; as much again for the inverse. Returns the work that was done
 * without that of the inverse. Throws what Untangle throws.
 */
double UntanglePart(CorePart& part, double maximumWork, const Progress& progress);

} // namespace shape
