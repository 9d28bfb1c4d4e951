#pragma once

#include "Base/Progress.h"
#include "Fmm/SumDevice.h"

#include <Eigen/Core>
#include <memory>

namespace shape
{

struct FmmSummationOptions
{
  enum class MethodType
  {
    Automatic, ///< the method expected to take less time
    Direct,    ///< DirectSummation.h: accurate to rounding
    Multipole
  };
  MethodType Method = MethodType::Automatic;
  /// Relative error of the multipole method, from MinimumTolerance to 0.1. It is the root mean
  /// square error of the potential over the points, divided by the root mean square of the
  /// potential of the absolute charges. At a single point, the error divided by the potential of
  /// the absolute charges there is at most a hundred times Tolerance. For gradients, the root mean
  /// square error is divided by the root mean square of the sums of |q| / (4 pi r^2). This ratio is
  /// at most fifty times Tolerance.
  double Tolerance = 1e-6;
  static constexpr double MinimumTolerance = 2e-12;
  /// If the points are distributed over processes, the number of all of them; Automatic then
  /// chooses the same method on every process. 0: the points given are all.
  Eigen::Index AllPoints = 0;
  /// Where the sums of the direct method, and those of the multipole method over near sources, are
  /// computed. The choice of the method does not depend on it.
  SumDevice Device;
  /// Multipole: multiplies the number of sources in a box; >= 1. If there are more sources than
  /// points, their ratio is best: a sum of 113,000 sources at 38,000 points, with a tolerance of
  /// 1e-8, took 1.4 CPU seconds with 1, and 0.8 with 3.
  double LargerBoxes = 1.0;
};

/**
 * Computes the potentials of point charges, phi(y_i) = sum_j q_j / (4 pi |y_i - x_j|), for many
 * sets of charges at the same positions, in time O(m + n). It is a kernel-independent fast
 * multipole method (L. Ying, G. Biros, D. Zorin, J. Comput. Phys. 196, 2004; see FmmOperators.h and
 * FmmTree.h).
 *
 * This is the entry point of the library shape_fmm, which does not depend on surfaces or meshes: it
 * needs only Base and Linear. Link shape_fmm, include this header, and write
 *
 *     const shape::FmmSummation sum(sources, points);             // m x 3 and n x 3 coordinates
 *     const Eigen::MatrixXd potentials = sum.Potentials(charges); // of m x k charges: n x k
 *
 * For tolerances of 1e-6 or more, the constructor takes about a third of the time of a sum. For
 * smaller tolerances, it takes at least as long as a sum. With the methods Direct and Multipole,
 * the values at a point have the same bits for any number of threads and, on the same device, for
 * any set of other points. The points may therefore be distributed over processes. The values at a
 * point that coincides with a source are not finite. Points and sources may lie anywhere.
 */
class FmmSummation
{
public:
  /// sources: m x 3, the x_j. points: n x 3, the y_i. Throws InvalidInput if a coordinate is not
  /// finite or the tolerance is out of range; Aborted.
  FmmSummation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
    const FmmSummationOptions& options = {}, const Progress& progress = {});
  ~FmmSummation();
  FmmSummation(FmmSummation&&) noexcept;
  FmmSummation& operator=(FmmSummation&&) noexcept;

  /// Computes the potentials of charges (m x k; each column gives one potential). Returns n x k
  /// potentials. Throws InvalidInput if the number of rows is not m or there is no such device
  /// (ChooseOpenCL); Aborted.
  Eigen::MatrixXd Potentials(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

  /// Computes the gradients of the same potentials. Returns n x 3k: column 3 r + c is
  /// d phi_r / d y_c. Throws the same exceptions as Potentials.
  Eigen::MatrixXd Gradients(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace shape
