#include "CutPaste/PointTarget.h"

#include "Base/Errors.h"
#include "CutPaste/Private/PlacedLoop.h"
#include "CutPaste/Private/SoupPatch.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <utility>

namespace shape
{

PointTarget::PointTarget(
  SampledSurface samples, const ExponentialMapOptions& options, const Progress& progress)
  : Samples(std::move(samples))
  , Map(this->Samples, options, progress)
  , MeanLink(ComputeSpacing(this->Samples))
{
}

// 1. Flatten the points around the seed by their exponential map.
// 2. Place the loop in its plane; a point of the loop at a sample takes the sample's position.
// 3. Remove the samples below it.
LoopOnPoints PointTarget::Land(
  const FeatureFootprint& base, const PastePlacement& placement, const Progress& progress)
{
  RequireInRange(placement);
  const Eigen::MatrixXd loop = PoseLoop(base, placement);
  const double radius = 1.1 * loop.rowwise().norm().maxCoeff() + 4.0 * this->MeanLink;
  const ClosestPoint seed = this->Map.Locator().FindOne(placement.Seed);
  const ExponentialPatch patch =
    this->Map.Around(seed, radius, TurnAxis(base, this->Map.Normal(seed)), progress);
  if (patch.Triangles.empty())
  {
    throw InvalidInput("there are no points around the seed, or the gaps between them are too "
                       "wide; raise Scale or move Seed");
  }
  const Eigen::MatrixXd points = this->Samples.Surface.Points(patch.Points, Eigen::all);
  const Eigen::MatrixXd normals = this->Samples.Normals(patch.Points, Eigen::all);
  LoopOnPoints landing;
  landing.Seed = patch.Seed;
  landing.IsRemoved.assign(this->Samples.Surface.Points.rows(), 0);
  landing.IsNearHole = landing.IsRemoved;
  landing.IsAtSample.assign(loop.rows(), 0);
  PlacedLoop placed = PlaceLoop(patch, points, normals, loop, "points");
  constexpr double snapShare = 1e-3; // far above rounding, far below what can be seen
  const double snap = snapShare * this->MeanLink;
  for (std::size_t k = 0; k < patch.Points.size(); ++k)
  {
    const auto row = static_cast<Eigen::Index>(k);
    const Eigen::RowVector2d image = patch.Positions.row(row);
    Eigen::Index nearest = 0;
    const double distance = (loop.rowwise() - image).rowwise().norm().minCoeff(&nearest);
    const bool isSame = distance <= snap;
    if (isSame)
    {
      placed.Positions.row(nearest) = points.row(row);
      placed.Normals.row(nearest) = normals.row(row);
      landing.IsAtSample[nearest] = 1;
    }
    const bool isBelow = !isSame && Contains(loop, image);
    landing.IsRemoved[patch.Points[k]] = isSame || isBelow ? 1 : 0;
    landing.Covered += isBelow ? 1 : 0;
  }
  landing.Positions = std::move(placed.Positions);
  landing.Normals = std::move(placed.Normals);
  for (const auto& corners : this->Samples.Surface.Triangles.rowwise())
  {
    const bool isAtHole = landing.IsRemoved[corners(0)] != 0 ||
      landing.IsRemoved[corners(1)] != 0 || landing.IsRemoved[corners(2)] != 0;
    for (const int corner : corners)
    {
      landing.IsNearHole[corner] |= isAtHole && landing.IsRemoved[corner] == 0 ? 1 : 0;
    }
  }
  progress(1.0);
  return landing;
}

SurfaceSamples SampleTriangles(const Surface& surface, double spacing, const Progress& progress)
{
  RequireOption(spacing > 0.0, "the spacing", spacing, "positive");
  constexpr double all = std::numeric_limits<double>::infinity();
  const RefinedSoup refined =
    RefineSoup(surface, surface.Points().row(0), all, spacing, progress.Part(0.0, 0.3));
  const Topology& kind = surface.Topology();
  const bool isOriented =
    kind.NonManifoldEdges + kind.NonManifoldPoints + kind.MisorientedEdges == 0;
  SurfaceSamples result;
  result.Samples = ConnectSamples(refined.Surface.Points,
    isOriented ? ComputeVertexNormals(refined.Surface, NormalWeight::Angle) : Eigen::MatrixXd(0, 3),
    {}, progress.Part(0.3, 1.0));
  ProvenanceWriter writer(surface.Points().rows());
  writer.AddCopies(surface.Points().rows());
  for (const auto& [a, b] : refined.Midpoints)
  {
    writer.AddMean({ a, b });
  }
  result.Origin = writer.Finish(Eigen::VectorXi(0));
  return result;
}

} // namespace shape
