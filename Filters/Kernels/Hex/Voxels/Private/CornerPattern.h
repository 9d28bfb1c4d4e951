#pragma once

namespace shape
{

/// Whether some of eight cells around a corner are well-composed there (Latecki, "3D well-composed
/// pictures", 1997): both these cells and the others are connected by faces. cells: bit k is set
/// for cell k, which lies on the upper side of axis a if bit a of k is set.
bool IsWellComposed(unsigned int cells);

} // namespace shape
