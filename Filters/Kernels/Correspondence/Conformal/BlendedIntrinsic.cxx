#include "Correspondence/Conformal/BlendedIntrinsic.h"

#include "Base/Errors.h"
#include "Correspondence/Conformal/Private/MoebiusMap.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/FarthestPoints.h"
#include "Mesh/BoundaryLoops.h"
#include "Parameterize/SphereMap.h"
#include "Parameterize/SphericalTriangles.h"
#include "Search/ClosestPoint.h"
#include "Search/NearestSurfacePoints.h"
#include "Spectrum/Smacof.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// A surface on the sphere.
struct RoundSurface
{
  Mesh Sphere;               ///< with fans in the holes
  SphereMapMethod Method;    ///< the method that computed the map
  ComplexPoints Points;      ///< of the sphere
  Eigen::VectorXd LogScales; ///< log(area on the surface / area on the sphere) around each
  Eigen::MatrixXd Embedding; ///< n x d: straight distances are geodesic ones, for area 1
  Eigen::VectorXd Areas;     ///< of all points except those of the fans; the sum is 1
};

/// Returns whether the surface has a boundary.
bool RequireGenusZero(const Surface& surface, const std::string& name)
{
  const Topology topology = RequireConnected(surface, name);
  const int genus = ComputeGenus(topology);
  if (genus != 0)
  {
    throw InvalidInput(name + " has genus " + std::to_string(genus) +
      "; maps through the sphere need genus 0: cut each handle with Clip and close the cuts with "
      "Shape Fill Holes, or take another "
      "method");
  }
  return topology.BoundaryLoops > 0;
}

/// first: the method to try first.
/// The work for one surface: its conformal map to the sphere, the area scale of that map, and the
/// positions in which images are averaged.
RoundSurface MakeRound(const Surface& surface, SphereMapMethod first, const Progress& progress)
{
  RoundSurface round;
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  const Surface unit(surface.Points() / std::sqrt(areas.sum()), surface.Triangles());
  round.Areas = areas / areas.sum();
  const std::vector<std::vector<int>> loops = FindManifoldBoundaryLoops(unit);
  const Surface closed = FillWithFans(unit, loops);
  SphereMapOptions options;
  options.First = first;
  const SphereMapResult map = MapToSphere(closed, options, progress.Part(0.0, 0.6));
  round.Sphere = { map.Points, closed.Triangles() };
  round.Method = map.Method;
  round.Points = ToComplexPoints(round.Sphere.Points);
  const Eigen::VectorXd angles = ComputeSolidAngles(closed.Triangles(), round.Sphere.Points);
  Eigen::VectorXd onSphere = Eigen::VectorXd::Zero(closed.Points().rows());
  for (Eigen::Index t = 0; t < angles.size(); ++t)
  {
    // A point gets a third of each solid angle around it, as it gets a third of each triangle's
    // area.
    for (const int corner : closed.Triangles().row(t))
    {
      onSphere(corner) += angles(t) / 3.0;
    }
  }
  // A point without area has no logarithm; the limit keeps its scale finite.
  constexpr double tiny = 1e-300;
  round.LogScales =
    ComputePointAreas(closed).array().max(tiny).log() - onSphere.array().max(tiny).log();
  SmacofOptions scaling;
  scaling.Samples = 300;
  round.Embedding.setZero(closed.Points().rows(), scaling.Dimensions);
  round.Embedding.topRows(surface.Points().rows()) =
    EmbedBySmacof(unit, scaling, progress.Part(0.6, 1.0));
  // The centre of a fan is not on the surface; it is embedded at the mean of its loop.
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    round.Embedding.row(surface.Points().rows() + static_cast<Eigen::Index>(k)) =
      round.Embedding(loops[k], Eigen::all).colwise().mean();
  }
  return round;
}

/// The images of points under a conformal map, and the trust in the map there.
struct Images
{
  Eigen::MatrixXd Positions; ///< in the target's embedding
  Eigen::VectorXd Trust;     ///< in [0, 1]
};

Images ImagesOf(const RoundSurface& from, const std::vector<int>& points, const RoundSurface& to,
  const SurfaceLocator& locator, const Eigen::Matrix2cd& moebius)
{
  const ComplexPoints own = from.Points(points, Eigen::all);
  const ClosestPoints positions = locator.Find(ToSphere(ApplyMoebiusTransform(own, moebius)));
  // The map from A to B is: A to its sphere, the Moebius transform, B's sphere to B. The logarithms
  // of the three area scales add up.
  const Eigen::VectorXd scales = ComputeLogAreaScales(own, moebius) - from.LogScales(points) +
    PullBack(positions, to.Sphere.Triangles, to.LogScales);
  // An isometry has scale 1 and trust 1 / cosh(0) = 1.
  return { PullBack(positions, to.Sphere.Triangles, to.Embedding),
    scales.array().cosh().inverse() };
}

