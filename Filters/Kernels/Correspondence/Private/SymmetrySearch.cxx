#include "Correspondence/Private/SymmetrySearch.h"

#include "Base/Errors.h"
#include "Correspondence/Private/SelfMaps.h"
#include "Geodesics/FarthestPoints.h"
#include "Geodesics/HeatGeodesics.h"
#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr int SampleCount = 100;
/// Lengths are relative to the root of the area. Two maps that take points this near each other are
/// one map; points nearer than this are one candidate.
constexpr double SameMap = 0.15, Neighbourhood = 0.1;
/// The largest root mean square difference of distances of a candidate, and the largest distortion
/// of a map of points to points. These have the errors of the points' spacing.
constexpr double CandidateError = 0.1, CoarseDistortion = 0.04;
/// Candidates are tried in the order of their error; these are enough for groups of order 64.
constexpr std::size_t MaximumCandidates = 4000;

/// Products may exceed the bound of symmetries by this factor.
constexpr double ProductFactor = 1.5;

using Triple = std::array<int, 3>;

/// Returns the distortion of true symmetries that the spacing of the points causes: linear
/// interpolation has errors of the square of the edges, or of the mean area of the triangles. On
/// 500, 1000 and 2000 points of an ellipsoid and of stars, the distortion is at most this and
/// 0.0007.
double FindSpacingError(const Surface& surface)
{
  return 3.0 / static_cast<double>(surface.Triangles().rows());
}

/// The distances of a surface, and what is derived from them.
class DistanceSpace
{
public:
  DistanceSpace(const Surface& surface, const Progress& progress)
    : Maps(surface, progress.Part(0.0, 0.4))
    , Triangles(surface.Triangles())
  {
    const Eigen::VectorXd areas = ComputePointAreas(surface);
    const auto count = static_cast<int>(areas.size());
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    const Eigen::MatrixXd distances = ComputeHeatDistances(surface, all, progress.Part(0.4, 1.0));
    this->Distances = (distances + distances.transpose()) / (2.0 * std::sqrt(areas.sum()));
    this->Samples =
      SampleFarthestPoints(surface, std::min(SampleCount, count), {}, FindRemotestPoint(surface));
    this->FindProfiles(areas / areas.sum());
  }

  Eigen::Index Count() const { return this->Distances.rows(); }

  /// The mean change of the distance of two samples under a map of the samples.
  double Distortion(const std::vector<int>& images) const
  {
    return (this->Distances(this->Samples, this->Samples) - this->Distances(images, images))
      .cwiseAbs()
      .mean();
  }

  /// The same for a map to positions on triangles.
  double Distortion(const SurfacePoints& map) const
  {
    const SurfacePoints images{ map.Triangles(this->Samples),
      map.Barycentrics(this->Samples, Eigen::all) };
    const Eigen::MatrixXd half = PullBack(images, this->Triangles, this->Distances),
                          both = PullBack(images, this->Triangles, half.transpose());
    return (this->Distances(this->Samples, this->Samples) - both).cwiseAbs().mean();
  }

  /// The mean distance of the images of the samples under two maps of all points.
  double Apart(const Eigen::VectorXi& one, const Eigen::VectorXi& two) const
  {
    double sum = 0.0;
    for (const int sample : this->Samples)
    {
      sum += this->Distances(one(sample), two(sample));
    }
    return sum / static_cast<double>(this->Samples.size());
  }

  /// Maps points to those with the most similar distances from the images of `from`.
  Eigen::VectorXi MapByDistances(
    const std::vector<int>& points, const std::vector<int>& from, const std::vector<int>& to) const
  {
    const auto wide = static_cast<double>(from.size());
    Eigen::MatrixXd queries(points.size(), from.size() + this->Profiles.cols()),
      rows(this->Count(), queries.cols());
    queries << this->Distances(points, from) / std::sqrt(wide), this->Profiles(points, Eigen::all);
    rows << this->Distances(Eigen::all, to) / std::sqrt(wide), this->Profiles;
    return FindNearestRows(queries, rows);
  }

