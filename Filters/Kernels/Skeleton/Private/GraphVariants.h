#pragma once

#include "Skeleton/CurveSkeleton.h"
#include "Skeleton/Private/BranchGraph.h"

#include <vector>

namespace shape
{

/// A skeleton without some of its short branches, and its graph with some of its junctions merged.
struct GraphVariant
{
  CurveSkeleton Skeleton;   ///< what is left; points that no branch has are gone
  std::vector<int> Points;  ///< for each point that is left, the point of the skeleton
  std::vector<int> Numbers; ///< for each branch that is left, the first one that it was made of
  std::vector<int> LeftOut; ///< the branches that are not in it
  BranchGraph Graph;
  double Cost = 0.0; ///< how far the variant is from the skeleton; 0 for itself
};

/**
 * Returns the variants of a skeleton, itself first, then by cost.
 *
 * Skeletons of the same shape in two poses may differ by a short branch, as at a heel, and by how
 * far the junctions in a thick part are from each other. So a variant leaves out up to three of the
 * six branches that reach least far out of the ball around their junction, and merges junctions
 * whose balls nearly overlap.
 *
 * largestOmission: the largest share of the skeleton's length that is left out; 0: nothing is, and
 * no more junctions are merged than MakeBranchGraph does.
 */
std::vector<GraphVariant> MakeVariants(const CurveSkeleton& skeleton, double largestOmission);

} // namespace shape
