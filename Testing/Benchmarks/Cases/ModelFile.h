#pragma once

#include "Mesh/Mesh.h"

#include <string>

namespace benchmark
{

/// Reads a surface in the format OFF (ReadOff), STL, PLY or OBJ, by its extension, and scales it as
/// ReadOff does. VTK reads the last three. Throws shape::InvalidInput if it cannot be read or has
/// no polygons.
shape::Mesh ReadModel(const std::string& path);

} // namespace benchmark