  Eigen::MatrixXd Distances; ///< n x n
  Eigen::MatrixXd Profiles;  ///< n x q: |difference|^2 is the mean over the quantiles
  std::vector<int> Samples;
  SelfMaps Maps;
  Eigen::MatrixXi Triangles;

private:
  /// The quantiles of the distances from each point, by area: a symmetry keeps them.
  void FindProfiles(const Eigen::VectorXd& weights)
  {
    constexpr int quantiles = 12;
    this->Profiles.resize(this->Count(), quantiles);
    std::vector<int> order(this->Count());
    std::iota(order.begin(), order.end(), 0);
    for (Eigen::Index point = 0; point < this->Count(); ++point)
    {
      const auto distances = this->Distances.col(point);
      std::sort(order.begin(), order.end(),
        [&](int a, int b)
        { return std::make_pair(distances(a), a) < std::make_pair(distances(b), b); });
      double share = 0.0;
      int next = 0;
      for (const int other : order)
      {
        share += weights(other);
        while (next < quantiles && share >= (next + 1.0) / (quantiles + 1.0))
        {
          this->Profiles(point, next++) = distances(other) / std::sqrt(double(quantiles));
        }
      }
    }
  }
};

/// Returns three points from which the distances of any two samples differ as much as possible. The
/// first has the most uncommon distances, so that few points are like it.
Triple ChooseTriple(const DistanceSpace& space)
{
  const std::vector<int>& samples = space.Samples;
  const auto count = static_cast<int>(samples.size());
  Eigen::VectorXd likes(count);
  for (int i = 0; i < count; ++i)
  {
    const Eigen::VectorXd apart =
      (space.Profiles.rowwise() - space.Profiles.row(samples[i])).rowwise().squaredNorm();
    likes(i) = (-apart / (0.02 * 0.02)).array().exp().sum();
  }
  int first = 0;
  likes.minCoeff(&first);
  std::vector<std::pair<int, int>> pairs; // of samples that a map must tell apart
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      if (space.Distances(samples[i], samples[j]) > 2.0 * Neighbourhood)
      {
        pairs.emplace_back(samples[i], samples[j]);
      }
    }
  }
  const auto difference = [&](int from, const std::pair<int, int>& pair)
  { return std::abs(space.Distances(from, pair.first) - space.Distances(from, pair.second)); };
  Eigen::MatrixXd differences(pairs.size(), count);
  for (int i = 0; i < count; ++i)
  {
    for (std::size_t p = 0; p < pairs.size(); ++p)
    {
      differences(p, i) = difference(samples[i], pairs[p]);
    }
  }
  Triple best{ samples[first], samples[0], samples[1] };
  double found = -1.0;
  // The first 40 samples are spread over the surface.
  const int tried = std::min(count, 40);
  for (int i = 0; i < tried; ++i)
  {
    const Eigen::VectorXd both = differences.col(first).cwiseMax(differences.col(i));
    for (int j = 0; j < i; ++j)
    {
      const double worst = both.cwiseMax(differences.col(j)).minCoeff();
      if (worst > found)
      {
        found = worst;
        best = { samples[first], samples[i], samples[j] };
      }
    }
  }
  return best;
}

/// Returns the points where `errors` is smaller than at all points nearby, and small.
std::vector<int> FindMinima(const DistanceSpace& space, const Eigen::VectorXd& errors)
{
  std::vector<int> minima;
  for (int point = 0; point < static_cast<int>(errors.size()); ++point)
  {
    if (errors(point) > CandidateError * CandidateError)
    {
      continue;
    }
    bool smallest = true;
    for (int other = 0; other < static_cast<int>(errors.size()) && smallest; ++other)
    {
      smallest = space.Distances(point, other) > Neighbourhood ||
        std::make_pair(errors(point), point) <= std::make_pair(errors(other), other);
    }
    if (smallest)
    {
      minima.push_back(point);
    }
  }
  return minima;
}

