#pragma once

#include "Mesh/Surface.h"

#include <string>

namespace shape
{

/// Throws InvalidInput unless a surface is closed, of one component and genus 0, and uses all of
/// its points. map: what needs such a surface, in the message.
void RequireSphereLike(const Surface& surface, const std::string& map);

} // namespace shape
