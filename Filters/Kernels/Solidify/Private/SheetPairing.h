#pragma once

#include "Base/Progress.h"
#include "Solidify/Private/SoupRepair.h"

namespace shape
{

/**
 * Removes sheets that do not bound the solid: walls inside it and sheets that are attached to it
 * from outside. A sheet is a set of triangles that is connected by edges with two triangles. Only
 * sheets at edges with three or more triangles are tested, by rays (CrossingCounter). The most
 * redundant sheets are removed first, then the others are tested again. Returns the number of
 * removed triangles. Throws Aborted.
 */
int RemoveRedundantSheets(MendedDraft& draft, const Progress& progress);

struct SeparatedSheets
{
  int SplitPoints = 0; ///< number of copies of points
  int Reversed = 0;    ///< number of reversed triangles
};

/**
 * Makes each edge an edge of at most two triangles, each point a point of one fan, and the
 * orientation of the triangles consistent.
 *
 * At an edge with three or more triangles, the two triangles around a wedge of the solid stay
 * connected; rays decide which wedges are inside. Points are copied where fans separate. A point
 * at which several holes touch is not copied: its fans are connected when the holes are filled. In
 * each piece, the orientation that most triangles have is kept. Throws InvalidInput if a piece has
 * only one side, as a Moebius strip; Aborted.
 */
SeparatedSheets SeparateSheets(MendedDraft& draft, const Progress& progress);

} // namespace shape
