#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solidify/MendedSurface.h"

#include <string>

namespace shape
{

/// Returns a surface that was made on a grid of this spacing, with the data of the nearest
/// positions on the input. Pieces smaller than `smallest` are removed; the others are oriented by
/// nesting. name: what made it, for messages. Throws InvalidInput if the surface is empty or has a
/// defect; Aborted.
MendedSurface AdoptGridSurface(const Mesh& made, double spacing, const Mesh& input, double smallest,
  const std::string& name, const Progress& progress);

/// Returns the size of details (>= 0), or the default if it is 0.
double ChooseDetailSize(const Mesh& surface, double size);

} // namespace shape
