#pragma once

#include "Mesh/SurfacePoints.h"

#include <array>
#include <vector>

namespace shape
{

/// Points that correspond: one of surface A and one of surface B each.
using Landmarks = std::vector<std::array<int, 2>>;

/// Where each point of one surface is on the other one, both ways.
struct SurfaceMaps
{
  SurfacePoints AToB; ///< a row for each point of A, triangles of B
  SurfacePoints BToA; ///< a row for each point of B, triangles of A
};

} // namespace shape
