#include "Correspondence/Consistent/ConsistentMaps.h"

#include "Base/Errors.h"
#include "Correspondence/Consistent/Private/CandidateChoice.h"
#include "Correspondence/Consistent/Private/CycleErrors.h"
#include "Correspondence/Consistent/Private/ShapeGraph.h"
#include "Correspondence/Correspondence.h"
#include "Correspondence/Evaluate/InvertMap.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Pair/ZoomOut.h"
#include "Correspondence/Reversible/ReversibleHarmonic.h"
#include "Geodesics/FarthestPoints.h"
#include "Remesh/Coarsening.h"
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

using Options = ConsistentMapsOptions;

constexpr int FirstFunctions = 20;

double PartOf(std::size_t index, std::size_t count)
{
  return static_cast<double>(index) / static_cast<double>(count);
}

/// A surface on which maps are found, and the numbers of its points in the given one.
struct WorkingSurface
{
  shape::Surface Surface;
  std::vector<int> Points;
};

WorkingSurface Whole(const Surface& surface)
{
  std::vector<int> points(surface.Points().rows());
  std::iota(points.begin(), points.end(), 0);
  return { surface, std::move(points) };
}

std::vector<WorkingSurface> Coarsened(
  const std::vector<Surface>& surfaces, int maximum, const Progress& progress)
{
  std::vector<WorkingSurface> coarse;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    progress(PartOf(i, surfaces.size()));
    RequireConnected(surfaces[i], "shape " + std::to_string(i));
    if (maximum == 0 || surfaces[i].Points().rows() <= maximum)
    {
      coarse.push_back(Whole(surfaces[i]));
      continue;
    }
    CoarseSurface made = CoarsenSurface(surfaces[i], maximum);
    coarse.push_back({ made.Surface, std::move(made.Points) });
  }
  return coarse;
}

/// The candidates of the pairs, of which each process finds some. Numbers that every process knows
/// the place of are added up: of each candidate the error and the maps.
std::vector<CandidatePair> MatchPairs(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::array<int, 2>>& graph, const Options& options, const PairSharing& sharing,
  const Progress& progress)
{
  const auto sizeOf = [&](std::size_t p)
  {
    constexpr Eigen::Index most = 60; // FindLandmarkCandidates
    return std::min({ most, shapes[graph[p][0]].Spectrum.Eigenvalues.size(),
      shapes[graph[p][1]].Spectrum.Eigenvalues.size() });
  };
  std::vector<std::vector<double>> values(graph.size());
  const auto match = [&](std::size_t p)
  {
    progress(PartOf(p, graph.size()));
    const Eigen::Index size = sizeOf(p), each = 1 + 2 * size * size;
    values[p].assign(options.Candidates * each, 0.0);
    if (static_cast<int>(p) % sharing.Processes == sharing.Process)
    {
      const std::vector<LandmarkCandidate> found =
        FindLandmarkCandidates(shapes[graph[p][0]], shapes[graph[p][1]], options.Landmarks,
          progress.Part(PartOf(p, graph.size()), PartOf(p + 1, graph.size())));
      for (std::size_t c = 0; c < std::min<std::size_t>(found.size(), options.Candidates); ++c)
      {
        double* at = values[p].data() + c * each;
        constexpr double smallest = 1e-6; // rounding of the eigenpairs, for equal surfaces
        *at = std::max(found[c].Error, smallest);
        Eigen::Map<Eigen::MatrixXd>(at + 1, size, size) = found[c].Maps.AToB;
        Eigen::Map<Eigen::MatrixXd>(at + 1 + size * size, size, size) = found[c].Maps.BToA;
      }
    }
  };
  const auto matchAll = [&]
  {
    for (std::size_t p = 0; p < graph.size(); ++p)
    {
      match(p);
    }
  };
  sharing.Processes > 1 ? sharing.Run(matchAll) : matchAll();
  std::vector<CandidatePair> pairs;
  for (std::size_t p = 0; p < graph.size(); ++p)
  {
    pairs.push_back({ graph[p][0], graph[p][1], {}, {} });
    if (sharing.Processes > 1)
    {
      sharing.Sum(values[p].data(), static_cast<int>(values[p].size()));
    }
    const Eigen::Index size = sizeOf(p), each = 1 + 2 * size * size;
    for (int c = 0; c < options.Candidates && values[p][c * each] > 0.0; ++c)
    {
      const double* at = values[p].data() + c * each;
      pairs[p].Errors.push_back(*at);
      pairs[p].Maps.push_back({ Eigen::Map<const Eigen::MatrixXd>(at + 1, size, size),
        Eigen::Map<const Eigen::MatrixXd>(at + 1 + size * size, size, size) });
    }
  }
  return pairs;
}

