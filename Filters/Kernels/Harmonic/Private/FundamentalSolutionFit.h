#pragma once

#include "Base/Processes.h"
#include "Base/SharedRows.h"
#include "Distance/SignedDistance.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Harmonic/Private/ScaledBoundary.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * State shared by the methods of the harmonic volume map: boundary, targets and features scaled to
 * unit size, and the residual of the sum of the maps fitted so far.
 */
class FundamentalSolutionFit
{
public:
  /// Fits the affine part. Several processes share the residual; then there must be no features.
  /// Throws InvalidInput if a feature lies outside the boundary; Aborted.
  FundamentalSolutionFit(const ScaledBoundary& scaled, const VolumeFeatures& features,
    const HarmonicVolumeMapOptions& options, const shape::Processes& processes,
    const Progress& progress);

  const Surface& Boundary() const { return this->Scaled.Surface; }        ///< longest side 1
  const Eigen::MatrixXd& Targets() const { return this->Scaled.Targets; } ///< longest side 1
  /// Returns the signed distance of the boundary. One process keeps it. Several processes share
  /// memory because it is scarce: each call makes it anew, and it is freed after use.
  std::shared_ptr<const SignedDistance> Distance();
  bool HasFeatures() const { return this->RootWeights.size() > 0; }

  /// Returns the residual of the sum so far: `targets` minus the values of the sum at `positions`
  /// (each k x 3).
  Eigen::MatrixXd Left(const Eigen::MatrixXd& positions, const Eigen::MatrixXd& targets,
    const Progress& progress) const;

  /// Appends the boundary positions closest to `points` (n x 3) to the collocation points.
  void Collocate(const Eigen::MatrixXd& points, const Progress& progress);
  int Collocations() const { return static_cast<int>(this->Positions.rows()); }

  /// Throws InvalidInput if a system of `boundaryRows` collocation points and `sources` charges is
  /// too large.
  void RequireMemory(int boundaryRows, int sources) const;

  /// The charges fitted at `sources` to the residual at the first `boundaryRows` collocation points
  /// and at the features. Each collocation point is weighted by the area it represents
  /// (GetCollocationAreas).
  struct Fit
  {
    Eigen::MatrixXd Charges; ///< s x 3
    int Rows = 0;            ///< number of rows of the system
    /// Indices of redundant sources, ascending, without repeats: for each right singular vector
    /// below the threshold, the source with its largest entry.
    std::vector<int> Redundant;
  };
  Fit Solve(int boundaryRows, const Eigen::MatrixXd& sources, const Progress& progress) const;

  /// Adds the charges to the sum, multiplied by one factor >= 0 for each coordinate. The factors
  /// minimize the residual inside triangles and at features.
  struct Added
  {
    Eigen::RowVector3d Factors;
    /// relative decrease of the root of the summed squared residual; 0 if no factor is positive
    double Gain = 0.0;
  };
  Added Add(
    const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges, const Progress& progress);

  /// Returns up to `count` boundary points with the largest residual; any two are farther than
  /// `spacing` apart.
  Eigen::MatrixXd WorstPoints(int count, double spacing) const;

  /// Returns a level with the errors of the sum so far. The caller sets the other members.
  HarmonicVolumeMapResult::Level Errors() const;
  double FeatureError() const;

  /// Returns the sum so far in the coordinates of the input.
  ChargeSet Map() const;

private:
  /// Returns the area that each of the first `count` collocation points represents
  /// (ComputeSampledAreas), divided by its mean over the component. The total weight of a small
  /// void is therefore its number of points, not its area.
  Eigen::VectorXd GetCollocationAreas(int count) const;

  ScaledBoundary Scaled;
  shape::Processes Processes;
  std::shared_ptr<const SignedDistance> Field; ///< Distance(), or null
  std::vector<int> CollocationComponents;      ///< component of each collocation point
  Eigen::VectorXd RootWeights;                 ///< square roots of the feature weights
  /// Points of the boundary, then one point in each triangle, then feature points. Of the first
  /// two, those of this process.
  Eigen::MatrixXd Probes;
  SharedRows Shared;                   ///< the probes: three groups
  Eigen::MatrixXd Residual;            ///< residual at the probes
  Eigen::MatrixXd Positions;           ///< collocation points
  Eigen::MatrixXd CollocationResidual; ///< residual at the collocation points
  ChargeSet Sum;                       ///< the sum so far, in scaled coordinates
  double SumError = 0.0;               ///< error of evaluations, far below the tolerance
  SumDevice Device;                    ///< of evaluations
  double Threshold = 0.0, MaximumMemory = 0.0;
};

} // namespace shape
