#pragma once

#include "Base/Progress.h"
#include "Skeleton/CurveSkeleton.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct SkeletonMatchingOptions
{
  /// What is done if two matchings are equally good.
  enum class AmbiguityType
  {
    Refuse, ///< InvalidInput, which names the branches
    First   ///< the best one, of equal ones the first in the order of the branches' numbers
  };
  AmbiguityType Ambiguous = AmbiguityType::Refuse;
  /// Another matching is as good if its difference exceeds the least by no more than this; > 0. 0.2
  /// is, for example, two branches exchanged whose lengths differ by a tenth.
  double Tolerance = 0.2;
  /// The largest difference between two branches that match, > 0. 1 is a factor of 2.7 in length
  /// or radius.
  double LargestDifference = 1.0;
};

/// Throws InvalidInput if an option is out of range.
void RequireMatchingOptions(const SkeletonMatchingOptions& options);

/// The branches of a skeleton matched with those of another.
struct SkeletonMatching
{
  /// For each branch, the branch of the target; -1 for a branch between junctions whose balls
  /// overlap, which are matched as one.
  std::vector<int> Branches;
  std::vector<bool> Reversed;      ///< for each branch, whether the target's begins at its end
  Eigen::MatrixXd TargetPositions; ///< n x 3: the places of the points on the target's skeleton
  std::vector<int> Ambiguous;      ///< branches that equally good matchings match in another way
  double Difference = 0.0;         ///< the sum over branches and junctions
};

/**
 * Matches two skeletons as graphs: junctions with junctions of as many branches, ends with ends.
 * Every such isomorphism is compared (by branch and bound), and the one of least difference is
 * taken. Junctions whose balls overlap first become one junction, because the order in which
 * branches leave a thick part is not reliable.
 *
 * The difference is a sum. For each pair of branches it has the absolute logarithm of the ratio of
 * lengths, each as a share of the skeleton's length, and the mean absolute logarithm of the ratio
 * of radii along the branches. For each pair of junctions it has twice the mean, over triples of
 * branches that turn the other way, of the volume that their unit directions span. Only triples
 * count that are far from a plane in both shapes (volume above 0.6): so left and right are told
 * apart, unless limbs swing through a plane. Scale, position and rotation do not matter.
 *
 * The points of a branch go to the same fraction of the arc length of its counterpart.
 *
 * Throws InvalidInput if the graphs are not isomorphic, if two branches that match differ by more
 * than LargestDifference, if the matching is ambiguous and Ambiguous is Refuse, or if an option is
 * out of range; Aborted. A cycle without a junction is always ambiguous, because it has no
 * beginning.
 */
SkeletonMatching MatchSkeletons(const CurveSkeleton& skeleton, const CurveSkeleton& target,
  const SkeletonMatchingOptions& options = {}, const Progress& progress = {});

} // namespace shape
