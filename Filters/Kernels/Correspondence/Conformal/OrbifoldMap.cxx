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

constexpr int LocatorGrain = 512;         // places
constexpr double Rounding = 1e-12; // tiles have the size 1

using Complex = std::complex<double>;

Mesh FlatMesh(const OrbifoldImage& image)
{
  Mesh flat{ Eigen::MatrixXd::Zero(image.Points.rows(), 3), image.Cut.Surface.Triangles };
  flat.Points.leftCols(2) = image.Points;
  return flat;
}

/// How far the image reaches from its tile's first cone.
double ReachOf(const OrbifoldImage& image)
{
  const Complex first = image.Tile.There.front();
  return (image.Points.rowwise() - Eigen::RowVector2d(first.real(), first.imag()))
    .rowwise()
    .norm()
    .maxCoeff();
}

/// Weights of corners but for rounding are none.
Eigen::RowVector3d Snapped(Eigen::RowVector3d barycentric)
{
  constexpr double least = 1e-9;
  barycentric = (barycentric.array() < least).select(0.0, barycentric);
  return barycentric / barycentric.sum();
}

OrbifoldImage ImageOf(const std::string& name, const Mesh& surface, const std::vector<int>& cones,
  OrbifoldType type, const Progress& progress)
{
  try
  {
    return OrbifoldTutte(surface, cones, type, progress);
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
  , Motions(OrbifoldMotions(
      this->Image.Tile, this->Image.Tile.There.front(), reach + ReachOf(this->Image)))
  , Flat(FlatMesh(this->Image))
{
}

PreciseMap OrbifoldLocator::Find(const Eigen::MatrixXd& places, const Progress& progress) const
{
  const Complex first = this->Image.Tile.There.front();
  for (Eigen::Index i = 0; i < places.rows(); ++i)
  {
    if (!(std::abs(Complex(places(i, 0), places(i, 1)) - first) <= this->Reach + Rounding))
    {
      throw InvalidInput("place " + std::to_string(i) + " is farther from the first cone than " +
        std::to_string(this->Reach) + "; give the locator a larger reach");
    }
  }
  const Eigen::RowVector2d low = this->Image.Points.colwise().minCoeff().array() - Rounding;
  const Eigen::RowVector2d high = this->Image.Points.colwise().maxCoeff().array() + Rounding;
  PreciseMap map{ Eigen::VectorXi(places.rows()), Eigen::MatrixXd(places.rows(), 3) };
  ParallelFor(
    static_cast<int>(places.rows()), LocatorGrain,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        ClosestPlace best;
        best.Barycentric.setZero();
        best.Position.setZero();
        best.Distance = std::numeric_limits<double>::infinity();
        for (const PlaneMotion& motion : this->Motions)
        {
          const Complex moved = motion(Complex(places(i, 0), places(i, 1)));
          const Eigen::RowVector3d place(moved.real(), moved.imag(), 0.0);
          if ((place.head<2>().array() < low.array()).any() ||
            (place.head<2>().array() > high.array()).any())
          {
            continue;
          }
          const ClosestPlace closest = this->Flat.FindOne(place, best.Triangle);
          best = closest.Distance < best.Distance ? closest : best;
          if (best.Distance <= Rounding)
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

Eigen::MatrixXd UncutPlaces(const OrbifoldImage& image, Eigen::Index points)
{
  // Copies come after all points.
  return image.Points.topRows(points);
}

OrbifoldMap MapThroughOrbifold(const Mesh& a, const std::vector<int>& conesA, const Mesh& b,
  const std::vector<int>& conesB, OrbifoldType type, const Progress& progress)
{
  const OrbifoldImage imageA = ImageOf("A", a, conesA, type, progress.Part(0.0, 0.3));
  const OrbifoldImage imageB = ImageOf("B", b, conesB, type, progress.Part(0.3, 0.6));
  const Eigen::MatrixXd placesA = UncutPlaces(imageA, a.Points.rows());
  const Eigen::MatrixXd placesB = UncutPlaces(imageB, b.Points.rows());
  OrbifoldMap map;
  map.AToB = OrbifoldLocator(imageB, ReachOf(imageA)).Find(placesA, progress.Part(0.6, 0.8));
  map.BToA = OrbifoldLocator(imageA, ReachOf(imageB)).Find(placesB, progress.Part(0.8, 1.0));
  return map;
}

} // namespace shape
