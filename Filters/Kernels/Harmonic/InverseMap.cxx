#include "Harmonic/InverseMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Harmonic/Private/InverseSearch.h"
#include "Mesh/Extent.h"
#include "Solids/Nesting.h"

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

/// Maximum number of seeds tried for one point, nearest first.
constexpr int MaximumStarts = 12;

/// Returns the rows of the `count` positions (k x 3) closest to each point, nearest first:
/// n x min(count, k).
Eigen::MatrixXi Nearest(const Eigen::MatrixXd& positions, const Eigen::MatrixXd& points, int count,
  const Progress& progress)
{
  const auto k = static_cast<int>(positions.rows());
  Eigen::MatrixXi nearest(points.rows(), std::min(count, k));
  ParallelFor(
    static_cast<int>(points.rows()), 64,
    [&](int begin, int end)
    {
      std::vector<std::pair<double, int>> byDistance(k);
      for (int i = begin; i < end; ++i)
      {
        for (int j = 0; j < k; ++j)
        {
          byDistance[j] = { (positions.row(j) - points.row(i)).squaredNorm(), j };
        }
        std::partial_sort(
          byDistance.begin(), byDistance.begin() + nearest.cols(), byDistance.end());
        for (Eigen::Index c = 0; c < nearest.cols(); ++c)
        {
          nearest(i, c) = byDistance[c].second;
        }
      }
    },
    progress);
  return nearest;
}

