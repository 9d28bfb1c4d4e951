#pragma once

#include "Base/Progress.h"
#include "Correspondence/Landmarks/FeaturedSurface.h"
#include "Correspondence/Pair/ZoomOut.h"
#include "Mesh/Surface.h"
#include "Spectrum/LaplaceEigenproblem.h"

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
};

/// Refines candidate maps of two surfaces, so that they can be compared.
class CandidateRefinement
{
public:
  /// a, b: the surfaces, with their featured samples. Computes the 60 smallest eigenpairs of each,
  /// or as many as there are points. Throws SolveFailure, Aborted.
  CandidateRefinement(const Surface& a, const FeaturedSurface& onA, const Surface& b,
    const FeaturedSurface& onB, const Progress& progress = {});

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
  struct Side
  {
    /// Of area 1.
    shape::Surface Surface;
    LaplaceEigenpairs Spectrum;
    const std::vector<int>&Features, &Samples;

    Eigen::MatrixXd At(const std::vector<int>& points, Eigen::Index functions) const
    {
      return this->Spectrum.Eigenfunctions(points, Eigen::seqN(0, functions));
    }
    SampledSpectrum Sampled() const
    {
      return { this->Surface.Triangles(), this->Spectrum, this->Samples };
    }
  };
  static Side Prepare(
    const Surface& surface, const FeaturedSurface& featured, int pairs, const Progress& progress);

  int Pairs; ///< the number of eigenpairs of each surface
  Side A, B;
};

} // namespace shape