/// The values of the latent functions at the points of each shape.
std::vector<Eigen::MatrixXd> EmbedInLatent(
  const std::vector<MatchedSurface>& shapes, const std::vector<Eigen::MatrixXd>& frames)
{
  std::vector<Eigen::MatrixXd> embedded;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    embedded.push_back(shapes[i].Spectrum.Eigenfunctions.leftCols(frames[i].rows()) * frames[i]);
  }
  return embedded;
}

/// Consistent ZoomOut: from the frames of few functions to those of `last`.
std::vector<Eigen::MatrixXd> RefineFrames(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::vector<int>>& samples, const std::vector<CandidatePair>& pairs,
  const Eigen::VectorXd& weights, const std::vector<int>& tree, std::vector<Eigen::MatrixXd> frames,
  Eigen::Index last, const Progress& progress)
{
  constexpr Eigen::Index step = 10;
  const Eigen::Index first = frames[0].rows();
  for (Eigen::Index size = first; !pairs.empty();)
  {
    const auto done = [&](Eigen::Index functions)
    { return static_cast<double>(functions - first) / static_cast<double>(last - first + step); };
    const Progress part = progress.Part(done(size), done(size + step));
    const std::vector<Eigen::MatrixXd> embedded = EmbedInLatent(shapes, frames);
    const Eigen::Index next = std::min(size + step, last);
    std::vector<FunctionalMaps> maps(pairs.size());
    for (std::size_t p = 0; p < pairs.size(); ++p)
    {
      part(PartOf(p, pairs.size()));
      if (weights(static_cast<Eigen::Index>(p)) == 0.0)
      {
        maps[p] = { Eigen::MatrixXd::Zero(next, next), Eigen::MatrixXd::Zero(next, next) };
        continue;
      }
      const int a = pairs[p].A, b = pairs[p].B;
      const Eigen::VectorXi onB = FindNearestRows(embedded[a](samples[a], Eigen::all), embedded[b]),
                            onA = FindNearestRows(embedded[b](samples[b], Eigen::all), embedded[a]);
      const auto functionsA = shapes[a].Spectrum.Eigenfunctions.leftCols(next),
                 functionsB = shapes[b].Spectrum.Eigenfunctions.leftCols(next);
      Eigen::MatrixXd ofA(onB.size() + onA.size(), next), ofB(ofA.rows(), next);
      ofA << functionsA(samples[a], Eigen::all), functionsA(onA, Eigen::all);
      ofB << functionsB(onB, Eigen::all), functionsB(samples[b], Eigen::all);
      maps[p] = { FitCoefficients(ofA, ofB), FitCoefficients(ofB, ofA) };
    }
    frames = AverageFrames(static_cast<int>(shapes.size()), pairs, maps, weights, tree);
    if (size == last)
    {
      break;
    }
    size = next;
  }
  return frames;
}

/// Refines the map of a pair over the latent functions once more for the pair alone: the frames are
/// a compromise between all pairs.
SurfaceMaps RefineForPair(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::vector<int>>& samples, const std::vector<Eigen::MatrixXd>& frames,
  std::size_t a, std::size_t b, const Progress& progress)
{
  constexpr Eigen::Index first = 60; // as many functions as the candidates have
  const Eigen::Index size = std::min(first, frames[a].rows());
  const FunctionalMaps start =
    WithTranspose((frames[b] * frames[a].transpose()).topLeftCorner(size, size));
  ZoomOutOptions options;
  options.Last = static_cast<int>(frames[a].rows());
  const FunctionalMaps maps =
    RefineByZoomOut({ shapes[a].Surface.Triangles(), shapes[a].Spectrum, samples[a] },
      { shapes[b].Surface.Triangles(), shapes[b].Spectrum, samples[b] }, start, {}, options,
      progress.Part(0.0, 0.8));
  return FindPointMaps({ shapes[a].Surface.Triangles(), shapes[a].Spectrum, samples[a] },
    { shapes[b].Surface.Triangles(), shapes[b].Spectrum, samples[b] }, maps,
    progress.Part(0.8, 1.0));
}

