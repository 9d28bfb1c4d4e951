#include "Solidify/Solidify.h"

#include "Mesh/Surface.h"
#include "Solidify/Private/JoinedSoup.h"

namespace shape
{

SolidifyResult Solidify(
  const Mesh& surface, const SolidifyOptions& options, const Progress& progress)
{
  SolidifyResult result;
  result.Defects =
    FindSurfaceDefects(surface, options.Defects, progress.Part(0.0, 0.3, "looking for defects"));
  result.Pieces = result.Defects.Pieces;
  result.EulerNumber = result.Defects.EulerNumber;
  if (result.Defects.Defects.empty() || options.Method == SolidifyMethod::Report)
  {
    result.Mended.Surface = surface;
    result.Mended.Origin = Eigen::VectorXi::Zero(surface.Triangles.rows());
    result.Mended.Provenance = TraceIdentity(surface.Points.rows(), surface.Triangles.rows());
    progress(1.0);
    return result;
  }
  result.Method = SolidifyMethod::Mend;
  result.Mended = MendSurface(surface, options.Defects, progress.Part(0.3, 0.9));
  const Surface solid = result.Mended.Surface;
  result.Pieces = solid.Topology().Components;
  result.EulerNumber = solid.Topology().EulerNumber;
  const Surface before = JoinSoup(surface, options.Defects.Tolerance, {}).Surface;
  result.Distances =
    ComputeHausdorffDistance(before, solid, progress.Part(0.9, 1.0, "measuring the distances"));
  return result;
}

} // namespace shape
