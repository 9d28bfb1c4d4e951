#include "Correspondence/Conformal/HyperbolicMap.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Parameterize/OrbifoldInput.h"
#include "Search/NearestSurfacePoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <random>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// The isometries of an orbifold's group that walks meet, each found once. Products are looked up,
/// so that rounding does not accumulate.
class OrbifoldGroup
{
public:
  explicit OrbifoldGroup(const std::vector<HyperbolicMotion>& legs)
  {
    this->Elements.emplace_back(HyperbolicMotion::Identity());
    for (const HyperbolicMotion& leg : legs)
    {
      this->Elements.push_back(leg);
      this->Elements.emplace_back(InvertHyperbolic(leg));
    }
  }

  const HyperbolicMotion& operator[](int element) const { return this->Elements[element]; }

  /// Returns the isometry from a triangle's tile to the tile of the triangle across a half-edge.
  /// cut: HyperbolicImage::Cuts there.
  static int Across(int cut) { return cut == 0 ? 0 : cut > 0 ? 2 * cut - 1 : -2 * cut; }

  /// Returns the composition that applies `second` first.
  int Compose(int first, int second)
  {
    if (first == 0 || second == 0)
    {
      return first + second;
    }
    const auto [known, isNew] = this->Products.try_emplace({ first, second }, -1);
    if (isNew)
    {
      known->second = this->Find(this->Elements[first] * this->Elements[second]);
    }
    return known->second;
  }

private:
  int Find(const HyperbolicMotion& motion)
  {
    constexpr double rounding = 1e-3; // different isometries of the group differ by far more
    const HyperbolicMotion inverse = InvertHyperbolic(motion);
    for (std::size_t i = 0; i < this->Elements.size(); ++i)
    {
      if ((inverse * this->Elements[i] - HyperbolicMotion::Identity()).cwiseAbs().maxCoeff() <
        rounding)
      {
        return static_cast<int>(i);
      }
    }
    this->Elements.push_back(motion);
    return static_cast<int>(this->Elements.size()) - 1;
  }

  std::vector<HyperbolicMotion> Elements;
  std::map<std::pair<int, int>, int> Products;
};

/// A place of a walk: a triangle, and the isometry that takes the goal's tile to the triangle's.
struct WalkPlace
{
  int Triangle = 0;
  int Motion = 0;
};

/// Walks through the triangles of a surface's image.
class OrbifoldWalk
{
public:
  OrbifoldWalk(const Surface& surface, const HyperbolicImage& image, OrbifoldGroup& group)
    : Twins(surface.Twins())
    , Image(image)
    , Group(group)
  {
  }

  /// Walks to the triangle that contains `goal`, a point of the hyperboloid, and returns its
  /// weights there.
  Eigen::RowVector3d Reach(WalkPlace& place, const Eigen::Vector3d& goal)
  {
    // Each step leaves the triangle across a side that separates it from the goal. If there are
    // two, it is either at random: a fixed choice could go around in circles (Devillers, Pion and
    // Teillaud, "Walking in a triangulation", 2002).
    const int maximum = 100 + static_cast<int>(this->Twins.size());
    WalkPlace best = place;
    Eigen::RowVector3d weights = Eigen::RowVector3d::Constant(-Infinity);
    for (int step = 0; step < maximum && weights.minCoeff() < -Rounding; ++step)
    {
      const Eigen::RowVector3d own =
        this->WeightsAt(place.Triangle, MoveHyperbolic(this->Group[place.Motion], goal));
      if (own.minCoeff() > weights.minCoeff())
      {
        weights = own;
        best = place;
      }
      int corner = static_cast<int>(this->Random() % 3);
      while (own(corner) >= -Rounding && own.minCoeff() < -Rounding)
      {
        corner = (corner + 1) % 3;
      }
      const int side = 3 * place.Triangle + (corner + 1) % 3; // opposite the corner
      place.Motion =
        this->Group.Compose(OrbifoldGroup::Across(this->Image.Cuts[side]), place.Motion);
      place.Triangle = this->Twins[side] / 3;
    }
    // Beside a triangle that is nearly too small for the digits of positions.
    constexpr double worst = 1e-3;
    if (!(weights.minCoeff() > -worst))
    {
      throw SolveFailure("no triangle of the image contains a point of the other image: triangles "
                         "are too small for double precision; put Landmarks on the ends of the "
                         "longest extremities");
    }
    place = best;
    weights = (weights.array() < Rounding).select(0.0, weights);
    return weights / weights.sum();
  }

private:
  /// Returns the weights of the corners on the hyperboloid whose combination is the position. A
  /// weight is negative if the geodesic through the other two corners separates the position from
  /// the corner.
  Eigen::RowVector3d WeightsAt(int triangle, const Eigen::Vector3d& position) const
  {
    const Eigen::RowVector3i corners = this->Image.Cut.Surface.Triangles.row(triangle);
    Eigen::Matrix3d from;
    for (int k = 0; k < 3; ++k)
    {
      from.col(k) = this->Image.Points.row(corners(k)).transpose() - position;
    }
    Eigen::RowVector3d weights;
    double height = 0.0; // of the combination; positive, as that of the position
    for (int k = 0; k < 3; ++k)
    {
      weights(k) = position.dot(from.col((k + 1) % 3).cross(from.col((k + 2) % 3)));
      height += weights(k) * this->Image.Points(corners(k), 2);
    }
    return weights * position(2) / height;
  }

  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  static constexpr double Rounding = 1e-9; // far above that of positions, far below what is visible

