#include "Correspondence/Consistent/ConsistentMaps.h"

#include "Base/Errors.h"
#include "Correspondence/Consistent/Private/CandidateChoice.h"
#include "Correspondence/Consistent/Private/CycleErrors.h"
#include "Correspondence/Consistent/Private/LatentFrames.h"
#include "Correspondence/Consistent/Private/PairCandidates.h"
#include "Correspondence/Consistent/Private/ShapeGraph.h"
#include "Correspondence/Correspondence.h"
#include "Correspondence/Evaluate/InvertMap.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Pair/ZoomOut.h"
#include "Correspondence/Reversible/ReversibleHarmonic.h"
#include "Geodesics/FarthestPoints.h"
#include "Spectrum/Smacof.h"

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

using Options = ConsistentMapsOptions;

double PartOf(std::size_t index, std::size_t count)
{
  return static_cast<double>(index) / static_cast<double>(count);
}

std::vector<CoarsePair::Side> Coarsened(const std::vector<Surface>& surfaces,
  const std::vector<NumberedPoints>& numbered, int maximum, const Progress& progress)
{
  std::vector<CoarsePair::Side> coarse;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    progress(PartOf(i, surfaces.size()));
    RequireConnected(surfaces[i], "shape " + std::to_string(i));
    std::vector<int> kept;
    for (const auto& [number, point] : numbered[i])
    {
      kept.push_back(point);
    }
    coarse.push_back(CoarsePair::Coarsen(surfaces[i], kept, maximum));
  }
  return coarse;
}

/// The numbered points of each surface; none if no numbers are given.
std::vector<NumberedPoints> NumberedOf(const std::vector<Surface>& surfaces, const Options& options)
{
  if (options.Numbered.empty())
  {
    return std::vector<NumberedPoints>(surfaces.size());
  }
  if (options.Numbered.size() != surfaces.size())
  {
    throw InvalidInput("there are landmarks of " + std::to_string(options.Numbered.size()) +
      " surfaces, and " + std::to_string(surfaces.size()) + " surfaces; give those of each");
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    for (const auto& [number, point] : options.Numbered[i])
    {
      if (point < 0 || point >= surfaces[i].Points().rows())
      {
        throw InvalidInput("landmark " + std::to_string(number) + " of shape " + std::to_string(i) +
          " is no point of it; give the index of a point");
      }
    }
  }
  return options.Numbered;
}

/// Refines the map of a pair over the latent functions once more for the pair alone: the frames are
/// a compromise between all pairs.
SurfaceMaps RefineForPair(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::vector<int>>& samples, const std::vector<Eigen::MatrixXd>& frames,
  std::size_t a, std::size_t b, const Landmarks& landmarks, const Progress& progress)
{
  constexpr Eigen::Index first = 60; // as many functions as the candidates have
  const Eigen::Index size = std::min(first, frames[a].rows());
  const FunctionalMaps start =
    WithTranspose((frames[b] * frames[a].transpose()).topLeftCorner(size, size));
  ZoomOutOptions options;
  options.Last = static_cast<int>(frames[a].rows());
  const FunctionalMaps maps =
    RefineByZoomOut({ shapes[a].Surface.Triangles(), shapes[a].Spectrum, samples[a] },
      { shapes[b].Surface.Triangles(), shapes[b].Spectrum, samples[b] }, start, landmarks, options,
      progress.Part(0.0, 0.8));
  return FindPointMaps({ shapes[a].Surface.Triangles(), shapes[a].Spectrum, samples[a] },
    { shapes[b].Surface.Triangles(), shapes[b].Spectrum, samples[b] }, maps,
    progress.Part(0.8, 1.0));
}

/// The maps of two fine surfaces alone.
SurfaceMaps MapPair(const Surface& shape, const Surface& base, const Landmarks& landmarks,
  const Options& options, const Progress& progress)
{
  CorrespondenceOptions own;
  own.Method = options.Method == Options::MethodType::FunctionalMap
    ? CorrespondenceOptions::MethodType::FunctionalMap
    : CorrespondenceOptions::MethodType::ReversibleHarmonic;
  own.NumberOfEigenpairs = options.Eigenpairs;
  own.CoarsePoints = options.CoarsePoints;
  own.Part = CorrespondenceOptions::PartType::None;
  return ComputeCorrespondence(shape, base, landmarks, own, progress).Maps;
}

SurfaceMaps IdentityMaps(const Surface& surface)
{
  const SurfacePoints same =
    MakeSurfacePointsAtVertices(Eigen::VectorXi::LinSpaced(surface.Points().rows(), 0,
                                  static_cast<int>(surface.Points().rows()) - 1),
      surface);
  return { same, same };
}