/// All triples of `count` landmarks, or evenly spread ones if there are too many.
/// Each generates one candidate map.
std::vector<std::vector<int>> Triples(int count)
{
  // 25 landmarks already have 2300 triples, and each map is evaluated at all samples.
  constexpr std::size_t maximum = 300;
  std::vector<std::vector<int>> all, some;
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 1; j < count; ++j)
    {
      for (int k = j + 1; k < count; ++k)
      {
        all.push_back({ i, j, k });
      }
    }
  }
  // A constant stride through the lexicographic order reaches all landmarks.
  const std::size_t stride = std::max<std::size_t>(1, (all.size() + maximum - 1) / maximum);
  for (std::size_t t = 0; t < all.size(); t += stride)
  {
    some.push_back(all[t]);
  }
  return some;
}

/// The Moebius maps of the triples of landmarks that are distinct on both spheres.
std::vector<Eigen::Matrix2cd> MapsOfTriples(
  const RoundSurface& a, const RoundSurface& b, const Landmarks& landmarks)
{
  const ComplexPoints onA = a.Points(PointsOf(landmarks, 0), Eigen::all),
                      onB = b.Points(PointsOf(landmarks, 1), Eigen::all);
  std::vector<Eigen::Matrix2cd> maps;
  for (const std::vector<int>& triple : Triples(static_cast<int>(landmarks.size())))
  {
    const Eigen::Matrix2cd moebius =
      SolveMoebiusTransform(onA(triple, Eigen::all), onB(triple, Eigen::all));
    if (moebius.allFinite())
    {
      maps.push_back(moebius);
    }
  }
  return maps;
}

/// The leading eigenvector of the agreements between maps, which has no negative entries.
/// By Perron and Frobenius: the matrix has no negative entry. The sign that the solver returns is
/// arbitrary, hence the absolute values (section 4 of the paper).
Eigen::VectorXd WeightsOf(
  const std::vector<Images>& images, const Eigen::VectorXd& areas, double agreement)
{
  const auto count = static_cast<Eigen::Index>(images.size());
  Eigen::MatrixXd agreements(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const Eigen::ArrayXd near =
        (-(images[i].Positions - images[j].Positions).rowwise().squaredNorm().array() /
          (agreement * agreement))
          .exp();
      agreements(i, j) = agreements(j, i) =
        (areas.array() * images[i].Trust.array() * images[j].Trust.array() * near).sum();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pairs(agreements);
  return pairs.eigenvectors().rightCols(1).cwiseAbs();
}

/// The maps that agree best at samples, with their weights.
struct Blend
{
  std::vector<Eigen::Matrix2cd> Maps;
  Eigen::VectorXd Weights;
};

/// Second step of the paper, section 4: the agreement of all candidates, each with all others, and
/// their weights.
Blend Choose(const RoundSurface& a, const RoundSurface& b, const SurfaceLocator& locator,
  const std::vector<Eigen::Matrix2cd>& maps, const std::vector<int>& samples,
  const BlendedIntrinsicOptions& options, const Progress& progress)
{
  std::vector<Images> images;
  for (const Eigen::Matrix2cd& moebius : maps)
  {
    progress(static_cast<double>(images.size()) / static_cast<double>(maps.size()));
    images.push_back(ImagesOf(a, samples, b, locator, moebius));
  }
  // Farthest-point samples are evenly spread, so each represents the same area.
  const Eigen::VectorXd areas =
    Eigen::VectorXd::Constant(static_cast<Eigen::Index>(samples.size()), 1.0 / samples.size());
  const Eigen::VectorXd weights = WeightsOf(images, areas, options.Agreement);
  std::vector<int> order(maps.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int i, int j) { return weights(i) > weights(j); });
  order.resize(std::min<std::size_t>(order.size(), options.Candidates));
  Blend blend;
  for (const int k : order)
  {
    blend.Maps.push_back(maps[k]);
  }
  blend.Weights = weights(order);
  return blend;
}

