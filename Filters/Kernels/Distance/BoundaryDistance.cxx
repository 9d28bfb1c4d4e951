#include "Distance/BoundaryDistance.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Solids/Nesting.h"

namespace shape
{

namespace
{

/// A sign needs a solid; the message names the option that does without.
Surface Oriented(const Surface& surface, const Progress& progress)
{
  try
  {
    return OrientByNesting(surface, "the Surface", progress);
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(
      error.what() + std::string("; or turn Signed off, which works for any surface"));
  }
}

} // namespace

BoundaryDistance::BoundaryDistance(
  const Surface& surface, const BoundaryDistanceOptions& options, const Progress& progress)
{
  if (surface.Triangles().rows() == 0)
  {
    throw InvalidInput(
      "the Surface has no polygons; give a surface, for example the output of Extract Surface");
  }
  RequireFinite(surface.Points(), "the Surface");
  if (options.Signed)
  {
    this->WithSign.emplace(Oriented(surface, progress.Part(0.0, 0.5, "orienting the surface")));
  }
  else
  {
    this->WithoutSign.emplace(surface);
  }
  progress(1.0);
}

Eigen::VectorXd BoundaryDistance::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  RequireFinite(points, "the Input");
  return this->WithSign ? this->WithSign->Evaluate(points, progress).Distances
                        : this->WithoutSign->Find(points, progress).Distances;
}

} // namespace shape
