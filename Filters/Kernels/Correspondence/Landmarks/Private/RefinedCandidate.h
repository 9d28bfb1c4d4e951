#pragma once

#include "Base/Progress.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"
#include "Correspondence/Pair/ZoomOut.h"

#include <Eigen/Core>

namespace shape
{

/// A map of the samples of two surfaces, refined by functional maps.
struct RefinedCandidate
{
  Eigen::VectorXi AToB; ///< for each sample of A, the sample of B that is nearest to its image
  Eigen::VectorXi FeaturesToB; ///< the same for each feature of A
  ///@{
  /// How far the functional maps are from those of an isometry, for which these are 0. C takes the
  /// coefficients of functions on one surface to those on the other one, and L are the eigenvalues:
  /// |L C - C L| / |L| and |C'C - I| / |I|, means over both directions.
  double Commutativity = 0.0, Orthonormality = 0.0;
  ///@}
  /// The share of A's area that the map to B reverses (ComputeReversedArea). A map that exchanges
  /// left and right can keep the orientation of each extremity by exchanging front and back, too,
  /// but not where the extremities meet.
  double ReversedArea = 0.0;
  FunctionalMaps Maps = {}; ///< the refined functional maps
};

/// Refines candidate maps of two surfaces, so that they can be compared.
class CandidateRefinement
{
public:
  /// The number of eigenfunctions of a refined map, unless a surface has fewer.
  static constexpr int Functions = 60;
  /// a, b: surfaces with their eigenpairs, which are referred to.
  CandidateRefinement(const MatchedSurface& a, const MatchedSurface& b);

  /**
   * Refines a map by ZoomOut from 20 to 60 eigenfunctions. Functional maps of low frequency remove
   * noise of the images; as the frequency rises, a map that exchanges two sides of a shape that
   * differ in detail fits worse and worse.
   *
   * aToB: for each sample of A, the sample of B that is its image. bToA: the same from B. Throws
   * Aborted.
   */
  RefinedCandidate Refine(
    const Eigen::VectorXi& aToB, const Eigen::VectorXi& bToA, const Progress& progress = {}) const;

private:
  int Pairs; ///< the number of eigenpairs of each surface
  const MatchedSurface &A, &B;
};

} // namespace shape
