#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// What is known of a map, besides landmarks, and guides ComputeFunctionalMap.
struct FunctionalGuide
{
  ///@{
  /// Functions of the points of A and of B, a column each, whose columns correspond: n_A x q, n_B x
  /// q.
  Eigen::MatrixXd DescriptorsOfA, DescriptorsOfB;
  ///@}
  /// Corresponding curves, each as the pairs of its points.
  std::vector<Landmarks> Curves;
  ///@{
  /// The vectors by which the points of A and of B are displaced (n_A x 3, n_B x 3), in the units
  /// of the surfaces; empty: along the unit normals. See FitFunctionalMap.
  Eigen::MatrixXd DisplacementsOfA, DisplacementsOfB;
  ///@}
  /// An initial functional map from A to B, k_B x k_A; empty: it is fitted.
  Eigen::MatrixXd Matrix;
  ///@{
  /// The bases of Matrix: functions of the points, n_A x k_A and n_B x k_B, orthonormal if each
  /// surface is scaled to area 1.
  Eigen::MatrixXd BasisOfA, BasisOfB;
  ///@}

  bool HasDescriptors() const { return this->DescriptorsOfA.cols() > 0 || !this->Curves.empty(); }
};

/// Throws InvalidInput unless the matrix is finite and not empty.
void RequireFunctionalMap(const Eigen::MatrixXd& matrix);

/// Sets the bases to the first eigenfunctions of the surfaces, and divides Matrix by the ratio of
/// their lengths: on input, it refers to SolveLaplaceEigenproblem's bases of the given surfaces, as
/// FunctionalMatrix does. Throws InvalidInput if RequireFunctionalMap does or if Matrix has more
/// rows than B has points that triangles use, or more columns than A; SolveFailure; Aborted.
FunctionalGuide WithEigenbases(
  FunctionalGuide guide, const Surface& a, const Surface& b, const Progress& progress = {});

/// Restricts the functions to some points of the surfaces, and numbers the curves by them. pointsA,
/// pointsB: for each point that is left, its index; ascending, with every point of the curves.
FunctionalGuide AtPoints(
  const FunctionalGuide& guide, const std::vector<int>& pointsA, const std::vector<int>& pointsB);

/// Restricts a guide to the points of the coarse surfaces of a pair, which must have kept the
/// points of the curves.
FunctionalGuide OnCoarse(const FunctionalGuide& guide, const CoarsePair& pair);

/// The regions of a surface.
struct SurfaceRegions
{
  Eigen::VectorXi Ids;   ///< of each triangle or each point
  bool OfPoints = false; ///< whether Ids has an entry for each point
};

/// Indicator functions of corresponding regions.
struct RegionIndicators
{
  ///@{
  /// n_A x q, n_B x q: a column for each id that is on both surfaces, ascending. The value at a
  /// point is 1 in the region and 0 outside; if the regions consist of triangles, it is the share
  /// of the area around the point that belongs to the region.
  Eigen::MatrixXd OfA, OfB;
  ///@}
};

/// Computes the indicators of regions that have the same id on both surfaces. Throws InvalidInput
/// if no id is on both surfaces.
RegionIndicators ComputeRegionIndicators(const Surface& a, const SurfaceRegions& regionsOfA,
  const Surface& b, const SurfaceRegions& regionsOfB);

} // namespace shape