/// Returns the positions of the template's points on a shape, and their inverse. Where parts of the
/// shape touch, the inverse may take a point to the wrong part, far from its image in the given
/// map: that image is kept there.
SurfaceMaps WithInverse(const Surface& shape, const Surface& base, SurfaceMaps maps)
{
  constexpr double far = 0.1; // of the root of the area
  const double root = std::sqrt(ComputePointAreas(base).sum());
  const SurfacePoints inverse = InvertMap(base, maps.BToA, shape);
  const Eigen::VectorXd apart = (PullBack(inverse, base.Triangles(), base.Points()) -
    PullBack(maps.AToB, base.Triangles(), base.Points()))
                                  .rowwise()
                                  .norm();
  for (Eigen::Index point = 0; point < apart.size(); ++point)
  {
    if (apart(point) <= far * root)
    {
      maps.AToB.Triangles(point) = inverse.Triangles(point);
      maps.AToB.Barycentrics.row(point) = inverse.Barycentrics.row(point);
    }
  }
  return maps;
}

EmbeddedSurface Embed(const Surface& surface, const Progress& progress)
{
  return { surface,
    EmbedBySmacof(surface, {}, progress) / std::sqrt(ComputePointAreas(surface).sum()) };
}

/// The mean distance of a point of `a` from its image after the way to b and back.
double RoundTrip(const Surface& a, const Surface& b, const SurfaceMaps& maps)
{
  const Eigen::MatrixXd back = PullBack(maps.BToA, a.Triangles(), a.Points());
  return (PullBack(maps.AToB, b.Triangles(), back) - a.Points()).rowwise().norm().mean();
}

/// Makes maps smooth and nearly inverse to each other: nearest rows leave noise of a part of an
/// edge. These are the last iterations of RefineReversibleHarmonicMap, when the weight of
/// smoothness is small: earlier ones would move images. Maps of equal surfaces have no noise, and
/// are kept.
SurfaceMaps Smooth(const EmbeddedSurface& a, const EmbeddedSurface& b, const SurfaceMaps& start,
  const Landmarks& landmarks, const Progress& progress)
{
  ReversibleHarmonicOptions options;
  options.FirstIteration = 38;
  options.MaximumIterations = 15; // both numbers were chosen on cats and one man
  SurfaceMaps maps = ComputeReversibleHarmonicMap(a, b, start, landmarks, options, progress).Maps;
  return landmarks.empty() &&
      RoundTrip(a.Surface, b.Surface, start) <= RoundTrip(a.Surface, b.Surface, maps)
    ? start
    : maps;
}

/// Sums up positions that one process knows.
void Share(const PairSharing& sharing, Eigen::Index count, SurfacePoints& positions)
{
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, 4);
  if (positions.Triangles.size() > 0)
  {
    rows << positions.Triangles.cast<double>(), positions.Barycentrics;
  }
  sharing.Sum(rows.data(), static_cast<int>(rows.size()));
  positions = { rows.col(0).cast<int>(), rows.rightCols(3) };
}

/// The maps of each shape and the template, of which each process finds some. That of the template
/// itself is the identity.
std::vector<SurfaceMaps> ShareMaps(const std::vector<Surface>& shapes, const Surface& base,
  std::size_t central, const PairSharing& sharing,
  const std::function<SurfaceMaps(std::size_t)>& map)
{
  std::vector<SurfaceMaps> maps(shapes.size());
  const auto mapAll = [&]
  {
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      if (i != central && static_cast<int>(i) % sharing.Processes == sharing.Process)
      {
        maps[i] = map(i);
      }
    }
  };
  sharing.Processes > 1 ? sharing.Run(mapAll) : mapAll();
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    if (i == central)
    {
      maps[i] = IdentityMaps(base);
    }
    else if (sharing.Processes > 1)
    {
      Share(sharing, shapes[i].Points().rows(), maps[i].AToB);
      Share(sharing, base.Points().rows(), maps[i].BToA);
    }
  }
  return maps;
}

void SetMaps(const std::vector<Surface>& shapes, const Surface& base, std::size_t central,
  const std::vector<SurfaceMaps>& maps, ConsistentMaps& result)
{
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    result.SmoothImages.push_back(maps[i].AToB);
    result.Maps.push_back(i == central ? maps[i] : WithInverse(shapes[i], base, maps[i]));
  }
}

