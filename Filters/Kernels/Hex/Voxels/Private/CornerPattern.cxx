#include "Hex/Voxels/Private/CornerPattern.h"

namespace shape
{
namespace
{

/// Whether the marked ones of eight cells around a corner are connected by faces: cells whose
/// indices differ in one bit share a face.
bool AreConnected(unsigned int cells)
{
  if (cells == 0)
  {
    return true;
  }
  unsigned int reached = cells & (~cells + 1), before = 0;
  while (reached != before)
  {
    before = reached;
    for (int axis = 0; axis < 3; ++axis)
    {
      // The cells on the lower side of each axis.
      constexpr unsigned int low[] = { 0x55, 0x33, 0x0f };
      const int step = 1 << axis;
      reached |= (((reached & low[axis]) << step) | ((reached >> step) & low[axis])) & cells;
    }
  }
  return reached == cells;
}

} // namespace

bool IsWellComposed(unsigned int cells)
{
  return AreConnected(cells) && AreConnected(~cells & 0xff);
}

} // namespace shape
