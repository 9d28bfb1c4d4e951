#include "Correspondence/CommonBase/Private/LoopedSurface.h"

#include "Correspondence/Landmarks/GeodesicSamples.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/FarthestPoints.h"
#include "Geodesics/HeatGeodesics.h"
#include "Search/NearestSurfacePoints.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace shape
{
namespace
{

/// See FindLandmarks.
double MeanDifference(const LoopedSurface& a, const LoopedSurface& b, const Eigen::VectorXi& images)
{
  return a.Weights.dot((a.Between - b.Between(images, images)).cwiseAbs() * a.Weights);
}

/// Describes points by their distances from landmarks (EmbedByLandmarks). side: of the landmarks.
Eigen::MatrixXd Embed(
  const LoopedSurface& surface, const Landmarks& pairs, int side, const std::vector<int>& points)
{
  const Eigen::MatrixXd functions = surface.Distances(Eigen::all, PointsOf(pairs, side));
  std::vector<int> all(pairs.size());
  std::iota(all.begin(), all.end(), 0);
  return EmbedByDistances(functions(points, Eigen::all),
    ComputeGradientOrientations(surface.Shape, functions, points), all, 1.0);
}

} // namespace

LoopedSurface::LoopedSurface(
  const Surface& surface, const std::string& name, const Progress& progress)
  : Shape(surface)
  , Loops(surface, name)
{
  constexpr int samples = 100;
  const GeodesicSamples sampled =
    SampleSurface(surface, samples, progress.Part(0.0, 0.2), {}, FindRemotestPoint(surface));
  this->Samples = sampled.Points;
  this->Weights = sampled.Weights;
  this->Between = sampled.Between();
  std::vector<int> all(surface.Points().rows());
  std::iota(all.begin(), all.end(), 0);
  this->Distances = ComputeHeatDistances(surface, all, progress.Part(0.2, 1.0)) / sampled.Length;
}

std::vector<int> MarksOf(
  const LoopedSurface& surface, const LoopCrossing& crossing, std::vector<double>& shares)
{
  const Eigen::MatrixXd& positions = surface.Shape.Points();
  std::vector<int> marks{ crossing.Point() };
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const SurfaceCycle& cycle = i < shares.size() / 2 ? crossing.Handle : crossing.Tunnel;
    double along = 0.0, nearest = std::numeric_limits<double>::infinity();
    int mark = -1;
    double reached = 0.0;
    for (std::size_t k = 1; k < cycle.Points.size(); ++k)
    {
      along += (positions.row(cycle.Points[k]) - positions.row(cycle.Points[k - 1])).norm();
      const double share = along / cycle.Length, apart = std::abs(share - shares[i]);
      if (apart < nearest)
      {
        nearest = apart;
        mark = cycle.Points[k];
        reached = share;
      }
    }
    shares[i] = reached;
    marks.push_back(mark);
  }
  return marks;
}

std::vector<LoopCrossing> FindCrossings(const LoopedSurface& surface, const Progress& progress)
{
  constexpr int count = 2; // at each point
  std::vector<LoopCrossing> all;
  for (int point = 0; point < static_cast<int>(surface.Shape.Points().rows()); ++point)
  {
    const std::vector<LoopCrossing> found = surface.Loops.FindAt(point, count);
    all.insert(all.end(), found.begin(), found.end());
    progress(static_cast<double>(point) / static_cast<double>(surface.Shape.Points().rows()));
  }
  return all;
}

std::vector<LoopCrossing> ChooseHandles(const LoopedSurface& surface, std::vector<LoopCrossing> all)
{
  std::stable_sort(all.begin(), all.end(),
    [](const LoopCrossing& x, const LoopCrossing& y) { return x.Length() < y.Length(); });
  std::vector<LoopCrossing> chosen;
  Eigen::MatrixXd span(2 * surface.Loops.Genus(), 0);
  for (const LoopCrossing& crossing : all)
  {
    Eigen::MatrixXd larger(span.rows(), span.cols() + 2);
    larger << span, crossing.Handle.Homology.cast<double>(),
      crossing.Tunnel.Homology.cast<double>();
    if (larger.cols() <= larger.rows() &&
      Eigen::FullPivLU<Eigen::MatrixXd>(larger).rank() == larger.cols())
    {
      span = larger;
      chosen.push_back(crossing);
    }
  }
  return chosen;
}

std::vector<LoopCrossing> SpreadCrossings(
  const LoopedSurface& surface, const std::vector<LoopCrossing>& all)
{
  // The number of combinations grows with the genus.
  constexpr int most = 200;
  std::vector<LoopCrossing> spread;
  Eigen::VectorXd distances = Eigen::VectorXd::Constant(
    surface.Distances.rows(), std::numeric_limits<double>::infinity()); // from the points chosen
  for (int chosen = 0; chosen < most / surface.Loops.Genus(); ++chosen)
  {
    const auto farthest = std::max_element(all.begin(), all.end(),
      [&](const LoopCrossing& x, const LoopCrossing& y)
      { return distances(x.Point()) < distances(y.Point()); });
    if (farthest == all.end() || !(distances(farthest->Point()) > 0.0))
    {
      break;
    }
    const int point = farthest->Point();
    std::copy_if(all.begin(), all.end(), std::back_inserter(spread),
      [&](const LoopCrossing& crossing) { return crossing.Point() == point; });
    distances = distances.cwiseMin(surface.Distances.col(point));
    distances(point) = 0.0;
  }
  return spread;
}

double ShortestLoop(const LoopedSurface& surface, const std::vector<LoopCrossing>& handles)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const LoopCrossing& handle : handles)
  {
    shortest = std::min({ shortest, handle.Handle.Length, handle.Tunnel.Length });
  }
  return shortest / std::sqrt(ComputeArea(surface.Shape));
}

double DistortionOf(const LoopedSurface& a, const LoopedSurface& b, const Landmarks& pairs)
{
  const Eigen::MatrixXd onA = Embed(a, pairs, 0, a.Samples), onB = Embed(b, pairs, 1, b.Samples);
  return 0.5 *
    (MeanDifference(a, b, FindNearestRows(onA, onB)) +
      MeanDifference(b, a, FindNearestRows(onB, onA)));
}

Landmarks WithFarPoints(const LoopedSurface& a, const LoopedSurface& b, Landmarks pairs)
{
  constexpr double far = 0.5; // over the root of the area
  std::vector<int> all(b.Shape.Points().rows());
  std::iota(all.begin(), all.end(), 0);
  while (!pairs.empty())
  {
    Eigen::Index farthest = 0;
    const double distance =
      a.Distances(Eigen::all, PointsOf(pairs, 0)).rowwise().minCoeff().maxCoeff(&farthest);
    const auto own = static_cast<int>(farthest);
    const int partner = FindNearestRows(Embed(a, pairs, 0, { own }), Embed(b, pairs, 1, all))(0);
    const double there = b.Distances(partner, PointsOf(pairs, 1)).minCoeff();
    if (distance < far || there < 0.5 * far)
    {
      return pairs;
    }
    pairs.push_back({ own, partner });
  }
  return pairs;
}

} // namespace shape