/// Each shape is matched with the template alone. numbered: of each shape, and of a given template.
ConsistentMaps MatchWithTemplate(const std::vector<Surface>& shapes, const Surface* base,
  const std::vector<NumberedPoints>& numbered, const Options& options, const PairSharing& sharing,
  const Progress& progress)
{
  ConsistentMaps result;
  if (!base)
  {
    std::vector<Eigen::VectorXd> spectra;
    for (const CoarsePair::Side& each :
      Coarsened(shapes, numbered, options.CoarsePoints, progress.Part(0.0, 0.1)))
    {
      spectra.push_back(
        PrepareMatching(each.Working(), SpectrumSize, options.Landmarks).Spectrum.Eigenvalues);
    }
    Eigen::Index least = 0;
    CompareSpectra(spectra).rowwise().sum().minCoeff(&least);
    result.Template = static_cast<int>(least);
  }
  const Surface& target = base ? *base : shapes[result.Template];
  const std::size_t central = base ? shapes.size() : result.Template;
  const std::vector<SurfaceMaps> maps = ShareMaps(shapes, target, central, sharing,
    [&](std::size_t i)
    {
      return MapPair(shapes[i], target, FindCommonLandmarks(numbered[i], numbered[central]),
        options,
        progress.Part(0.1 + 0.9 * PartOf(i, shapes.size()),
          0.1 + 0.9 * PartOf(i + 1, shapes.size()), "mapping the shapes"));
    });
  SetMaps(shapes, target, central, maps, result);
  result.Disagreements = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(shapes.size()));
  return result;
}

} // namespace

void RequireOptions(const ConsistentMapsOptions& options)
{
  RequireOption(options.Neighbours >= 2, "Neighbours", options.Neighbours, "at least 2");
  RequireOption(options.Candidates >= 1, "Candidates", options.Candidates, "at least 1");
  RequireOption(options.Eigenpairs >= FirstFunctions, "NumberOfEigenpairs", options.Eigenpairs,
    "at least " + std::to_string(FirstFunctions));
  RequireOption(options.CoarsePoints == 0 || options.CoarsePoints >= 100, "CoarsePoints",
    options.CoarsePoints, "0, or at least 100");
}

