#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/ZoomOut.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Two shapes of a collection, and the maps that are possible between them.
struct CandidatePair
{
  int A = 0, B = 0; ///< numbers of the shapes
  /// The best one first; at least k functions each. The others of a pair are ignored.
  std::vector<FunctionalMaps> Maps;
  std::vector<double> Errors; ///< for each map, > 0: AutomaticLandmarksResult::Error
};

/// Maps of all shapes to one space of latent functions.
struct CandidateChoice
{
  /// For each shape a k x k matrix Y: a column holds the coefficients of a latent function on this
  /// shape.
  std::vector<Eigen::MatrixXd> Frames;
  std::vector<int> Chosen; ///< for each pair, its candidate that agrees best; -1 if it has none
  /// For each pair, |C Y_A - Y_B| / sqrt(k), a mean over both directions: 0 if the map agrees with
  /// all others, and sqrt(2) for an unrelated one, or one that exchanges two sides.
  Eigen::VectorXd Disagreements;
  std::vector<int> Tree; ///< pairs that connect all shapes, the root first
};

/// A pair with a larger disagreement is dropped: half of that of an unrelated map.
inline constexpr double LargestDisagreement = 0.70710678118654752;

/**
 * Chooses one candidate map for each pair, so that the maps around the cycles of the collection
 * agree (cycle consistency: Huang, Wang and Guibas, "Functional map networks for analyzing and
 * exploring large shape collections", 2014).
 *
 * A pair alone cannot decide between two maps of nearly equal error, such as the one that exchanges
 * left and right. All pairs of a shape decide together: the frames Y minimise the sum, over the
 * pairs, of
 *
 *   min over candidates c of log(Error_c / Error_0) + 2 min(|C_c Y_A - Y_B|^2 / k, 2).
 *
 * The start is the spanning tree of the pairs whose best map is the most certain one. Then, by
 * turns, the map of one pair of the tree is exchanged, with all shapes behind it, and the frame of
 * one shape is replaced by what one of its pairs says, while the sum decreases.
 *
 * shapes: number of shapes; the pairs with candidates connect all of them. k: number of functions.
 * Throws InvalidInput if they do not connect them; Aborted.
 */
CandidateChoice ChooseCandidates(int shapes, const std::vector<CandidatePair>& pairs,
  Eigen::Index k, const Progress& progress = {});

/**
 * Averages maps: returns frames Y with sum of Y' Y = N I that nearly minimise the sum of w |C Y_A -
 * Y_B|^2 over pairs and directions, by power iteration from the frames along the tree (the latent
 * basis of a limit shape: Huang, Ren, Wonka and Ovsjanikov, "Consistent ZoomOut", 2020, equation
 * 4). maps: k x k for each pair. weights: for each pair, >= 0. tree: CandidateChoice::Tree.
 */
std::vector<Eigen::MatrixXd> AverageFrames(int shapes, const std::vector<CandidatePair>& pairs,
  const std::vector<FunctionalMaps>& maps, const Eigen::VectorXd& weights,
  const std::vector<int>& tree);

} // namespace shape
