#pragma once

namespace shape
{

/// Limits of ExpandInverted.
struct ConeExpansionOptions
{
  bool SplitCells = true; ///< if false, no point is inserted
  /// Maximum number of inserted points, as a multiple of the number of points of the cluster
  double MaximumSplits = 0.5;
  /// Maximum number of cells that are looked at, each time, and faces in all linear programmes, for
  /// all clusters. The time is in proportion to it.
  double MaximumWork = 3e7;
  /// How often a cluster that does not expand is enlarged and expanded again.
  int MaximumAttempts = 16;
};

struct ConeExpansionResult
{
  int Expansions = 0; ///< number of points that were moved out of a cluster
};

} // namespace shape
