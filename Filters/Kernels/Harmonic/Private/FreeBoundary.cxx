#include "Harmonic/Private/FreeBoundary.h"

#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/ImageSliding.h"
#include "Quality/MapQuality.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Number of tetrahedra that would fill the solid, if all had the maximum volume. There are about
/// twice as many, or more if the boundary is fine.
constexpr double Parts = 12000.0;

/// Returns the mean symmetric Dirichlet energy of a map of the tetrahedra; images are scaled
/// already.
double Distortion(const TetrahedralizeResult& solid, const Eigen::MatrixXd& images)
{
  CellSimplices cells;
  for (Eigen::Index t = 0; t < solid.Tetrahedra.rows(); ++t)
  {
    const Eigen::RowVector4i corners = solid.Tetrahedra.row(t);
    cells.Add(CellShape::Tetrahedron, corners.data());
    cells.EndCell();
  }
  const MapQualityResult quality =
    EvaluateMapQuality(solid.Points, images, cells, ComputeMapExtent(solid.Points, images, cells));
  MapQualitySums sums;
  sums.Add(quality, Eigen::VectorXi::Ones(solid.Tetrahedra.rows()));
  return sums.Mean(MapMeasure::SymmetricDirichlet);
}

} // namespace

FreeBoundaryResult SlideBoundary(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const HarmonicVolumeMapResult& map, const Progress& progress)
{
  // Outline:
  // 1. The solid is filled with tetrahedra.
  // 2. The images slide on the target, to lower the energy of the harmonic map of the tetrahedra.
  // 3. The harmonic map with the new boundary values is solved.
  // 4. It is kept if its distortion is lower.
  TetrahedralizeOptions fill;
  fill.MaximumVolume = std::abs(ComputeEnclosedVolume(boundary)) / Parts;
  const TetrahedralizeResult tetrahedra =
    Tetrahedralize(boundary, {}, fill, progress.Part(0.0, 0.1, "tetrahedralizing the solid"));
  // Maps the tetrahedra's points; boundary points get exactly the given values.
  const auto carry = [&](const ChargeSet& charges, const Eigen::MatrixXd& values)
  {
    Eigen::MatrixXd images = Evaluate(charges, tetrahedra.Points, progress.Part(0.1, 0.15));
    for (Eigen::Index i = 0; i < images.rows(); ++i)
    {
      if (tetrahedra.Provenance.Points(i) >= 0)
      {
        images.row(i) = values.row(tetrahedra.Provenance.Points(i));
      }
    }
    return images;
  };
  // Images divided by this have the volume of the solid: an isometry up to scale has distortion 6.
  const double size = std::cbrt(std::abs(
    ComputeEnclosedVolume({ targets, boundary.Triangles() }) / ComputeEnclosedVolume(boundary)));
  FreeBoundaryResult result{ targets, map, 0.0, 0.0, false };
  const Eigen::MatrixXd images = carry(map.Map, targets);
  result.DistortionBefore = Distortion(tetrahedra, images / size);
  result.DistortionAfter = result.DistortionBefore;

  // Step 2.
  SlidingSolid solid{ size * tetrahedra.Points, tetrahedra.Tetrahedra, {} };
  std::vector<int> origins; // of the boundary points of the solid
  for (int i = 0; i < tetrahedra.Provenance.Points.size(); ++i)
  {
    if (tetrahedra.Provenance.Points(i) >= 0)
    {
      solid.Boundary.push_back(i);
      origins.push_back(static_cast<int>(tetrahedra.Provenance.Points(i)));
    }
  }
  Eigen::MatrixXd freed = targets;
  freed(origins, Eigen::all) = SlideImages(
    solid, targets(origins, Eigen::all), target, progress.Part(0.15, 0.6, "freeing the boundary"));

  // Step 3.
  HarmonicVolumeMapResult again =
    ComputeHarmonicVolumeMap(boundary, freed, features, options, progress.Part(0.6, 0.95));
  const double after = Distortion(tetrahedra, carry(again.Map, freed) / size);
  // Step 4.
  if (after < result.DistortionBefore)
  {
    result = { std::move(freed), std::move(again), result.DistortionBefore, after, true };
  }
  return result;
}

} // namespace shape