/// The shape whose products of latent functions differ least from those of the others.
int FindCentral(const std::vector<MatchedSurface>& shapes,
  const std::vector<Eigen::MatrixXd>& frames, std::size_t count)
{
  std::vector<Eigen::MatrixXd> areas, gradients;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::Index size = std::min<Eigen::Index>(FirstFunctions, frames[i].cols());
    const Eigen::MatrixXd frame = frames[i].leftCols(size);
    areas.emplace_back(frame.transpose() * frame);
    gradients.emplace_back(frame.transpose() *
      shapes[i].Spectrum.Eigenvalues.head(frames[i].rows()).asDiagonal() * frame);
  }
  double scale = 0.0;
  for (const Eigen::MatrixXd& gradient : gradients)
  {
    scale += gradient.squaredNorm() / areas[0].cols() / static_cast<double>(count);
  }
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      sums(i) += std::sqrt((areas[i] - areas[j]).squaredNorm() +
        (gradients[i] - gradients[j]).squaredNorm() / std::max(scale, 1e-300));
    }
  }
  Eigen::Index least = 0;
  sums.minCoeff(&least);
  return static_cast<int>(least);
}

/// The maps of two fine surfaces alone.
SurfaceMaps MapPair(
  const Surface& shape, const Surface& base, const Options& options, const Progress& progress)
{
  CorrespondenceOptions own;
  own.Method = options.Method == Options::MethodType::FunctionalMap
    ? CorrespondenceOptions::MethodType::FunctionalMap
    : CorrespondenceOptions::MethodType::ReversibleHarmonic;
  own.NumberOfEigenpairs = options.Eigenpairs;
  own.CoarsePoints = options.CoarsePoints;
  own.Part = CorrespondenceOptions::PartType::None;
  return ComputeCorrespondence(shape, base, {}, own, progress).Maps;
}

SurfaceMaps IdentityMaps(const Surface& surface)
{
  const SurfacePoints same =
    MakeSurfacePointsAtVertices(Eigen::VectorXi::LinSpaced(surface.Points().rows(), 0,
                                  static_cast<int>(surface.Points().rows()) - 1),
      surface);
  return { same, same };
}

SurfaceMaps WithInverse(const Surface& surface, const Surface& target, SurfacePoints onto)
{
  SurfacePoints inverse = InvertMap(surface, onto, target);
  return { std::move(onto), std::move(inverse) };
}

/// The images of the points of each shape on the template, of which each process finds some. Those
/// of the template itself are empty.
std::vector<SurfacePoints> ShareImages(const std::vector<Surface>& surfaces, std::size_t shapes,
  std::size_t central, const PairSharing& sharing,
  const std::function<SurfacePoints(std::size_t)>& map)
{
  std::vector<SurfacePoints> images(shapes);
  const auto mapAll = [&]
  {
    for (std::size_t i = 0; i < shapes; ++i)
    {
      if (i != central && static_cast<int>(i) % sharing.Processes == sharing.Process)
      {
        images[i] = map(i);
      }
    }
  };
  if (sharing.Processes == 1)
  {
    mapAll();
    return images;
  }
  sharing.Run(mapAll);
  for (std::size_t i = 0; i < shapes; ++i)
  {
    if (i != central)
    {
      const Eigen::Index points = surfaces[i].Points().rows();
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(points, 4);
      if (images[i].Triangles.size() > 0)
      {
        rows << images[i].Triangles.cast<double>(), images[i].Barycentrics;
      }
      sharing.Sum(rows.data(), static_cast<int>(rows.size()));
      images[i] = { rows.col(0).cast<int>(), rows.rightCols(3) };
    }
  }
  return images;
}