/// Returns the triples that are as far apart as `base`, those with the smallest errors first.
std::vector<Triple> FindCandidates(
  const DistanceSpace& space, const Triple& base, const Progress& progress)
{
  const auto profile = [&](int i) -> Eigen::VectorXd
  { return (space.Profiles.rowwise() - space.Profiles.row(base[i])).rowwise().squaredNorm(); };
  const auto distance = [&](int image, int i, int j) -> Eigen::VectorXd
  { return (space.Distances.col(image).array() - space.Distances(base[i], base[j])).square(); };
  std::vector<std::pair<double, Triple>> found;
  const Eigen::VectorXd errors = profile(0);
  const std::vector<int> firsts = FindMinima(space, errors);
  for (std::size_t at = 0; at < firsts.size(); ++at)
  {
    progress(static_cast<double>(at) / static_cast<double>(firsts.size()));
    const int first = firsts[at];
    const Eigen::VectorXd ofSecond = profile(1) + distance(first, 0, 1);
    for (const int second : FindMinima(space, ofSecond))
    {
      const Eigen::VectorXd ofThird =
        profile(2) + 0.5 * (distance(first, 0, 2) + distance(second, 1, 2));
      for (const int third : FindMinima(space, ofThird))
      {
        found.push_back(
          { errors(first) + ofSecond(second) + ofThird(third), { first, second, third } });
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), MaximumCandidates));
  std::vector<Triple> triples;
  for (const auto& [error, triple] : found)
  {
    triples.push_back(triple);
  }
  return triples;
}

/// Fits a map to the eigenfunctions, beginning with the images of many points. More eigenfunctions
/// than these few distort more, if the map is a symmetry: they have errors of the points' spacing.
PointSymmetry FitEigenfunctions(
  const DistanceSpace& space, const std::vector<int>& from, const std::vector<int>& to)
{
  const SurfacePoints map = space.Maps.Fit(from, to);
  return { FindNearestCorners(map, space.Triangles), space.Distortion(map) };
}

/// Fits a map to 12, 25, 50 and all samples, beginning with the images of three points, and then to
/// the eigenfunctions. A map that distorts too much on the way to these has no images.
PointSymmetry FitSymmetry(const DistanceSpace& space, const Triple& base, const Triple& triple)
{
  const std::vector<int>& samples = space.Samples;
  std::vector<int> from(base.begin(), base.end()), to(triple.begin(), triple.end());
  for (const std::size_t wanted : { 12, 25, 50, SampleCount })
  {
    const Eigen::VectorXi images = space.MapByDistances(samples, from, to);
    const double distortion = space.Distortion(std::vector<int>(images.begin(), images.end()));
    if (distortion > (wanted == 12 ? CandidateError : CoarseDistortion))
    {
      return { {}, distortion };
    }
    const std::size_t count = std::min(wanted, samples.size());
    from.assign(samples.begin(), samples.begin() + count);
    to.assign(images.begin(), images.begin() + count);
  }
  return FitEigenfunctions(space, from, to);
}

/// Returns how far the images of a triple are from another triple, at most.
double FindFarthest(
  const DistanceSpace& space, const PointSymmetry& map, const Triple& base, const Triple& triple)
{
  double farthest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    farthest = std::max(farthest, space.Distances(map.Images(base[k]), triple[k]));
  }
  return farthest;
}

/// A group that grows: each new element brings its products with those that are there.
class Group
{
public:
  Group(const DistanceSpace& space, double bound, int maximum)
    : Space(space)
    , Bound(bound)
    , Maximum(maximum)
  {
    const auto count = static_cast<int>(space.Count());
    this->Elements.push_back({ Eigen::VectorXi::LinSpaced(count, 0, count - 1), 0.0 });
  }

  /// Returns the nearest element to a map, and how far apart they are.
  std::pair<int, double> Nearest(const Eigen::VectorXi& images) const
  {
    std::pair<int, double> nearest(0, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < this->Elements.size(); ++i)
    {
      const double apart = this->Space.Apart(this->Elements[i].Images, images);
      if (apart < nearest.second)
      {
        nearest = { static_cast<int>(i), apart };
      }
    }
    return nearest;
  }

  bool Has(const Eigen::VectorXi& images) const { return this->Nearest(images).second < SameMap; }

  /// Returns whether an element takes the base triple near this one.
  bool Covers(const Triple& base, const Triple& triple) const
  {
    return std::any_of(this->Elements.begin(), this->Elements.end(),
      [&](const PointSymmetry& element)
      { return FindFarthest(this->Space, element, base, triple) < SameMap; });
  }

