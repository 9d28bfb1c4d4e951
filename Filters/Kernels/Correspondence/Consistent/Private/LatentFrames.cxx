#include "Correspondence/Consistent/Private/LatentFrames.h"

#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

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

} // namespace

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
      part(static_cast<double>(p) / static_cast<double>(pairs.size()));
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

} // namespace shape