  const std::vector<int>& Twins;
  const HyperbolicImage& Image;
  OrbifoldGroup& Group;
  std::minstd_rand Random; // of the same seed in each run
};

int FindTriangleAt(const Eigen::MatrixXi& triangles, int point)
{
  for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
  {
    if ((triangles.row(t).array() == point).any())
    {
      return t;
    }
  }
  return -1;
}

/// Calls `work`, and puts the surface's name before its errors.
template <typename Work>
auto Named(const std::string& name, const Work& work)
{
  try
  {
    return work();
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

/// Distances between landmarks along the surface, from the first columns of EmbedByLandmarks.
Eigen::MatrixXd DistancesBetween(const Eigen::MatrixXd& embedding, const std::vector<int>& points)
{
  const Eigen::MatrixXd distances =
    embedding(points, Eigen::seqN(0, static_cast<Eigen::Index>(points.size())));
  return distances + distances.transpose();
}

/// Returns, for each point of a surface and each leg of a path on another one, a factor that grows
/// with the distance of the point from the leg in a common embedding. A path with these lengths
/// follows the other one.
Eigen::MatrixXd ComputeFactors(
  const Eigen::MatrixXd& embedding, const EdgePath& path, const Eigen::MatrixXd& embeddingOfPath)
{
  // Rows of corresponding points of bent shapes differ by about a hundredth.
  constexpr double scale = 0.03;
  Eigen::MatrixXd factors(embedding.rows(), static_cast<Eigen::Index>(path.Stops.size()) - 1);
  for (Eigen::Index leg = 0; leg < factors.cols(); ++leg)
  {
    const std::vector<int> points(
      path.Points.begin() + path.Stops[leg], path.Points.begin() + path.Stops[leg + 1] + 1);
    const Eigen::MatrixXd along = embeddingOfPath(points, Eigen::all);
    const Eigen::VectorXi nearest = FindNearestRows(embedding, along);
    factors.col(leg) = 1.0 +
      (embedding - along(nearest, Eigen::all)).rowwise().squaredNorm().array() / (scale * scale);
  }
  return factors;
}

} // namespace

SurfacePoints MapBetweenHyperbolicImages(const Surface& surfaceA, const HyperbolicImage& a,
  const Surface& surfaceB, const HyperbolicImage& b, const Progress& progress)
{
  const Eigen::MatrixXi &triangles = surfaceA.Triangles(), &cut = a.Cut.Surface.Triangles;
  const std::vector<int>& twins = surfaceA.Twins();
  OrbifoldGroup group(a.Tile.Legs);
  OrbifoldWalk walk(surfaceB, b, group);
  SurfacePoints map{ Eigen::VectorXi::Constant(surfaceA.Points().rows(), -1),
    Eigen::MatrixXd(surfaceA.Points().rows(), 3) };
  // For each triangle of A that is reached, a place near it on B.
  std::vector<WalkPlace> places(triangles.rows(), { -1, 0 });
  std::queue<int> reached;
  const int first = FindTriangleAt(triangles, a.Cones.front());
  places[first].Triangle = FindTriangleAt(surfaceB.Triangles(), b.Cones.front());
  reached.push(first);
  constexpr int often = 1 << 12; // triangles between reports
  for (int done = 0; !reached.empty(); ++done)
  {
    if (done % often == 0)
    {
      progress(static_cast<double>(done) / static_cast<double>(triangles.rows()));
    }
    const int t = reached.front();
    reached.pop();
    WalkPlace place = places[t];
    for (int k = 0; k < 3; ++k)
    {
      const int point = triangles(t, k);
      if (map.Triangles(point) < 0)
      {
        map.Barycentrics.row(point) = walk.Reach(place, a.Points.row(cut(t, k)));
        map.Triangles(point) = place.Triangle;
      }
    }
    for (int side = 3 * t; side < 3 * t + 3; ++side)
    {
      WalkPlace& next = places[twins[side] / 3];
      if (next.Triangle < 0)
      {
        // From the other triangle's tile, over this one's, to B.
        next = { place.Triangle,
          group.Compose(place.Motion, OrbifoldGroup::Across(a.Cuts[twins[side]])) };
        reached.push(twins[side] / 3);
      }
    }
  }
  // Cones correspond, but a walk may end beside one by rounding.
  const SurfacePoints cones = MakeSurfacePointsAtVertices(
    Eigen::Map<const Eigen::VectorXi>(b.Cones.data(), static_cast<Eigen::Index>(b.Cones.size())),
    surfaceB);
  map.Triangles(a.Cones) = cones.Triangles;
  map.Barycentrics(a.Cones, Eigen::all) = cones.Barycentrics;
  progress(1.0);
  return map;
}

SurfaceMaps MapThroughHyperbolicOrbifold(const Surface& a, const std::vector<int>& conesA,
  const Surface& b, const std::vector<int>& conesB, const Progress& progress)
{
  const auto alike = [&](const std::string& name, const Surface& surface,
                       const std::vector<int>& cones, const Progress& part)
  {
    return Named(name,
      [&]
      {
        RequireOrbifoldInput(surface, cones);
        return EmbedByLandmarks(surface, cones, part);
      });
  };
  const Eigen::MatrixXd alikeA =
                          alike("A", a, conesA, progress.Part(0.0, 0.05, "ordering the landmarks")),
                        alikeB = alike("B", b, conesB, progress.Part(0.05, 0.1));
  const std::vector<int> order =
    FindShortestOrder(DistancesBetween(alikeA, conesA) + DistancesBetween(alikeB, conesB));
  std::vector<int> orderedA, orderedB;
  for (const int i : order)
  {
    orderedA.push_back(conesA[i]);
    orderedB.push_back(conesB[i]);
  }
  const Progress cutting = progress.Part(0.1, 0.15, "cutting the surfaces");
  const EdgePath pathA = Named(
                   "A", [&] { return FindEdgePathThrough(a, orderedA, cutting.Part(0.0, 0.4)); }),
                 pathB = Named("B",
                   [&]
                   {
                     return FindEdgePathThrough(
                       b, orderedB, cutting.Part(0.6, 1.0), ComputeFactors(alikeB, pathA, alikeA));
                   });
  const HyperbolicImage imageA = Named("A",
                          [&] {
                            return MapToHyperbolicOrbifold(
                              a, pathA, progress.Part(0.15, 0.5, "mapping SurfaceA"));
                          }),
                        imageB = Named("B",
                          [&] {
                            return MapToHyperbolicOrbifold(
                              b, pathB, progress.Part(0.5, 0.9, "mapping SurfaceB"));
                          });
  return { MapBetweenHyperbolicImages(
             a, imageA, b, imageB, progress.Part(0.9, 0.95, "composing the maps")),
    MapBetweenHyperbolicImages(b, imageB, a, imageA, progress.Part(0.95, 1.0)) };
}

std::vector<int> FindShortestOrder(const Eigen::MatrixXd& distances)
{
  const auto count = static_cast<int>(distances.rows());
  const auto lengthOf = [&](const std::vector<int>& order)
  {
    double length = 0.0;
    for (int i = 1; i < count; ++i)
    {
      length += distances(order[i - 1], order[i]);
    }
    return length;
  };
  constexpr double rounding = 1e-9; // relative
  std::vector<int> best;
  double shortest = std::numeric_limits<double>::infinity();
  for (int start = 0; start < count; ++start)
  {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::swap(order[0], order[start]);
    for (int i = 1; i < count; ++i)
    {
      std::iter_swap(order.begin() + i,
        std::min_element(order.begin() + i, order.end(),
          [&](int p, int q) { return distances(order[i - 1], p) < distances(order[i - 1], q); }));
    }
    double length = lengthOf(order);
    for (bool isBetter = true; isBetter;)
    {
      isBetter = false;
      for (int i = 0; i < count; ++i)
      {
        for (int j = 0; j < count; ++j)
        {
          // Reverse a stretch, or move one point elsewhere.
          std::vector<int> other = order;
          if (i < j)
          {
            std::reverse(other.begin() + i, other.begin() + j + 1);
          }
          else
          {
            std::rotate(other.begin() + j, other.begin() + i, other.begin() + i + 1);
          }
          const double changed = lengthOf(other);
          if (changed < length * (1.0 - rounding))
          {
            order = std::move(other);
            length = changed;
            isBetter = true;
          }
        }
      }
    }
    if (length < shortest * (1.0 - rounding))
    {
      shortest = length;
      best = std::move(order);
    }
  }
  // Either direction is as short; the shorter one of the two outer legs comes first.
  if (count > 1 && distances(best[0], best[1]) > distances(best[count - 2], best[count - 1]))
  {
    std::reverse(best.begin(), best.end());
  }
  return best;
}

} // namespace shape
