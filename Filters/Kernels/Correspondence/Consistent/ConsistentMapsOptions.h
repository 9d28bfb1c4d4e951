#pragma once

#include "Correspondence/Landmarks/AutomaticLandmarks.h"

#include <functional>
#include <map>
#include <vector>

namespace shape
{

/// Points of a surface by number. Those of two surfaces with the same number correspond.
using NumberedPoints = std::map<int, int>;

struct ConsistentMapsOptions
{
  /// How the maps of pairs become maps onto one template.
  enum class ConsistencyType
  {
    None,      ///< each shape is matched with the template alone
    LimitShape ///< pairs of similar shapes are matched, and their maps are made consistent
  };
  ConsistencyType Consistency = ConsistencyType::LimitShape;
  /// The method of the maps onto the template.
  enum class MethodType
  {
    /// Nearest rows of the functional maps, which the last iterations of
    /// RefineReversibleHarmonicMap make smooth.
    FunctionalMap,
    ReversibleHarmonic ///< RefineReversibleHarmonicMap, from the nearest rows
  };
  MethodType Method = MethodType::FunctionalMap;
  /// LimitShape: each shape is matched with this many others, at least; those with the most similar
  /// spectrum. >= 2.
  int Neighbours = 6;
  /// LimitShape: of each pair, this many different maps of FindLandmarks are compared; >= 1.
  int Candidates = 4;
  int Eigenpairs = 120;    ///< maximum number of eigenfunctions of each surface; >= 20
  int CoarsePoints = 8000; ///< larger surfaces are matched on a coarse copy; 0: none is; or >= 100
  AutomaticLandmarksOptions Landmarks; ///< Rank is not used
  /// The landmarks of each shape and, at the end, of a given template; empty: none. A pair with
  /// three common numbers or more has one map, which follows from these. On the template, each
  /// landmark is mapped to its partner exactly.
  std::vector<NumberedPoints> Numbered;
};

/// The processes that share the pairs, and then the maps onto the template: each computes every
/// Processes-th one.
struct PairSharing
{
  int Process = 0, Processes = 1;
  /// Calls its argument. If that throws on one process, it throws on all.
  std::function<void(const std::function<void()>&)> Run;
  /// Adds the values of all processes, which is the result on each.
  std::function<void(double* values, int count)> Sum;
};

} // namespace shape
