#include "Volume/InverseMap.h"

#include "Core/Errors.h"
#include "Core/Parallel.h"
#include "Volume/InverseSearch.h"
#include "Volume/OutsideDomain.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

using Indices = std::vector<int>;

/// The nearest of `places` (k x 3, k > 0) to each point: its row.
Eigen::VectorXi Nearest(
  const Eigen::MatrixXd& places, const Eigen::MatrixXd& points, const Progress& progress)
{
  Eigen::VectorXi nearest(points.rows());
  ParallelFor(
    static_cast<int>(points.rows()), 64,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        (places.rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff(&nearest(i));
      }
    },
    progress);
  return nearest;
}

/// The points of a lattice over the domain's box that lie inside.
Eigen::MatrixXd SeedsIn(const SignedDistance& domain, int across, const Progress& progress)
{
  const Eigen::MatrixXd& points = domain.Locator().Surface().Points;
  const Eigen::RowVector3d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  const double spacing = LongestSide(points) / across;
  const Eigen::RowVector3i counts = ((high - low) / spacing).array().ceil().max(1.0).cast<int>();
  Eigen::MatrixXd lattice(counts.prod(), 3);
  for (int i = 0; i < lattice.rows(); ++i)
  {
    const Eigen::RowVector3d place(
      i % counts(0), i / counts(0) % counts(1), i / (counts(0) * counts(1)));
    lattice.row(i) =
      low.array() + (place.array() + 0.5) * (high - low).array() / counts.cast<double>().array();
  }
  const Eigen::VectorXd distances = domain.Evaluate(lattice, progress).Distances;
  Indices inside;
  for (int i = 0; i < distances.size(); ++i)
  {
    if (distances(i) < 0.0)
    {
      inside.push_back(i);
    }
  }
  return lattice(inside, Eigen::all);
}

Mesh ImageOf(const ChargeSet& map, const Mesh& domain, const Progress& progress)
{
  Mesh image{ Evaluate(map, domain.Points, progress), domain.Triangles };
  if (!image.Points.allFinite())
  {
    throw InvalidInput("the map is not finite at a point of the surface that bounds its domain; "
                       "move the charges away from it");
  }
  return FacingOutwards(std::move(image));
}

} // namespace

InverseMap::InverseMap(const ChargeSet& map, const Mesh& domain, double farthest,
  const InverseMapOptions& options, const Progress& progress)
  : Map(map)
  , Options(options)
  , Farthest(farthest)
  , Domain(FacingOutwards(domain))
  , Image(ImageOf(map, domain, progress.Part(0.0, 0.2)))
{
  if (!(options.Tolerance > 0.0) || options.MaximumIterations < 1 || options.SeedsAcross < 1)
  {
    throw InvalidInput("an option of the inverse map is out of range; Tolerance must be greater "
                       "than 0, MaximumIterations and SeedsAcross at least 1");
  }
  this->Seeds = SeedsIn(this->Domain, options.SeedsAcross, progress.Part(0.2, 0.4));
  this->SeedImages = Evaluate(map, this->Seeds, progress.Part(0.4, 0.6));
  Eigen::MatrixXd sampled(this->Seeds.rows() + domain.Points.rows(), 3);
  sampled << this->Seeds, domain.Points;
  const Eigen::MatrixXd jacobians = Jacobians(map, sampled, progress.Part(0.6, 1.0));
  int positive = 0, negative = 0;
  for (Eigen::Index i = 0; i < jacobians.rows(); ++i)
  {
    const double determinant = Square(jacobians, i).determinant();
    positive += determinant > 0.0;
    negative += determinant < 0.0;
  }
  this->DeterminantChangesSign = std::max(positive, negative) < jacobians.rows();
}

InverseMap::Result InverseMap::Find(const Eigen::MatrixXd& points, const Progress& progress) const
{
  const Mesh& image = this->Image.Locator().Surface();
  const SignedDistance::Result at = this->Image.Evaluate(points, progress.Part(0.0, 0.15));
  const Eigen::VectorXd tolerances =
    DomainTolerances(image, at.Closest, std::numeric_limits<double>::infinity());
  Result result{ points,
    Eigen::VectorXi::Constant(points.rows(), static_cast<int>(State::Outside)) };
  Indices open;
  for (int i = 0; i < points.rows(); ++i)
  {
    if (this->DeterminantChangesSign || at.Distances(i) <= tolerances(i))
    {
      open.push_back(i);
    }
  }

  // The image's triangles are the domain's: a place on the one is a place on the other.
  const Eigen::MatrixXd onBoundary =
    Interpolate(image.Triangles, this->Domain.Locator().Surface().Points, at.Closest);
  const bool seeded = this->Seeds.rows() > 0;
  Eigen::MatrixXd inner = onBoundary, starts = onBoundary;
  if (seeded)
  {
    const Eigen::VectorXi nearest = Nearest(this->SeedImages, points, progress.Part(0.15, 0.2));
    inner = this->Seeds(nearest, Eigen::all);
    for (int i = 0; i < points.rows(); ++i)
    {
      if ((this->SeedImages.row(nearest(i)) - points.row(i)).norm() < std::abs(at.Distances(i)))
      {
        starts.row(i) = inner.row(i);
      }
    }
  }

  const Limits limits{ this->Options.Tolerance * LongestSide(image.Points),
    0.25 * LongestSide(this->Domain.Locator().Surface().Points), this->Options.MaximumIterations };
  Steps steps(progress.Part(0.2, 1.0));
  for (int attempt = 0; attempt < (seeded ? 3 : 2) && !open.empty(); ++attempt)
  {
    const Eigen::MatrixXd targets = points(open, Eigen::all);
    Search search;
    if (attempt == 0)
    {
      search = StartAt(this->Map, starts(open, Eigen::all), targets, steps.Next());
      Newton(this->Map, search, limits, steps);
    }
    else
    {
      search = Walk(
        this->Map, (attempt == 1 ? onBoundary : inner)(open, Eigen::all), targets, limits, steps);
    }
    const Eigen::VectorXi outside =
      OutsideDomain(this->Domain, search.Places, this->Farthest, steps.Next());
    Indices left;
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      const int id = open[i];
      const bool solved = search.Misses(i) <= limits.Goal;
      if (solved && !outside(i))
      {
        result.Points.row(id) = search.Places.row(i);
        result.States(id) = static_cast<int>(State::Found);
      }
      // Near the boundary of an image without folds, the one preimage lies outside: no other start
      // would find a better one.
      else if (!solved || this->DeterminantChangesSign || at.Distances(id) < -tolerances(id))
      {
        left.push_back(id);
      }
    }
    open = std::move(left);
  }
  for (const int i : open)
  {
    if (at.Distances(i) < -tolerances(i))
    {
      result.States(i) = static_cast<int>(State::Missed);
    }
  }
  return result;
}

} // namespace shape