// 1. Prepare each surface once: features, samples, eigenfunctions.
// 2. Match the pairs of a sparse graph (FindShapeGraph, MatchPairs).
// 3. Choose the maps that agree (ChooseCandidates), and drop the pairs that contradict.
// 4. Refine all maps together (RefineFrames).
// 5. Choose the template, and map each shape onto it through the latent functions.
// 6. Measure the ways around triples (MeasureCycles).
ConsistentMaps ComputeConsistentMaps(const std::vector<Surface>& shapes, const Surface* base,
  const ConsistentMapsOptions& options, const PairSharing& sharing, const Progress& progress)
{
  std::vector<Surface> fine = shapes;
  if (base)
  {
    fine.push_back(*base);
  }
  RequireOptions(options);
  if (fine.size() < 2)
  {
    throw InvalidInput("maps need two or more surfaces; put them together with Group Datasets");
  }
  const std::vector<NumberedPoints> numbered = NumberedOf(fine, options);
  if (options.Consistency == Options::ConsistencyType::None)
  {
    for (std::size_t i = 0; i < fine.size(); ++i)
    {
      RequireConnected(fine[i], "shape " + std::to_string(i));
    }
    return MatchWithTemplate(shapes, base, numbered, options, sharing, progress);
  }
  const std::vector<CoarsePair::Side> surfaces = Coarsened(
    fine, numbered, options.CoarsePoints, progress.Part(0.0, 0.05, "coarsening the surfaces"));
  const std::size_t count = surfaces.size();
  std::vector<MatchedSurface> matched;
  std::vector<std::vector<int>> samples;
  std::vector<Eigen::VectorXd> spectra;
  std::vector<NumberedPoints> onWorking(count);
  Eigen::Index last = options.Eigenpairs;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Progress part = progress.Part(
      0.05 + 0.15 * PartOf(i, count), 0.05 + 0.15 * PartOf(i + 1, count), "preparing the shapes");
    matched.push_back(
      PrepareMatching(surfaces[i].Working(), options.Eigenpairs, options.Landmarks, part));
    constexpr int enough = 500; // as for functional maps of pairs
    samples.push_back(SampleFarthestPoints(surfaces[i].Working(), enough));
    spectra.push_back(matched[i].Spectrum.Eigenvalues);
    for (const auto& [number, point] : numbered[i])
    {
      onWorking[i][number] = surfaces[i].CoarsePoint(point);
    }
    last = std::min(last, matched[i].Spectrum.Eigenvalues.size());
  }
  const std::vector<std::array<int, 2>> graph =
    FindShapeGraph(CompareSpectra(spectra), options.Neighbours);
  const std::vector<CandidatePair> pairs = MatchPairs(
    matched, graph, onWorking, options, sharing, progress.Part(0.2, 0.5, "finding maps of pairs"));
  const CandidateChoice choice = ChooseCandidates(static_cast<int>(count), pairs,
    std::min<Eigen::Index>(FirstFunctions, last), progress.Part(0.5, 0.55, "choosing maps"));

  ConsistentMaps result;
  Eigen::VectorXd weights(static_cast<Eigen::Index>(pairs.size()));
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count)), kept = sums;
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    const std::vector<double>& errors = pairs[p].Errors;
    ConsistentPair pair{ pairs[p].A, pairs[p].B, choice.Chosen[p], 0.0, 0.0,
      choice.Disagreements(static_cast<Eigen::Index>(p)) };
    const bool inTree = std::find(choice.Tree.begin(), choice.Tree.end(), p) != choice.Tree.end();
    pair.Dropped = pair.Rank < 0 || (pair.Disagreement > LargestDisagreement && !inTree);
    pair.Error = pair.Rank < 0 ? 0.0 : errors[pair.Rank];
    pair.Confidence = errors.size() > 1 ? 1.0 - errors[0] / errors[1] : 0.0;
    weights(static_cast<Eigen::Index>(p)) = pair.Dropped ? 0.0 : 1.0;
    if (!pair.Dropped)
    {
      for (const int end : { pair.A, pair.B })
      {
        sums(end) += pair.Disagreement;
        kept(end) += 1.0;
      }
    }
    result.Pairs.push_back(pair);
  }
  result.Disagreements =
    sums.cwiseQuotient(kept.cwiseMax(1.0)).head(static_cast<Eigen::Index>(shapes.size()));
  const std::vector<Eigen::MatrixXd> frames = RefineFrames(matched, samples, pairs, weights,
    choice.Tree, choice.Frames, last, progress.Part(0.55, 0.75, "refining all maps"));
  result.Template = base ? -1 : FindCentral(matched, frames, shapes.size());
  const std::size_t central = base ? count - 1 : result.Template;
  const bool isSmoothed = options.Method == Options::MethodType::FunctionalMap;
  const EmbeddedSurface embedded = isSmoothed
    ? Embed(surfaces[central].Working(), progress.Part(0.75, 0.76, "mapping the shapes"))
    : EmbeddedSurface{};
  const std::vector<SurfaceMaps> onTemplate = ShareMaps(shapes, fine[central], central, sharing,
    [&](std::size_t i)
    {
      const Progress part = progress.Part(0.76 + 0.14 * PartOf(i, shapes.size()),
        0.76 + 0.14 * PartOf(i + 1, shapes.size()), "mapping the shapes");
      const Landmarks landmarks = FindCommonLandmarks(onWorking[i], onWorking[central]);
      const SurfaceMaps maps =
        RefineForPair(matched, samples, frames, i, central, landmarks, part.Part(0.0, 0.4));
      const CoarsePair pair(surfaces[i], surfaces[central]);
      return isSmoothed
        ? pair.OnFine(Smooth(Embed(surfaces[i].Working(), part.Part(0.4, 0.5)), embedded, maps,
            landmarks, part.Part(0.5, 1.0)))
        : RefineReversibleHarmonicMap(pair, maps, landmarks, {}, part.Part(0.4, 1.0)).Maps;
    });
  SetMaps(shapes, fine[central], central, onTemplate, result);
  const Progress measuring = progress.Part(0.9, 1.0, "measuring cycles");
  const std::vector<std::array<int, 3>> triples = FindTriples(pairs);
  result.Triples = static_cast<int>(triples.size());
  if (!triples.empty())
  {
    std::vector<Surface> working;
    std::vector<std::vector<int>> starts, own;
    for (std::size_t i = 0; i < count; ++i)
    {
      constexpr std::size_t enough = 30; // points that go around
      working.push_back(surfaces[i].Working());
      own.emplace_back(
        samples[i].begin(), samples[i].begin() + std::min(enough, samples[i].size()));
      starts.emplace_back();
      for (const int point : own[i])
      {
        starts[i].push_back(surfaces[i].FinePoint(point));
      }
    }
    std::vector<SurfaceMaps> onto = result.Maps;
    if (base)
    {
      onto.push_back(IdentityMaps(*base));
    }
    result.CycleError = MeasureCycles(
      fine, starts, triples, MapsOverTemplate(fine, central, onto), measuring.Part(0.0, 0.6));
    result.PairwiseCycleError = MeasureCycles(
      working, own, triples, MapsOfPairs(working, matched, pairs), measuring.Part(0.6, 1.0));
  }
  progress(1.0);
  return result;
}

} // namespace shape
