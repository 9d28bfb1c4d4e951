#pragma once

#include "Mesh/SurfacePoints.h"

#include <array>
#include <vector>

namespace shape
{

/// Pairs of corresponding points: {point of surface A, point of surface B}.
using Landmarks = std::vector<std::array<int, 2>>;

/// The images of the points of each surface on the other one.
struct SurfaceMaps
{
  SurfacePoints AToB; ///< a row for each point of A, on triangles of B
  SurfacePoints BToA; ///< a row for each point of B, on triangles of A
};

} // namespace shape
