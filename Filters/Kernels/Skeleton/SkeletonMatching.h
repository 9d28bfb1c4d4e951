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
  /// The largest share of a skeleton's length in short branches that may be left out, between 0 and
  /// 0.5, if the graphs then match better. With 0, the graphs must be isomorphic as they are.
  double LargestOmission = 0.1;
};

/// Throws InvalidInput if an option is out of range.
void RequireMatchingOptions(const SkeletonMatchingOptions& options);

/// The branches of a skeleton matched with those of another.
struct SkeletonMatching
{
  CurveSkeleton Skeleton;         ///< what is matched: the skeleton without what is left out
  std::vector<int> Numbers;       ///< for each of its branches, the first that it was made of
  std::vector<int> LeftOut;       ///< the branches that are left out
  std::vector<int> TargetLeftOut; ///< the target's branches that are left out
  /// For each branch of Skeleton, the branch of the target, or the first that its counterpart was
  /// made of; -1 for a branch between junctions that are matched as one.
  std::vector<int> Branches;
  std::vector<bool> Reversed;      ///< for each branch, whether the target's begins at its end
  Eigen::MatrixXd TargetPositions; ///< places of Skeleton's points on the target's skeleton
  std::vector<int> Ambiguous;      ///< branches that equally good matchings match in another way
  double Difference = 0.0;         ///< the sum over branches, junctions and changes
};

/**
 * Matches two skeletons as graphs: junctions with junctions of as many branches, ends with ends.
 * Every such isomorphism is compared (by branch and bound), and the one of least difference is
 * taken. Junctions whose balls overlap first become one junction, because the order in which
 * branches leave a thick part is not reliable.
 *
 * Two poses of a shape may differ by a short branch or by how near junctions are. So up to three
 * short branches of each skeleton may be left out, and junctions whose balls nearly overlap may be
 * merged, where that is better. Each change costs 0.05, and besides ten times the share of the
 * length that a branch reaches beyond the ball around its junction, or half of the gap between two
 * balls in parts of their radii. A matching is ambiguous, too, if another one with other changes is
 * as good and takes an end elsewhere.
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
