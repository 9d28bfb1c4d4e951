#include "Correspondence/Evaluate/InvertMap.h"

#include "Search/ClosestPoint.h"

namespace shape
{

SurfacePoints InvertMap(const Surface& surface, const SurfacePoints& images, const Surface& target,
  const Progress& progress)
{
  const Surface moved = surface.WithPoints(PullBack(images, target.Triangles(), target.Points()));
  return SurfaceLocator(moved).Find(target.Points(), progress);
}

} // namespace shape
