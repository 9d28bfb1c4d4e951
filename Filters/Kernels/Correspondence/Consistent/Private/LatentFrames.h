#pragma once

#include "Base/Progress.h"
#include "Correspondence/Consistent/Private/CandidateChoice.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The number of latent functions of the first frames, and of those by which shapes are compared.
inline constexpr int FirstFunctions = 20;

/**
 * Consistent ZoomOut (see ComputeConsistentMaps): refines frames from few latent functions to
 * `last`, 10 more in each step.
 *
 * samples: points of each shape. pairs, weights: the maps between the shapes; pairs of weight 0 are
 * ignored. tree, frames: those of ChooseCandidates. last: at most the number of eigenfunctions of
 * each shape. Throws Aborted.
 */
std::vector<Eigen::MatrixXd> RefineFrames(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::vector<int>>& samples, const std::vector<CandidatePair>& pairs,
  const Eigen::VectorXd& weights, const std::vector<int>& tree, std::vector<Eigen::MatrixXd> frames,
  Eigen::Index last, const Progress& progress = {});

/// Returns which of the first `count` shapes is central: its products of latent functions (Y' Y and
/// Y' L Y, with the eigenvalues L) differ least from those of the others.
int FindCentral(const std::vector<MatchedSurface>& shapes,
  const std::vector<Eigen::MatrixXd>& frames, std::size_t count);

} // namespace shape
