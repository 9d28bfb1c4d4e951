#pragma once

#include "Geometry/SignedDistance.h"
#include "Volume/FastSummation.h"
#include "Volume/Gmres.h"
#include "Volume/SchwarzPreconditioner.h"

#include <memory>

namespace shape
{

/**
 * The equations of charges that sit close to a surface, one outside of each of its points at about
 * the distance of the neighbouring points, and of a few coarse ones farther out. Set up once for a
 * surface, it solves for any number of boundary values.
 */
class NearSourceSystem
{
public:
  enum class Kind
  {
    Square,      ///< meets the values at the points that have a charge
    LeastSquares ///< the least at points and triangle centroids, by area
  };

  /// boundary: closed, facing out of the solid, longest side 1. surface: the same surface or a
  /// refinement of it. offset: of the charges / the spacing of the points, > 0. tolerance: of the
  /// sums, see FastSummation. Throws SolveFailure where no charge has room, Aborted.
  NearSourceSystem(const SignedDistance& boundary, const Mesh& surface, Kind kind, double offset,
    double tolerance, const Progress& progress = {});

  /// m x 3: where values are wanted.
  const Eigen::MatrixXd& Rows() const { return this->System.Rows; }
  /// Of all charges, the coarse ones last: k x 3.
  const Eigen::MatrixXd& Sources() const { return this->AllSources; }
  int Shrunk() const { return this->ShrunkSources; }

  /// Charges (Solution: k x 3) for values at Rows() (m x 3). Throws Aborted.
  GmresResult Solve(const Eigen::MatrixXd& values, const GmresOptions& options,
    const Progress& progress = {}) const;

private:
  TestedSystem System;
  Eigen::MatrixXd AllSources;
  int ShrunkSources = 0;
  std::unique_ptr<SchwarzPreconditioner> Preconditioner;
  std::unique_ptr<FastSummation> Sums;
};

} // namespace shape
