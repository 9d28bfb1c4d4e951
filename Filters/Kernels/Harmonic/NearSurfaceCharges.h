#pragma once

#include "Distance/SignedDistance.h"
#include "Fmm/FmmSummation.h"
#include "Harmonic/SchwarzPreconditioner.h"
#include "Linear/Gmres.h"

#include <memory>

namespace shape
{

/// Charges close to a surface, each outside of the position (site) on it that it belongs to.
struct NearSurfaceCharges
{
  Eigen::MatrixXd Points;  ///< k x 3
  Eigen::VectorXi Sites;   ///< k, ascending: the row of its site
  Eigen::VectorXd Offsets; ///< k, > 0: the distance from its site
};

/**
 * A charge for each site on the normal, at the offset wanted there or as much nearer as it takes to
 * have at least 0.6 of its offset between it and any part of the surface: in narrow gaps. A site
 * with room for less than 0.24 of the offset, without a normal or with offset 0 gets none: charges
 * so close to the surface are spikes between its points.
 *
 * boundary: closed, facing out of the solid. sites: n x 3, on or near it. normals: n x 3, unit, or
 * zero. offsets: n, >= 0. Throws Aborted.
 */
NearSurfaceCharges InsertNearSurfaceCharges(const SignedDistance& boundary,
  const Eigen::MatrixXd& sites, const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets,
  const Progress& progress = {});

/**
 * The equations of charges that sit close to a surface, one outside of each of its points at about
 * the distance of the neighbouring points, and of a few coarse ones farther out. Set up once for a
 * surface, it solves for any number of boundary values.
 */
class NearSurfaceChargeSystem
{
public:
  /// More takes three times the time and memory. It converges where the surface's triangles are
  /// uneven, parts are thin, gaps are narrow, or little is left to be gained.
  enum class Effort
  {
    Little,
    More
  };
  /// boundary: closed, facing out of the solid, longest side 1. surface: the same surface or a
  /// refinement of it. Throws SolveFailure if no charge has room, Aborted.
  NearSurfaceChargeSystem(const SignedDistance& boundary, const Surface& surface,
    Effort effort = Effort::Little, const Progress& progress = {});

  /// m x 3: where values are wanted.
  const Eigen::MatrixXd& Rows() const { return this->System.Rows; }
  /// Of all charges, the coarse ones last: k x 3.
  const Eigen::MatrixXd& Sources() const { return this->AllSources; }
  /// How many points of the surface have no charge: in gaps too narrow, or without a normal.
  int PointsWithoutCharge() const { return this->WithoutCharge; }
  /// Of the charges that are closest to the boundary, but for one in a hundred.
  double Offset() const { return this->NearOffset; }

  /// Charges (Solution: k x 3) for values at Rows() (m x 3). Throws Aborted.
  GmresResult Solve(const Eigen::MatrixXd& values, const GmresOptions& options,
    const Progress& progress = {}) const;

  /// The potentials of charges (k x 3) at Rows(). Throws Aborted.
  Eigen::MatrixXd Values(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

private:
  TestedSystem System;
  Eigen::MatrixXd AllSources;
  double NearOffset = 0.0;
  int WithoutCharge = 0;
  std::unique_ptr<SchwarzPreconditioner> Preconditioner;
  std::unique_ptr<FmmSummation> Sums;
};

/// What is set up once for all targets of a boundary.
struct AcceleratedSetup
{
  Surface Boundary;
  std::unique_ptr<NearSurfaceChargeSystem> System;
};

} // namespace shape
