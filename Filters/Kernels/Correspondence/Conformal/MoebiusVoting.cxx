#include "Correspondence/Conformal/MoebiusVoting.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Conformal/Private/MidEdgeMap.h"
#include "Correspondence/Conformal/Private/MoebiusMap.h"
#include "Correspondence/Conformal/Private/SampleTriples.h"
#include "Correspondence/Landmarks/FeaturedSurface.h"
#include "Correspondence/Landmarks/GeodesicSamples.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/FarthestPoints.h"
#include "Mesh/BoundaryLoops.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// The samples of a surface, in the plane.
struct FlatSamples
{
  std::vector<int> Points;
  Eigen::MatrixXd Between; ///< s x s: distances along the surface, for area 1
  ComplexPoints Places;    ///< s x 2
};

FlatSamples Flatten(
  const Surface& surface, const MoebiusVotingOptions& options, const Progress& progress)
{
  constexpr int distances = 200, features = 12;
  const int start = FindRemotestPoint(surface);
  const GeodesicSamples sampled = SampleSurface(surface, options.Samples, progress.Part(0.4, 0.8),
    FindFeatures(surface, distances, features, progress.Part(0.0, 0.4)).Features, start);
  const Surface closed = FillWithFans(surface, FindManifoldBoundaryLoops(surface));
  // Source and sink far apart resolve the two extremities where most points gather.
  const std::vector<int> ends = SampleFarthestPoints(surface, 2, {}, start);
  const MidEdgeMap map = FlattenMidEdges(closed, ends[0], ends[1], progress.Part(0.8, 1.0));
  return { sampled.Points, sampled.Between(), map.Points(sampled.Points, Eigen::all) };
}

/// The cube roots of 1, on the equator.
ComplexPoints MakeEquilateral()
{
  ComplexPoints places(3, 2);
  for (int k = 0; k < 3; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * k / 3.0;
    places.row(k) << std::polar(1.0, angle), 1.0;
  }
  return places;
}

/// The mutually nearest samples under a Moebius map, and its deformation energy.
struct Partners
{
  std::vector<std::array<int, 2>> Pairs;
  double Energy = 0.0;
};

/// Without partners if the map is not finite.
Partners FindPartners(const FlatSamples& a, const FlatSamples& b, const TriplePair& triples,
  const ComplexPoints& equilateral)
{
  const Eigen::Matrix2cd ofA =
                           SolveMoebiusTransform(a.Places(triples.OfA, Eigen::all), equilateral),
                         ofB =
                           SolveMoebiusTransform(b.Places(triples.OfB, Eigen::all), equilateral);
  Partners partners;
  if (!ofA.allFinite() || !ofB.allFinite())
  {
    return partners;
  }
  const Eigen::MatrixXd onA = ToSphere(ApplyMoebiusTransform(a.Places, ofA)),
                        onB = ToSphere(ApplyMoebiusTransform(b.Places, ofB));
  // The nearest place on the sphere is that with the largest cosine.
  const Eigen::MatrixXd cosines = onA.lazyProduct(onB.transpose());
  std::vector<int> nearestOfB(cosines.cols());
  for (Eigen::Index j = 0; j < cosines.cols(); ++j)
  {
    cosines.col(j).maxCoeff(&nearestOfB[j]);
  }
  for (int i = 0; i < static_cast<int>(cosines.rows()); ++i)
  {
    Eigen::Index j = 0;
    cosines.row(i).maxCoeff(&j);
    if (nearestOfB[j] == i)
    {
      partners.Pairs.push_back({ i, static_cast<int>(j) });
      partners.Energy += (onA.row(i) - onB.row(j)).norm();
    }
  }
  partners.Energy /= static_cast<double>(partners.Pairs.size());
  return partners;
}

void RequireVotingInput(const Surface& surface, const std::string& name)
{
  const int genus = ComputeGenus(RequireConnected(surface, name));
  if (genus != 0)
  {
    throw InvalidInput(name + " has genus " + std::to_string(genus) +
      "; Moebius maps need genus 0: cut each handle with Clip and close the cuts with Shape Fill "
      "Holes, or have the landmarks found by distances");
  }
}

/// For each pair of samples, how much its distances agree with those of the others, in [0, 1]. The
/// others count by their confidence.
Eigen::VectorXd Agreements(const FlatSamples& a, const FlatSamples& b, const Landmarks& pairs,
  const Eigen::VectorXd& confidences)
{
  constexpr double tolerance = 0.15; // the closer one of FindLandmarks
  Eigen::VectorXd agreements = Eigen::VectorXd::Zero(confidences.size()), sums = agreements;
  for (Eigen::Index p = 0; p < agreements.size(); ++p)
  {
    for (Eigen::Index q = 0; q < agreements.size(); ++q)
    {
      const double onA = a.Between(pairs[p][0], pairs[q][0]),
                   onB = b.Between(pairs[p][1], pairs[q][1]);
      const double difference = (onA - onB) / (tolerance * std::max({ onA, onB, 1e-9 }));
      if (p != q)
      {
        agreements(p) += confidences(q) * std::exp(-0.5 * difference * difference);
        sums(p) += confidences(q);
      }
    }
  }
  return agreements.array() / sums.array().max(1e-300);
}

