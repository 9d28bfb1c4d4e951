#pragma once

#include "Base/Progress.h"
#include "Skeleton/Private/BranchSearch.h"
#include "Skeleton/Private/GraphVariants.h"

#include <vector>

namespace shape
{

/// A variant of a skeleton and one of the target's, and their isomorphisms.
struct VariantMatches
{
  const GraphVariant* Own = nullptr;
  const GraphVariant* Target = nullptr;
  std::vector<GraphMatch> Found; ///< the best first
  double Difference = 0.0;       ///< of the best, with the costs of both variants
};

struct VariantSearchResult
{
  std::vector<VariantMatches> Pairs; ///< the best first; all that are as good within the tolerance
  bool Complete = true;              ///< whether all were compared
};

/// Compares every variant of a skeleton with every one of the target's, those of least cost first,
/// while they may be as good as the best one. The result refers to both lists. Throws Aborted.
VariantSearchResult FindVariantMatches(const std::vector<GraphVariant>& variants,
  const std::vector<GraphVariant>& targets, double tolerance, const Progress& progress = {});

} // namespace shape
