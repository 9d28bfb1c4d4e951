#pragma once

#include "Mesh/Surface.h"

#include <string>

namespace shape
{

/**
 * Throws InvalidInput if a closed surface encloses no volume, or so little for its area that cubes
 * cannot fill it. The mean thickness of the solid is twice its volume divided by its area. More
 * than a million cubes of this width are too many. `name` denotes the surface in the message.
 *
 * surface: closed and consistently oriented. Its components may be nested.
 */
void RequireVolume(const Surface& surface, const std::string& name);

} // namespace shape
