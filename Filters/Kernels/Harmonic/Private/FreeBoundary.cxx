#include "Harmonic/Private/FreeBoundary.h"

#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Mesh/Cells.h"
#include "Quality/MapQuality.h"
#include "Search/ClosestPoint.h"
#include "Tetrahedra/Tetrahedralize.h"
#include "Untangle/MinimizeEnergy.h"
#include "Untangle/Untangle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr int MaximumSteps = 30;

/// Constrains some points to a surface; the others are free.
class OnSurface : public PointConstraint
{
public:
  OnSurface(const Surface& surface, std::vector<char> held)
    : Locator(surface)
    , Held(std::move(held))
    , Normals(ComputeVertexNormals(surface, NormalWeight::Area))
  {
  }

  int Freedom(int point) const override { return this->Held[point] ? 2 : 3; }

  PointDirections Directions(int, const Eigen::RowVector3d& position) const override
  {
    // The directions are orthonormal tangents at the closest point of the target. The normal is
    // interpolated, so points can cross creases.
    const ClosestPoints closest = this->Locator.Find(position);
    const Eigen::Vector3d normal =
      PullBack(closest, this->Locator.GetSurface().Triangles(), this->Normals)
        .row(0)
        .normalized()
        .transpose();
    PointDirections directions(3, 2);
    directions.col(0) = normal.unitOrthogonal();
    directions.col(1) = normal.cross(directions.col(0));
    return directions;
  }

  Eigen::RowVector3d Nearest(int, const Eigen::RowVector3d& position) const override
  {
    return this->Locator.Find(position).Positions.row(0);
  }

private:
  SurfaceLocator Locator;
  std::vector<char> Held;
  Eigen::MatrixXd Normals;
};

Cells ToCells(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
{
  const int count = static_cast<int>(tetrahedra.rows());
  const Eigen::MatrixXi byCell = tetrahedra.transpose();
  return { points, Eigen::VectorXi::Constant(count, cell_kind::Tetrahedron),
    Eigen::VectorXi::LinSpaced(count + 1, 0, 4 * count), byCell.reshaped() };
}

/// The tetrahedra of an untangled solid, and the rest positions of all its points.
struct Solid
{
  Cells Moved;
  Eigen::MatrixXd Rest;
};

Solid Untangled(
  const TetrahedralizeResult& tetrahedra, const Eigen::MatrixXd& moved, const Progress& progress)
{
  UntangleResult result =
    Untangle(ToCells(moved, tetrahedra.Tetrahedra), tetrahedra.Points, {}, progress);
  if (result.InvertedAfter > 0)
  {
    throw SolveFailure("FreeBoundary: " + std::to_string(result.InvertedAfter) +
      " tetrahedra of the solid stay inverted, so the boundary map folds; correct it, or turn "
      "FreeBoundary off");
  }
  // Points added by untangling have the mean of their parents' rest positions.
  return { std::move(result.Solid), result.Provenance.Weights * tetrahedra.Points };
}

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

SimplexPatch WholePatch(const Solid& solid, double size)
{
  SimplexPatch patch;
  std::vector<char> used(solid.Rest.rows(), 0);
  for (Eigen::Index t = 0; t < solid.Moved.Kinds.size(); ++t)
  {
    std::array<int, 4> c;
    std::copy_n(solid.Moved.Corners.data() + solid.Moved.Offsets(t), 4, c.begin());
    Eigen::Matrix3d edges;
    // The rest shape is scaled to the volume of the image.
    for (int k = 0; k < 3; ++k)
    {
      edges.col(k) = size * (solid.Rest.row(c[k + 1]) - solid.Rest.row(c[0])).transpose();
    }
    patch.Simplices.push_back({ c, ComputeHatGradients(edges) });
    for (const int point : c)
    {
      used[point] = 1;
    }
  }
  for (std::size_t point = 0; point < used.size(); ++point)
  {
    if (used[point])
    {
      patch.FreePoints.push_back(static_cast<int>(point));
    }
  }
  return patch;
}

} // namespace

FreeBoundaryResult SlideBoundary(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const HarmonicVolumeMapResult& map, const Progress& progress)
{
  // Outline:
  // 1. The solid is tetrahedralized; the given map moves the tetrahedra.
  // 2. Inverted tetrahedra are untangled.
  // 3. The elliptic energy is minimized; boundary points slide on the target.
  // 4. The harmonic map with the new boundary values is solved.
  // 5. It is kept if its distortion is lower.
  const TetrahedralizeResult tetrahedra =
    Tetrahedralize(boundary, {}, {}, progress.Part(0.0, 0.1, "tetrahedralizing the solid"));
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

  // Step 2: untangling.
  Solid solid = Untangled(tetrahedra, images, progress.Part(0.15, 0.3, "untangling the solid"));
  std::vector<char> held(solid.Rest.rows(), 0);
  for (Eigen::Index i = 0; i < tetrahedra.Provenance.Points.size(); ++i)
  {
    held[i] = tetrahedra.Provenance.Points(i) >= 0;
  }
  // Step 3: sliding.
  const OnSurface constraint(target, held);
  PatchOptions steps;
  steps.MaximumSteps = steps.FurtherSteps = MaximumSteps;
  MinimizeEnergy(solid.Moved.Points, WholePatch(solid, size), &constraint, steps,
    progress.Part(0.3, 0.6, "freeing the boundary"));

  // Step 4: the new harmonic map.
  Eigen::MatrixXd freed = targets;
  for (Eigen::Index i = 0; i < tetrahedra.Provenance.Points.size(); ++i)
  {
    if (held[i])
    {
      freed.row(tetrahedra.Provenance.Points(i)) = solid.Moved.Points.row(i);
    }
  }
  HarmonicVolumeMapResult again =
    ComputeHarmonicVolumeMap(boundary, freed, features, options, progress.Part(0.6, 0.95));
  const double after = Distortion(tetrahedra, carry(again.Map, freed) / size);
  // Step 5: comparison.
  if (after < result.DistortionBefore)
  {
    result = { std::move(freed), std::move(again), result.DistortionBefore, after, true };
  }
  return result;
}

} // namespace shape