/// Each shape is matched with the template alone.
ConsistentMaps MatchWithTemplate(const std::vector<Surface>& shapes, const Surface* base,
  const Options& options, const PairSharing& sharing, const Progress& progress)
{
  ConsistentMaps result;
  if (!base)
  {
    std::vector<Eigen::VectorXd> spectra;
    for (const WorkingSurface& each :
      Coarsened(shapes, options.CoarsePoints, progress.Part(0.0, 0.1)))
    {
      spectra.push_back(
        PrepareMatching(each.Surface, SpectrumSize, options.Landmarks).Spectrum.Eigenvalues);
    }
    Eigen::Index least = 0;
    CompareSpectra(spectra).rowwise().sum().minCoeff(&least);
    result.Template = static_cast<int>(least);
  }
  const Surface& target = base ? *base : shapes[result.Template];
  const std::size_t central = base ? shapes.size() : result.Template;
  const std::vector<SurfacePoints> images = ShareImages(shapes, shapes.size(), central, sharing,
    [&](std::size_t i)
    {
      return MapPair(shapes[i], target, options,
        progress.Part(0.1 + 0.9 * PartOf(i, shapes.size()),
          0.1 + 0.9 * PartOf(i + 1, shapes.size()), "mapping the shapes"))
        .AToB;
    });
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    result.Maps.push_back(
      i == central ? IdentityMaps(target) : WithInverse(shapes[i], target, images[i]));
  }
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
  if (options.Consistency == Options::ConsistencyType::None)
  {
    for (std::size_t i = 0; i < fine.size(); ++i)
    {
      RequireConnected(fine[i], "shape " + std::to_string(i));
    }
    return MatchWithTemplate(shapes, base, options, sharing, progress);
  }
  const std::vector<WorkingSurface> surfaces =
    Coarsened(fine, options.CoarsePoints, progress.Part(0.0, 0.05, "coarsening the surfaces"));
  const std::size_t count = surfaces.size();
  std::vector<MatchedSurface> matched;
  std::vector<std::vector<int>> samples;
  std::vector<Eigen::VectorXd> spectra;
  Eigen::Index last = options.Eigenpairs;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Progress part = progress.Part(
      0.05 + 0.15 * PartOf(i, count), 0.05 + 0.15 * PartOf(i + 1, count), "preparing the shapes");
    matched.push_back(
      PrepareMatching(surfaces[i].Surface, options.Eigenpairs, options.Landmarks, part));
    constexpr int enough = 500; // as for functional maps of pairs
    samples.push_back(SampleFarthestPoints(surfaces[i].Surface, enough));
    spectra.push_back(matched[i].Spectrum.Eigenvalues);
    last = std::min(last, matched[i].Spectrum.Eigenvalues.size());
  }
  const std::vector<std::array<int, 2>> graph =
    FindShapeGraph(CompareSpectra(spectra), options.Neighbours);
  const std::vector<CandidatePair> pairs =
    MatchPairs(matched, graph, options, sharing, progress.Part(0.2, 0.5, "finding maps of pairs"));
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
  const std::vector<SurfacePoints> images = ShareImages(fine, shapes.size(), central, sharing,
    [&](std::size_t i)
    {
      const Progress part = progress.Part(0.75 + 0.15 * PartOf(i, shapes.size()),
        0.75 + 0.15 * PartOf(i + 1, shapes.size()), "mapping the shapes");
      SurfaceMaps maps = RefineForPair(matched, samples, frames, i, central, part.Part(0.0, 0.4));
      const CoarsePair pair(fine[i], fine[central], {}, options.CoarsePoints);
      return options.Method == Options::MethodType::ReversibleHarmonic
        ? RefineReversibleHarmonicMap(pair, maps, {}, {}, part.Part(0.4, 1.0)).Maps.AToB
        : pair.OnFine(maps).AToB;
    });
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    result.Maps.push_back(
      i == central ? IdentityMaps(fine[i]) : WithInverse(fine[i], fine[central], images[i]));
  }
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
      working.push_back(surfaces[i].Surface);
      own.emplace_back(
        samples[i].begin(), samples[i].begin() + std::min(enough, samples[i].size()));
      starts.emplace_back();
      for (const int point : own[i])
      {
        starts[i].push_back(surfaces[i].Points[point]);
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