/// The pairs that prefer each other, and agree with the others. total: the sum of the maps' votes.
void FindPairs(const FlatSamples& a, const FlatSamples& b, double total, MoebiusVotes& result)
{
  Landmarks samples;
  std::vector<double> listed;
  for (int i = 0; i < static_cast<int>(result.Votes.rows()); ++i)
  {
    Eigen::Index j = 0, back = 0;
    if (result.Votes.row(i).maxCoeff(&j) > 0.0)
    {
      result.Votes.col(j).maxCoeff(&back);
      if (back == i)
      {
        samples.push_back({ i, static_cast<int>(j) });
        listed.push_back(result.Votes(i, j) / total);
      }
    }
  }
  const Eigen::VectorXd confidences =
    Eigen::Map<const Eigen::VectorXd>(listed.data(), static_cast<Eigen::Index>(listed.size()));
  const Eigen::VectorXd agreements = Agreements(a, b, samples, confidences);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < agreements.size(); ++k)
  {
    if (agreements(k) > 0.5)
    {
      kept.push_back(k);
      result.Pairs.push_back({ a.Points[samples[k][0]], b.Points[samples[k][1]] });
    }
  }
  result.Confidences = confidences(kept);
}

} // namespace

// Lipman and Funkhouser's algorithm:
// 1. Map both surfaces conformally to the plane, and sample them (Flatten).
// 2. Choose triples of samples of both surfaces (FindSimilarTriples).
// 3. For each, compute the Moebius maps to the equilateral triangle, the mutually nearest samples
//    and the deformation energy, and vote (Vote).
// 4. From the correspondence matrix, take the pairs that prefer each other and whose distances
//    agree with those of the others (FindPairs).
MoebiusVotes VoteByMoebiusMaps(
  const Surface& a, const Surface& b, const MoebiusVotingOptions& options, const Progress& progress)
{
  RequireOption(options.Samples >= 10, "VotingSamples", options.Samples, "at least 10");
  RequireOption(options.Generators >= 3, "VotingGenerators", options.Generators, "at least 3");
  RequireOption(options.Triples >= 1, "VotingTriples", options.Triples, "at least 1");
  RequireOption(options.Tolerance > 0.0, "TripleTolerance", options.Tolerance, "positive");
  RequireOption(options.Share > 0.0 && options.Share <= 1.0, "VotingShare", options.Share,
    "above 0, at most 1");
  RequireOption(options.Energy > 0.0, "VotingEnergy", options.Energy, "positive");
  RequireVotingInput(a, "surface A");
  RequireVotingInput(b, "surface B");
  const FlatSamples onA = Flatten(a, options, progress.Part(0.0, 0.3)),
                    onB = Flatten(b, options, progress.Part(0.3, 0.6));
  const std::vector<TriplePair> triples = SelectTriples(
    FindSimilarTriples(onA.Between, onB.Between, options.Generators, options.Tolerance),
    options.Triples);
  MoebiusVotes result;
  result.SamplesOfA = onA.Points;
  result.SamplesOfB = onB.Points;
  const ComplexPoints equilateral = MakeEquilateral();
  const auto count = static_cast<int>(triples.size());
  constexpr int chunk = 100;
  std::vector<Partners> partners(count);
  ParallelFor(
    count, chunk,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        partners[k] = FindPartners(onA, onB, triples[k], equilateral);
      }
    },
    progress.Part(0.6, 1.0, "voting"));
  std::size_t most = 0;
  for (const Partners& map : partners)
  {
    most = std::max(most, map.Pairs.size());
  }
  result.Votes = Eigen::MatrixXd::Zero(
    static_cast<Eigen::Index>(onA.Points.size()), static_cast<Eigen::Index>(onB.Points.size()));
  double total = 0.0;
  for (const Partners& map : partners)
  {
    if (!map.Pairs.empty() &&
      static_cast<double>(map.Pairs.size()) >= options.Share * static_cast<double>(most))
    {
      ++result.Maps;
      const double vote = options.Energy / (options.Energy + map.Energy);
      total += vote;
      for (const auto& [i, j] : map.Pairs)
      {
        result.Votes(i, j) += vote;
      }
    }
  }
  if (result.Maps == 0)
  {
    throw InvalidInput("no Moebius map was found: no three of the samples of surface A are as far "
                       "apart as three of surface B; give Landmarks, raise TripleTolerance or have "
                       "the landmarks found by distances");
  }
  FindPairs(onA, onB, total, result);
  if (result.Pairs.size() < 3)
  {
    throw InvalidInput("only " + std::to_string(result.Pairs.size()) + " of " +
      std::to_string(onA.Points.size()) +
      " samples got a partner, since the distances of the others contradict each other; give "
      "Landmarks, or have the landmarks found by distances");
  }
  result.Votes /= result.Votes.sum();
  progress(1.0);
  return result;
}

} // namespace shape
