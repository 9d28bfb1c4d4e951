#pragma once

#include "Base/Progress.h"
#include "Labels/Private/SurfaceNet.h"

namespace shape
{

/**
 * Smooths a net within its cells: minimises |x - x0|^2 + (w / 2 pi)^4 |L x|^2 over the cells of the
 * points, where x0 are the points of the net and w is `wavelength`, in voxels. A wave of this
 * length is halved; longer waves stay, shorter ones vanish. Row i of L sums the differences from
 * point i to its neighbours. For a point inside an interface these are all neighbours; on a curve
 * where regions meet, those on the curve; at the end of such a curve or where curves meet there are
 * none, so that curves stay straight up to their ends. On curves, the first term weighs less and
 * the second more. Then x0 becomes the position where the smooth interfaces beside the curve, or
 * its end, meet (FitJunctions), and all points are smoothed again.
 *
 * The second-order energy does not shrink regions as repeated averaging does (Gibson 1998), so that
 * few points reach the border of their cells. These stay there: the remaining points are smoothed
 * again.
 *
 * wavelength: >= 0; 0 changes nothing. Throws Aborted.
 */
void SmoothNet(SurfaceNet& net, double wavelength, const Progress& progress = {});

} // namespace shape
