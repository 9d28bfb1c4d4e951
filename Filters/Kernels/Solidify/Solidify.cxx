#include "Solidify/Solidify.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solidify/Private/SolidSurface.h"
#include "Solidify/Private/WrapSurface.h"

#include <cmath>
#include <set>
#include <vector>

namespace shape
{
namespace
{

MendedSurface Apply(SolidifyMethod method, const Mesh& surface, const SolidifyOptions& options,
  const Progress& progress)
{
  if (method == SolidifyMethod::Mend)
  {
    return MendSurface(surface, options.Defects, progress);
  }
  if (method == SolidifyMethod::Solid)
  {
    return MakeSolid(surface, { options.Defects, options.DetailSize }, progress);
  }
  return WrapSurface(surface,
    { options.Defects, options.DetailSize, options.GapSize, options.SheetThickness }, progress);
}

/// Sets the result of the method, or of the first that succeeds.
void ApplyFirst(SolidifyResult& result, const Mesh& surface, const SolidifyOptions& options,
  const Progress& progress)
{
  result.Method = options.Method;
  if (options.Method == SolidifyMethod::Automatic)
  {
    for (const auto method : { SolidifyMethod::Mend, SolidifyMethod::Solid })
    {
      const double begin = method == SolidifyMethod::Mend ? 0.0 : 0.3;
      try
      {
        result.Method = method;
        result.Mended = Apply(method, surface, options, progress.Part(begin, begin + 0.3));
        return;
      }
      catch (const InvalidInput&) // not enough; the next method may be
      {
      }
      catch (const SolveFailure&)
      {
      }
    }
    result.Method = SolidifyMethod::Wrap;
  }
  result.Mended = Apply(result.Method, surface, options,
    options.Method == SolidifyMethod::Automatic ? progress.Part(0.6, 1.0) : progress);
}

/// Returns the largest distance of some triangles of a surface from another one; 0 without any.
double MeasureFarthest(const Mesh& surface, const std::vector<int>& triangles, const Surface& other,
  const Progress& progress)
{
  const Surface part = Mesh{ surface.Points, surface.Triangles(triangles, Eigen::all) };
  return ComputeArea(part) > 0.0
    ? ComputeDistancesToSurface(part, SurfaceLocator(other), progress).Distances.maxCoeff()
    : 0.0;
}

/// The distances between the input and the result. Triangles that were kept lie on both, so that
/// only the others are measured.
HausdorffDistances MeasureDistances(const JoinedSoup& input, const MendedSurface& mended,
  const Surface& solid, const Progress& progress)
{
  std::set<int> kept;
  std::vector<int> changed, lost;
  for (int t = 0; t < static_cast<int>(mended.Origin.size()); ++t)
  {
    if (mended.Origin(t) == static_cast<int>(TriangleOrigin::Kept))
    {
      kept.insert(mended.Provenance.Cells(t));
      continue;
    }
    changed.push_back(t);
  }
  for (int t = 0; t < static_cast<int>(input.Triangles.size()); ++t)
  {
    if (kept.count(input.Triangles[t]) == 0)
    {
      lost.push_back(t);
    }
  }
  return { MeasureFarthest(
             input.Surface, lost, solid, progress.Part(0.0, 0.5, "measuring the distances")),
    MeasureFarthest(solid, changed, input.Surface, progress.Part(0.5, 1.0)) };
}

} // namespace

SolidifyResult Solidify(
  const Mesh& surface, const SolidifyOptions& options, const Progress& progress)
{
  // Here, because not every method uses them, and a surface without defects needs no method.
  const auto requireLength = [](const char* name, double length)
  {
    RequireOption(
      length >= 0.0 && std::isfinite(length), name, length, "a finite number of at least 0");
  };
  requireLength("DetailSize", options.DetailSize);
  requireLength("GapSize", options.GapSize);
  requireLength("SheetThickness", options.SheetThickness);
  SolidifyResult result;
  result.Defects =
    FindSurfaceDefects(surface, options.Defects, progress.Part(0.0, 0.3, "looking for defects"));
  result.Pieces = result.Defects.Pieces;
  result.EulerNumber = result.Defects.EulerNumber;
  const bool isSound = result.Defects.Defects.empty() && options.Method != SolidifyMethod::Wrap;
  if (isSound || options.Method == SolidifyMethod::Report)
  {
    result.Mended.Surface = surface;
    result.Mended.Origin = Eigen::VectorXi::Zero(surface.Triangles.rows());
    result.Mended.Provenance = TraceIdentity(surface.Points.rows(), surface.Triangles.rows());
    progress(1.0);
    return result;
  }
  ApplyFirst(result, surface, options, progress.Part(0.3, 0.9));
  const Surface solid = result.Mended.Surface;
  result.Pieces = solid.Topology().Components;
  result.EulerNumber = solid.Topology().EulerNumber;
  result.Distances = MeasureDistances(JoinSoup(surface, options.Defects.Tolerance, {}),
    result.Mended, solid, progress.Part(0.9, 1.0));
  return result;
}

} // namespace shape
