#pragma once

#include "Base/SharedRows.h"
#include "Distance/SignedDistance.h"
#include "Fmm/FmmSummation.h"
#include "Harmonic/SchwarzPreconditioner.h"
#include "Linear/Gmres.h"

#include <memory>

namespace shape
{

/// Charges close to a surface. Each lies outside a position on the surface, called its site.
struct NearSurfaceCharges
{
  Eigen::MatrixXd Points;  ///< k x 3
  Eigen::VectorXi Sites;   ///< k, ascending: the row of each charge's site
  Eigen::VectorXd Offsets; ///< k, > 0: the distance of each charge from its site
};

/**
 * Places one charge on the normal of each site, at the given offset. In a narrow gap the offset is
 * reduced until the charge's distance from every part of the surface is at least 0.6 of the reduced
 * offset. A site gets no charge if the offset would have to be less than 0.24 of the given one. The
 * field of a charge so close to the surface is a spike between the surface's points. A site also
 * gets no charge if its normal or its offset is zero.
 *
 * boundary: closed, facing out of the solid. sites: n x 3, on or near the boundary. normals: n x 3,
 * each a unit vector or zero. offsets: n values, each >= 0. Throws Aborted.
 */
NearSurfaceCharges InsertNearSurfaceCharges(const SignedDistance& boundary,
  const Eigen::MatrixXd& sites, const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets,
  const Progress& progress = {});

/**
 * The linear system for charges close to a surface. One charge lies outside each surface point, at
 * a given multiple of the spacing of the points. A few coarse charges lie farther out. The system
 * is set up once for a surface, and can then be solved for any number of sets of boundary values.
 */
class NearSurfaceChargeSystem
{
public:
  /// More takes three times the time and memory of Little. It converges even if triangles are
  /// uneven, parts of the solid are thin, gaps are narrow, or the residual is already small. Exact
  /// is for SolveAverages and SolveTransposed: its sums are accurate to 1e-8, in both directions.
  enum class Effort
  {
    Little,
    More,
    Exact
  };
  /// boundary: closed, facing out of the solid, with longest side 1; it is let go as soon as the
  /// charges have their positions. surface: the boundary, or a refinement of it. chargeDistance:
  /// HarmonicVolumeMapOptions::ChargeDistance. Throws SolveFailure if no charge has room; Aborted.
  /// Several processes share the rows and the preconditioner. device: where sums over charges are
  /// computed; solving throws InvalidInput if there is no such device.
  NearSurfaceChargeSystem(std::shared_ptr<const SignedDistance> boundary, const Surface& surface,
    double chargeDistance, Effort effort = Effort::Little, const shape::Processes& processes = {},
    const SumDevice& device = {}, const Progress& progress = {});

  /// Positions where values are prescribed: m x 3, this process's share of the surface's points,
  /// and then its share of the triangles' centroids.
  const Eigen::MatrixXd& Rows() const { return this->Positions; }
  /// The distribution of the rows: those of the points, and those of the triangles.
  const SharedRows& Shares() const { return this->Shared; }
  /// Positions of all charges, k x 3; the coarse charges come last.
  const Eigen::MatrixXd& Sources() const { return this->AllSources; }
  /// Number of surface points without a charge, because a gap is too narrow or the point has no
  /// normal.
  int PointsWithoutCharge() const { return this->WithoutCharge; }
  /// Minimum offset of the charges after the smallest 1 % of the offsets are left out.
  double Offset() const { return this->NearOffset; }

  /// Returns the charges (Solution: k x 3) whose potentials approximate `values` (m x 3) at Rows().
  /// Throws Aborted.
  GmresResult Solve(const Eigen::MatrixXd& values, const GmresOptions& options,
    const Progress& progress = {}) const;

  ///@{
  /**
   * A linear solution operator, and its transpose, on one process with Effort Exact. SolveAverages
   * returns the charges (Solution: k x 3) whose potentials have the same average around each
   * charge's site as `values` (m x 3): with the averages T, the potentials A and the preconditioner
   * B, they are B (T A B)^-1 T values. SolveTransposed applies the transpose of this matrix to k x
   * 3 values and returns m x 3 values (Solution), by sums of the same size. Its sums are less
   * accurate as its residual falls; its residuals are relative. Both are linear up to the tolerance
   * of `options`. Throw Aborted.
   */
  GmresResult SolveAverages(const Eigen::MatrixXd& values, const GmresOptions& options,
    const Progress& progress = {}) const;
  GmresResult SolveTransposed(const Eigen::MatrixXd& charges, const GmresOptions& options,
    const Progress& progress = {}) const;
  ///@}

  /// Returns the potentials of `charges` (k x 3) at Rows(), m x 3. Throws Aborted.
  Eigen::MatrixXd Values(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

private:
  Eigen::VectorXd AverageWeights() const;

  SharedRows Shared;         ///< the rows
  Eigen::MatrixXd Positions; ///< Rows()
  Eigen::VectorXd Weights;   ///< of Rows(); the sum over all processes is 1
  /// The averages around the sites, if Exact.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests;
  Eigen::MatrixXd AllSources;
  double NearOffset = 0.0;
  int WithoutCharge = 0;
  std::unique_ptr<SchwarzPreconditioner> Preconditioner;
  std::unique_ptr<FmmSummation> Sums;
  ///@{
  /// From the rows to the charges, if Exact. The relaxed ones are for small residuals.
  std::unique_ptr<FmmSummation> TransposedSums, RelaxedSums;
  ///@}
};

/// A boundary and its system, which can be reused for other targets of the same boundary.
struct AcceleratedSetup
{
  shape::Processes Processes; ///< share the system
  Surface Boundary;
  double ChargeDistance = 0.0;
  SumDevice::KindType Device = SumDevice::KindType::Processor;
  std::unique_ptr<NearSurfaceChargeSystem> System;
};

} // namespace shape
