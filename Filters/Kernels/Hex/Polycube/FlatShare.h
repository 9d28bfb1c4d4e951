#pragma once

#include "Mesh/Surface.h"

namespace shape
{

/// Returns the largest share of the area whose normals deviate by at most 10 degrees from one of
/// six directions, which are chosen one after another. A cube has 1, a sphere 0.05.
double ComputeFlatShare(const Surface& surface);

} // namespace shape