/// The positions nearest to the mean images of all points.
/// Third step of the paper, section 5: the blend. Only the trust varies from point to point.
SurfacePoints Blended(const RoundSurface& from, const RoundSurface& to, const Surface& target,
  const SurfaceLocator& locator, const Blend& blend, const Progress& progress)
{
  std::vector<int> points(from.Areas.size());
  std::iota(points.begin(), points.end(), 0);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(from.Areas.size(), to.Embedding.cols());
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(from.Areas.size());
  for (std::size_t k = 0; k < blend.Maps.size(); ++k)
  {
    progress(0.7 * static_cast<double>(k) / static_cast<double>(blend.Maps.size()));
    // One map at a time: storing the images under all maps would need memory for 60 embeddings.
    const Images images = ImagesOf(from, points, to, locator, blend.Maps[k]);
    const Eigen::VectorXd own = blend.Weights(static_cast<Eigen::Index>(k)) * images.Trust;
    sums += own.asDiagonal() * images.Positions;
    weights += own;
  }
  // The mean of images is not on the embedded surface in general; it is projected there.
  return FindNearestSurfacePoints(weights.cwiseInverse().asDiagonal() * sums, target.Triangles(),
    to.Embedding.topRows(to.Areas.size()), progress.Part(0.7, 1.0));
}

} // namespace

// Kim, Lipman and Funkhouser's algorithm:
// 1. Map both surfaces conformally to the sphere (MakeRound).
// 2. For triples of landmarks, compute the Moebius transform between the spheres (MapsOfTriples).
// 3. Weight the maps by their agreement with each other, and keep the best (Choose).
// 4. Average the images of each point, weighted by map and by local trust (Blended).
// 5. Repeat the blend from B to A with the inverse Moebius transforms.
SurfaceMaps ComputeBlendedIntrinsicMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const BlendedIntrinsicOptions& options, const Progress& progress)
{
  RequireOption(options.Candidates >= 1, "Candidates", options.Candidates, "at least 1");
  RequireOption(options.Samples >= 10, "Samples", options.Samples, "at least 10");
  RequireOption(options.Agreement > 0.0, "Agreement", options.Agreement, "positive");
  const bool isOpenA = RequireGenusZero(a, "surface A"), isOpenB = RequireGenusZero(b, "surface B");
  RequireLandmarks(landmarks, a, b);
  if (!landmarks.empty() && landmarks.size() < 3)
  {
    throw InvalidInput("there are " + std::to_string(landmarks.size()) +
      " landmarks, but a map needs three; give three or more, or none to have them found");
  }
  const Landmarks used = landmarks.empty()
    ? FindLandmarks(a, b, {}, progress.Part(0.0, 0.2, "finding landmarks")).Pairs
    : landmarks;
  // Both surfaces use one method, or their maps would not agree. The more conformal method can fail
  // on one of them by rounding alone if a fan is close to the surface that it closes, as on a
  // sheet.
  const SphereMapMethod first =
    isOpenA || isOpenB ? SphereMapMethod::PositiveFlow : SphereMapMethod::ConformalFlow;
  RoundSurface onA = MakeRound(a, first, progress.Part(0.2, 0.4, "mapping SurfaceA to the sphere")),
               onB = MakeRound(b, first, progress.Part(0.4, 0.6, "mapping SurfaceB to the sphere"));
  if (onA.Method < onB.Method)
  {
    onA = MakeRound(a, onB.Method, progress.Part(0.6, 0.7));
  }
  else if (onB.Method < onA.Method)
  {
    onB = MakeRound(b, onA.Method, progress.Part(0.6, 0.7));
  }
  const SurfaceLocator locatorA(onA.Sphere), locatorB(onB.Sphere);
  const std::vector<Eigen::Matrix2cd> maps = MapsOfTriples(onA, onB, used);
  if (maps.empty())
  {
    throw InvalidInput("of the " + std::to_string(used.size()) +
      " landmarks, no three are distinct points on both surfaces; give three that are apart");
  }
  Blend blend = Choose(onA, onB, locatorB, maps, SampleFarthestPoints(a, options.Samples), options,
    progress.Part(0.7, 0.8, "choosing conformal maps"));
  SurfaceMaps result;
  result.AToB = Blended(onA, onB, b, locatorB, blend, progress.Part(0.8, 0.9, "blending the maps"));
  for (Eigen::Matrix2cd& moebius : blend.Maps)
  {
    // The same maps with the same weights serve both directions, so the two results are consistent.
    moebius = moebius.inverse().eval();
  }
  result.BToA = Blended(onB, onA, a, locatorA, blend, progress.Part(0.9, 1.0, "blending the maps"));
  return result;
}

} // namespace shape
