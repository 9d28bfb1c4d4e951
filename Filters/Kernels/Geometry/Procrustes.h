#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns points (n x 3) moved so that their weighted mean is 0.
Eigen::MatrixXd MoveToCentre(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights);

/// Returns the rotation of `points` that is nearest to `target`; both are centred.
Eigen::Matrix3d FitRotation(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& target, const Eigen::VectorXd& weights);

/// Returns the root of the weighted mean of the squared lengths of the rows.
double RootMeanSquare(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights);

/// N shapes in one position, orientation and, if asked for, size.
struct Superimposed
{
  std::vector<Eigen::MatrixXd> Shapes;    ///< n x 3 each, with the weighted mean 0
  Eigen::MatrixXd Mean;                   ///< n x 3: their mean
  std::vector<Eigen::Matrix3d> Rotations; ///< of each shape
  Eigen::VectorXd Sizes;  ///< N values: root mean square distance from the centre, as given
  Eigen::VectorXd Scales; ///< N values: the factor by which each shape was scaled
};

/**
 * Generalised Procrustes analysis (Gower, "Generalized Procrustes analysis", 1975): rotations to
 * the mean, and the mean of the rotated shapes, by turns until the mean is fixed to 1e-12 of its
 * size, in at most 100 rounds. The mean has the orientation that is nearest to the first shape.
 *
 * shapes: at least one, n x 3 each, with the same points in the same order. weights: n values >= 0
 * with a positive sum. scale: first scales each shape to the mean of the sizes (Rohlf and Slice,
 * "Extensions of the Procrustes method for the optimal superimposition of landmarks", 1990); no
 * size may be 0. Throws Aborted.
 */
Superimposed Superimpose(std::vector<Eigen::MatrixXd> shapes, const Eigen::VectorXd& weights,
  bool scale = false, const Progress& progress = {});

} // namespace shape
