#include "Correspondence/Conformal/OrbifoldMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr int LocatorGrain = 512;      // positions
constexpr double TileRounding = 1e-12; // tiles have the size 1

using Complex = std::complex<double>;

Mesh FlatMesh(const OrbifoldImage& image)
{
  Mesh flat{ Eigen::MatrixXd::Zero(image.Points.rows(), 3), image.Cut.Surface.Triangles };
  flat.Points.leftCols(2) = image.Points;
  return flat;
}

/// Returns the maximum distance of the image from its tile's first cone.
double ReachOf(const OrbifoldImage& image)
{
  const Complex first = image.Tile.There.front();
  return (image.Points.rowwise() - Eigen::RowVector2d(first.real(), first.imag()))
    .rowwise()
    .norm()
    .maxCoeff();
}

/// Sets weights that differ from 0 by rounding only to 0.
/// A point on an edge or at a vertex then has its exact support, which does not depend on the
/// triangle in which it was found.
Eigen::RowVector3d Snapped(Eigen::RowVector3d barycentric)
{
  // Far above the rounding of the search, far below a visible distance.
  constexpr double minimum = 1e-9;
  barycentric = (barycentric.array() < minimum).select(0.0, barycentric);
  return barycentric / barycentric.sum();
}

OrbifoldImage ImageOf(const std::string& name, const Surface& surface,
  const std::vector<int>& cones, OrbifoldType type, const Progress& progress)
{
  try
  {
    return MapToOrbifold(surface, cones, type, progress);
  }
  catch (const InvalidInput& problem)
  {
    throw InvalidInput("Surface " + name + ": " + problem.what());
  }
  catch (const SolveFailure& problem)
  {
    throw SolveFailure("Surface " + name + ": " + problem.what());
  }
}

} // namespace

OrbifoldLocator::OrbifoldLocator(OrbifoldImage image, double reach)
  : Image(std::move(image))
  , Reach(reach)
  // Enough motions: the position is within reach of the first cone, and so is the image within its
  // own reach; no other motion can bring them together.
  , Motions(ComputeOrbifoldMotions(
      this->Image.Tile, this->Image.Tile.There.front(), reach + ReachOf(this->Image)))
  , Flat(FlatMesh(this->Image))
{
}

SurfacePoints OrbifoldLocator::Find(
  const Eigen::MatrixXd& positions, const Progress& progress) const
{
  const Complex first = this->Image.Tile.There.front();
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    if (!(std::abs(Complex(positions(i, 0), positions(i, 1)) - first) <=
          this->Reach + TileRounding))
    {
      throw InvalidInput("position " + std::to_string(i) + " is farther from the first cone than " +
        std::to_string(this->Reach) + "; give the locator a larger reach");
    }
  }
  const Eigen::RowVector2d low = this->Image.Points.colwise().minCoeff().array() - TileRounding;
  const Eigen::RowVector2d high = this->Image.Points.colwise().maxCoeff().array() + TileRounding;
  SurfacePoints map{ Eigen::VectorXi(positions.rows()), Eigen::MatrixXd(positions.rows(), 3) };
  ParallelFor(
    static_cast<int>(positions.rows()), LocatorGrain,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        ClosestPoint best;
        best.Barycentric.setZero();
        best.Position.setZero();
        best.Distance = std::numeric_limits<double>::infinity();
        for (const PlaneIsometry& motion : this->Motions)
        {
          const Complex moved = motion(Complex(positions(i, 0), positions(i, 1)));
          const Eigen::RowVector3d position(moved.real(), moved.imag(), 0.0);
          // Most motions take the position away from the tile; the box rejects them before the
          // search.
          if ((position.head<2>().array() < low.array()).any() ||
            (position.head<2>().array() > high.array()).any())
          {
            continue;
          }
          // Images of the tile cover the plane without overlap: in exact arithmetic one motion
          // brings the position into it. Rounding may leave a gap at the border; the closest image
          // is taken then.
          const ClosestPoint closest = this->Flat.FindOne(position, best.Triangle);
          best = closest.Distance < best.Distance ? closest : best;
          if (best.Distance <= TileRounding)
          {
            break;
          }
        }
        map.Triangles(i) = best.Triangle;
        map.Barycentrics.row(i) = Snapped(best.Barycentric);
      }
    },
    progress);
  return map;
}

Eigen::MatrixXd CollectUncutPositions(const OrbifoldImage& image, Eigen::Index points)
{
  // Copies of points follow all original points.
  return image.Points.topRows(points);
}

// Aigerman and Lipman, section 5: both surfaces are laid out on the same orbifold. A point of A
// goes to the point of B with the same position on the orbifold, that is, up to a motion in the
// plane.
OrbifoldMap MapThroughOrbifold(const Surface& a, const std::vector<int>& conesA, const Surface& b,
  const std::vector<int>& conesB, OrbifoldType type, const Progress& progress)
{
  const OrbifoldImage imageA =
    ImageOf("A", a, conesA, type, progress.Part(0.0, 0.3, "mapping SurfaceA to the orbifold"));
  const OrbifoldImage imageB =
    ImageOf("B", b, conesB, type, progress.Part(0.3, 0.6, "mapping SurfaceB to the orbifold"));
  const Eigen::MatrixXd positionsA = CollectUncutPositions(imageA, a.Points().rows());
  const Eigen::MatrixXd positionsB = CollectUncutPositions(imageB, b.Points().rows());
  OrbifoldMap map;
  map.AToB = OrbifoldLocator(imageB, ReachOf(imageA))
               .Find(positionsA, progress.Part(0.6, 0.8, "composing the maps"));
  map.BToA = OrbifoldLocator(imageA, ReachOf(imageB))
               .Find(positionsB, progress.Part(0.8, 1.0, "composing the maps"));
  return map;
}

} // namespace shape