  /// Adds a symmetry and all products. If a product distorts too much, the map was none: nothing is
  /// added, and the distortion of the product is returned; otherwise 0.
  double Add(const PointSymmetry& symmetry, const Progress& progress)
  {
    const std::size_t before = this->Elements.size();
    const Eigen::VectorXi identity = this->Elements.front().Images;
    const std::vector<int> all(identity.begin(), identity.end());
    this->Elements.push_back(symmetry);
    this->Generators.push_back(static_cast<int>(before));
    for (std::size_t i = 0; i < this->Elements.size(); ++i)
    {
      progress(0.5);
      for (const int generator : this->Generators)
      {
        const Eigen::VectorXi product = this->Product(static_cast<int>(i), generator);
        if (this->Has(product))
        {
          continue;
        }
        PointSymmetry refined =
          FitEigenfunctions(this->Space, all, { product.begin(), product.end() });
        if (refined.Distortion > ProductFactor * this->Bound)
        {
          this->Elements.resize(before);
          this->Generators.pop_back();
          return refined.Distortion;
        }
        if (!this->Has(refined.Images))
        {
          this->Elements.push_back(std::move(refined));
        }
        if (static_cast<int>(this->Elements.size()) > this->Maximum)
        {
          throw SolveFailure("the surface has more than " + std::to_string(this->Maximum) +
            " symmetries, or is round; raise MaximumOrder, or lower Tolerance");
        }
      }
    }
    return 0.0;
  }

  Eigen::VectorXi Product(int i, int j) const
  {
    return this->Elements[i].Images(this->Elements[j].Images);
  }

  std::vector<PointSymmetry> Elements;
  std::vector<int> Generators;

private:
  const DistanceSpace& Space;
  double Bound;
  int Maximum;
};

} // namespace

PointSymmetries FindPointSymmetries(
  const Surface& surface, double tolerance, int maximumOrder, const Progress& progress)
{
  const DistanceSpace space(surface, progress.Part(0.0, 0.3, "computing distances"));
  const Triple base = ChooseTriple(space);
  const std::vector<Triple> candidates =
    FindCandidates(space, base, progress.Part(0.3, 0.5, "searching for symmetries"));
  const Progress part = progress.Part(0.5, 1.0, "searching for symmetries");
  PointSymmetries result;
  result.Bound = tolerance + FindSpacingError(surface);
  Group group(space, result.Bound, maximumOrder);
  std::vector<PointSymmetry> rejected; // candidates near these would become the same maps
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    part(static_cast<double>(i) / static_cast<double>(candidates.size()));
    if (group.Covers(base, candidates[i]) ||
      std::any_of(rejected.begin(), rejected.end(),
        [&](const PointSymmetry& map)
        { return FindFarthest(space, map, base, candidates[i]) < Neighbourhood; }))
    {
      continue;
    }
    const PointSymmetry found = FitSymmetry(space, base, candidates[i]);
    if (found.Images.size() > 0 && group.Has(found.Images))
    {
      continue;
    }
    double distortion = found.Distortion;
    if (distortion <= result.Bound)
    {
      distortion = group.Add(found, {});
    }
    if (distortion > 0.0)
    {
      result.Rejected = std::min(result.Rejected, distortion);
      if (found.Images.size() > 0)
      {
        rejected.push_back(found);
      }
    }
  }
  const auto order = static_cast<int>(group.Elements.size());
  result.Composition.resize(order, order);
  for (int i = 0; i < order; ++i)
  {
    std::vector<int> times(order, 0);
    for (int j = 0; j < order; ++j)
    {
      result.Composition(i, j) = group.Nearest(group.Product(i, j)).first;
      ++times[result.Composition(i, j)];
    }
    if (*std::max_element(times.begin(), times.end()) > 1)
    {
      throw SolveFailure("the " + std::to_string(order) +
        " symmetries that were found are no group, as on surfaces that are nearly round; lower "
        "Tolerance, or raise SearchPoints");
    }
  }
  result.Elements = std::move(group.Elements);
  result.Generators = std::move(group.Generators);
  return result;
}

} // namespace shape
