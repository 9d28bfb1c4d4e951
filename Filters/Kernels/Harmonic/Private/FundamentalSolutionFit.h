#pragma once

#include "Distance/SignedDistance.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Harmonic/Private/ScaledBoundary.h"

#include <vector>

namespace shape
{

/**
 * What the methods of the harmonic volume map share: boundary, targets and features scaled to unit
 * size, and the residual of the sum of the fitted maps at the positions that count.
 */
class FundamentalSolutionFit
{
public:
  /// Fits the affine part. Throws InvalidInput if a feature lies outside, Aborted.
  FundamentalSolutionFit(const ScaledBoundary& scaled, const VolumeFeatures& features,
    const HarmonicVolumeMapOptions& options, const Progress& progress);

  const Surface& Boundary() const { return this->Scaled.Surface; }        ///< longest side 1
  const Eigen::MatrixXd& Targets() const { return this->Scaled.Targets; } ///< longest side 1
  const SignedDistance& Distance() const { return this->Field; }
  bool HasFeatures() const { return this->RootWeights.size() > 0; }

  /// The residual of the present sum at `positions` that should go to `targets` (each k x 3).
  Eigen::MatrixXd Left(const Eigen::MatrixXd& positions, const Eigen::MatrixXd& targets,
    const Progress& progress) const;

  /// Appends the boundary's positions closest to `points` (n x 3) to those where maps are fitted.
  void Collocate(const Eigen::MatrixXd& points, const Progress& progress);
  int Collocations() const { return static_cast<int>(this->Positions.rows()); }

  /// Throws InvalidInput if a system of `boundaryRows` positions and `sources` charges is too
  /// large.
  void RequireMemory(int boundaryRows, int sources) const;

  /// Fits charges at `sources` to what is left over at the first `boundaryRows` collocations, each
  /// weighted by the area it stands for in its component (ComputeSampledAreas), and at the
  /// features.
  struct Fit
  {
    Eigen::MatrixXd Charges; ///< s x 3
    int Rows = 0;            ///< of the system
    /// The source that dominates each right singular vector below the threshold, ascending.
    std::vector<int> Redundant;
  };
  Fit Solve(int boundaryRows, const Eigen::MatrixXd& sources, const Progress& progress) const;

  /// Adds the charges to the sum, times the factor for each coordinate, at least 0, that leaves the
  /// least inside triangles and at features. Returns by how much less that is: its square root
  /// before and after, as a share of before; 0 where no factor is greater than 0.
  double Add(
    const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges, const Progress& progress);

  /// The up to `count` boundary points where most is left over, no two within `spacing`.
  Eigen::MatrixXd WorstPoints(int count, double spacing) const;

  /// The errors of the sum so far; the numbers of the system are the caller's.
  HarmonicVolumeMapResult::Level Errors() const;
  double FeatureError() const;

  /// The sum so far in the coordinates of the input.
  ChargeSet Map() const;

private:
  /// What the first `count` collocations stand for as a share of their component's mean: a small
  /// void counts by its points, of which it has enough, not by its area.
  Eigen::VectorXd GetCollocationAreas(int count) const;

  ScaledBoundary Scaled;
  SignedDistance Field;                   ///< of the scaled boundary
  std::vector<int> CollocationComponents; ///< of the collocations
  Eigen::VectorXd RootWeights;            ///< of the features
  Eigen::MatrixXd Probes;                 ///< boundary points, positions in triangles, features
  Eigen::MatrixXd Residual;               ///< at the probes
  Eigen::MatrixXd Positions;              ///< of the collocations
  Eigen::MatrixXd CollocationResidual;    ///< there
  ChargeSet Sum;                          ///< scaled
  double SumError = 0.0;                  ///< of evaluations, far below the tolerance
  double Threshold = 0.0, MaximumMemory = 0.0;
};

} // namespace shape
