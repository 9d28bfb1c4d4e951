#pragma once

#include "Geometry/SignedDistance.h"
#include "Volume/ScaledBoundary.h"

namespace shape
{

/**
 * What the methods of the harmonic volume map share: boundary, targets and features scaled to unit
 * size, and what the sum of the maps fitted so far leaves over at the places that count.
 */
class BoundaryProblem
{
public:
  /// Fits the affine part. Throws InvalidInput where a feature lies outside, Aborted.
  BoundaryProblem(const ScaledBoundary& scaled, const VolumeFeatures& features,
    const HarmonicVolumeMapOptions& options, const Progress& progress);

  /// Places on the boundary and what is left over there.
  struct Collocations
  {
    Eigen::MatrixXd Points;   ///< c x 3
    Eigen::MatrixXd Residual; ///< c x 3
  };

  const Mesh& Boundary() const { return this->Scaled.Surface; } ///< longest side 1
  const SignedDistance& Distance() const { return this->Field; }

  /// Places on the boundary closest to `points`, with what the sum so far leaves over there.
  Collocations PlacesOnBoundary(const Eigen::MatrixXd& points, const Progress& progress) const;

  /// Throws InvalidInput where a system of `boundaryRows` places and `sources` charges is too
  /// large.
  void RequireMemory(int boundaryRows, int sources) const;

  /// Fits charges at `sources` to the residual at `places` and at the features.
  struct Fit
  {
    Eigen::MatrixXd Charges; ///< s x 3
    int Rows = 0;            ///< of the system
    /// The source that dominates each right singular vector below the threshold, ascending.
    std::vector<int> Redundant;
  };
  Fit Solve(
    const Collocations& places, const Eigen::MatrixXd& sources, const Progress& progress) const;

  /// Adds the charges to the sum, times the factor for each coordinate, at least 0, that leaves the
  /// least at centroids and features, weighted as in a system of `boundaryRows` boundary rows;
  /// returns whether one of the factors was greater than 0.
  bool Add(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges, int boundaryRows,
    const Progress& progress);

  /// The up to `count` boundary points where most is left over, no two within `spacing`.
  Eigen::MatrixXd WorstPoints(int count, double spacing) const;

  /// The errors of the sum so far; the numbers of the system are the caller's.
  HarmonicVolumeMapResult::Level Errors() const;
  double FeatureError() const;

  /// The sum so far in the coordinates of the input.
  ChargeSet Map() const;

private:
  ScaledBoundary Scaled;
  SignedDistance Field;        ///< of the scaled boundary
  Eigen::VectorXd RootWeights; ///< of the features
  Eigen::MatrixXd Probes;      ///< boundary points, centroids, features
  Eigen::MatrixXd Residual;    ///< at the probes
  ChargeSet Sum;               ///< scaled
  double Threshold = 0.0, MaximumMemory = 0.0;
};

} // namespace shape