/// Returns the points of a lattice over the domain's box that lie inside the domain.
Eigen::MatrixXd SeedsIn(const SignedDistance& domain, int across, const Progress& progress)
{
  const Eigen::AlignedBox3d box = ComputeBox(domain.GetSurface());
  const Eigen::RowVector3d low = box.min(), high = box.max();
  const double spacing = box.sizes().maxCoeff() / across;
  const Eigen::RowVector3i counts = ((high - low) / spacing).array().ceil().max(1.0).cast<int>();
  Eigen::MatrixXd lattice(counts.prod(), 3);
  for (int i = 0; i < lattice.rows(); ++i)
  {
    const Eigen::RowVector3d position(
      i % counts(0), i / counts(0) % counts(1), i / (counts(0) * counts(1)));
    // The centres of the cells.
    lattice.row(i) =
      low.array() + (position.array() + 0.5) * (high - low).array() / counts.cast<double>().array();
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

/// A point may lie this many tolerances outside the image's boundary and still have a preimage
/// within the tolerance of the domain.
constexpr double MaximumStretch = 4.0;

Mesh ImageOf(const ChargeSet& map, const Surface& domain, const Progress& progress)
{
  Mesh image{ Evaluate(map, domain.Points(), progress), domain.Triangles() };
  if (!image.Points.allFinite())
  {
    throw InvalidInput("the map is not finite at a point of the surface that bounds its domain; "
                       "move the charges away from it");
  }
  return OrientOutwards(std::move(image));
}

} // namespace

InverseMap::InverseMap(const ChargeSet& map, const Surface& domain, double farthest,
  const InverseMapOptions& options, const Progress& progress)
  : Map(map)
  , Options(options)
  , Farthest(farthest)
  , Domain(OrientByNesting(domain, "the surface of the Map"))
  , Image(ImageOf(map, this->Domain.GetSurface(), progress.Part(0.0, 0.2)))
{
  if (!(options.Tolerance > 0.0) || options.MaximumIterations < 1 || options.SeedsAcross < 1)
  {
    throw InvalidInput("an option of the inverse map is out of range; Tolerance must be greater "
                       "than 0, MaximumIterations and SeedsAcross at least 1");
  }
  // Starts of Newton's method inside the domain, and their images.
  this->Seeds = SeedsIn(this->Domain, options.SeedsAcross, progress.Part(0.2, 0.4));
  this->SeedImages = Evaluate(map, this->Seeds, progress.Part(0.4, 0.6));
  // The sign of the derivative's determinant is compared at seeds and boundary positions. Maps fold
  // first at the boundary, also in the middle of long triangles.
  constexpr Eigen::Index wanted = 5000;
  const Eigen::MatrixXd onBoundary = SampleRandomly(
    domain, static_cast<int>(std::max(wanted - domain.Points().rows(), Eigen::Index(0))), 1);
  Eigen::MatrixXd sampled(this->Seeds.rows() + domain.Points().rows() + onBoundary.rows(), 3);
  sampled << this->Seeds, domain.Points(), onBoundary;
  const Eigen::MatrixXd jacobians = EvaluateJacobians(map, sampled, progress.Part(0.6, 1.0));
  int positive = 0, negative = 0;
  for (Eigen::Index i = 0; i < jacobians.rows(); ++i)
  {
    const double determinant = GetJacobian(jacobians, i).determinant();
    positive += determinant > 0.0;
    negative += determinant < 0.0;
  }
  this->DeterminantChangesSign = std::max(positive, negative) < jacobians.rows();
}

std::optional<Eigen::RowVector3d> InverseMap::Start(const Eigen::RowVector3d& point) const
{
  const Surface& image = this->Image.GetSurface();
  const SignedDistance::Result at = this->Image.Evaluate(point);
  const double tolerance =
    ComputeDomainTolerances(image, at.Closest, std::numeric_limits<double>::infinity())(0);
  if (!this->DeterminantChangesSign && at.Distances(0) > MaximumStretch * tolerance)
  {
    return {};
  }
  // The start is the boundary position or the seed whose image is nearest to the point.
  const Eigen::RowVector3d onBoundary =
    PullBack(at.Closest, image.Triangles(), this->Domain.GetSurface().Points());
  if (this->Seeds.rows() == 0)
  {
    return onBoundary;
  }
  Eigen::Index nearest = 0;
  const double distance2 =
    (this->SeedImages.rowwise() - point).rowwise().squaredNorm().minCoeff(&nearest);
  if (at.Distances(0) * at.Distances(0) <= distance2)
  {
    return onBoundary;
  }
  return this->Seeds.row(nearest);
}

InverseMap::Result InverseMap::Find(const Eigen::MatrixXd& points, const Progress& progress) const
{
  // Outline:
  // 1. A point outside the boundary's image is left out if the map has no folds.
  // 2. Starts: the boundary position whose image is closest to the point, and the seeds whose
  //    images are nearest.
  // 3. In each attempt Newton's method or continuation runs from the next start of all open points.
  // 4. A solution counts if it lies in the domain.
  // 5. Points that remain open are Missed if they lie inside the image, and Outside otherwise.
  const Surface& image = this->Image.GetSurface();
  // Step 1: which points can have a preimage.
  const SignedDistance::Result at = this->Image.Evaluate(points, progress.Part(0.0, 0.15));
  const Eigen::VectorXd tolerances =
    ComputeDomainTolerances(image, at.Closest, std::numeric_limits<double>::infinity());
  Result result{ points,
    Eigen::VectorXi::Constant(points.rows(), static_cast<int>(State::Outside)) };
  Indices open;
  for (int i = 0; i < points.rows(); ++i)
  {
    // The map may stretch the domain's tolerance, so this test is generous. Whether the preimage
    // that is found lies in the domain decides.
    if (this->DeterminantChangesSign || at.Distances(i) <= MaximumStretch * tolerances(i))
    {
      open.push_back(i);
    }
  }

  // The image has the domain's triangles, so triangle and barycentric coordinates carry over.
  const Eigen::MatrixXd onBoundary =
    PullBack(at.Closest, image.Triangles(), this->Domain.GetSurface().Points());
  const Eigen::MatrixXi nearest =
    Nearest(this->SeedImages, points, MaximumStarts, progress.Part(0.15, 0.2));
  // Attempt 0 takes the boundary position or the nearest seed, the one with the nearer image.
  // Attempts 2, 3, ... take the seeds in the order of their images' distances.
  const auto startOf = [&](int i, int attempt) -> Eigen::RowVector3d
  {
    const bool onIt = attempt == 0 &&
      (nearest.cols() == 0 ||
        std::abs(at.Distances(i)) <= (this->SeedImages.row(nearest(i, 0)) - points.row(i)).norm());
    return onIt ? onBoundary.row(i) : this->Seeds.row(nearest(i, std::max(0, attempt - 2)));
  };

  // Near a fold the derivative is almost singular and Newton's step almost unbounded: it is cut to
  // a quarter of the domain's longest side.
  const Limits limits{ this->Options.Tolerance * ComputeLongestBoxEdge(image),
    0.25 * ComputeLongestBoxEdge(this->Domain.GetSurface()), this->Options.MaximumIterations };
  // Step 3. Attempt 0 starts at the nearest start. Attempts 1 and 2 walk from the boundary and from
  // the nearest seed. The others start at further seeds, which may lie on the right side of a fold.
  const int attempts = 2 + static_cast<int>(nearest.cols());
  // outside the boundary's image: only folds map there, so walking on a straight line fails
  Indices beyond;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    const bool walks = attempt == 1 || attempt == 2;
    // Walks take many steps. The few points that they leave take the rest of the time.
    constexpr double ends[] = { 0.2, 0.35, 0.6, 0.8 };
    const auto endOf = [&](int done)
    { return done < 4 ? ends[done] : 0.8 + 0.2 * (done - 3.0) / (attempts - 3.0); };
    Steps steps(progress.Part(endOf(attempt), endOf(attempt + 1)), walks ? 0.01 : 0.1);
    if (attempt == 1)
    {
      const auto within = std::stable_partition(
        open.begin(), open.end(), [&](int i) { return at.Distances(i) <= tolerances(i); });
      beyond.assign(within, open.end());
      open.erase(within, open.end());
    }
    else if (attempt == 3)
    {
      open.insert(open.end(), beyond.begin(), beyond.end());
    }
    if (open.empty())
    {
      continue;
    }
    const Eigen::MatrixXd targets = points(open, Eigen::all);
    Eigen::MatrixXd starts = onBoundary(open, Eigen::all);
    for (std::size_t i = 0; i < open.size() && attempt != 1; ++i)
    {
      starts.row(i) = startOf(open[i], attempt);
    }
    Search search;
    if (walks)
    {
      search = WalkToTargets(this->Map, starts, targets, limits, steps);
    }
    else
    {
      search = StartSearch(this->Map, starts, targets, steps.Next());
      IterateNewton(this->Map, search, limits, steps);
    }
    // Step 4: solutions in the domain.
    const Eigen::VectorXi outside =
      FindPointsOutsideDomain(this->Domain, search.Positions, this->Farthest, steps.Next());
    Indices left;
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      const int id = open[i];
      const bool solved = search.Misses(i) <= limits.Goal;
      if (solved && !outside(i))
      {
        result.Points.row(id) = search.Positions.row(i);
        result.States(id) = static_cast<int>(State::Found);
      }
      // If an image has no folds and the only preimage lies just outside, no other start finds a
      // better one.
      else if (!solved || this->DeterminantChangesSign || at.Distances(id) < -tolerances(id))
      {
        left.push_back(id);
      }
    }
    open = std::move(left);
  }
  // Step 5: points without a preimage.
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
