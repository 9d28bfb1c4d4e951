#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Of functions (n x k) that increase away from k points, the sense of rotation in which these lie
 * around each of s points: the sine of the angle from the gradient of function i to that of
 * function j, seen from outside, in column i k + j of s x k^2 values. A mirror image has the
 * opposite signs. mesh: its triangles face outwards.
 */
Eigen::MatrixXd ComputeGradientOrientations(
  const Mesh& mesh, const Eigen::MatrixXd& functions, const std::vector<int>& points);

/**
 * Where each point of a surface lies among k of its points, in numbers that bending changes little:
 * the distances along the surface over the root of its area (ComputeHeatDistances), and a small
 * part of the ComputeGradientOrientations of every two of the first 12 of them. Points of two
 * surfaces that have rows near each other correspond where the k points do, on the same side of the
 * landmarks even if distances alone cannot tell: the back is not taken for the front.
 *
 * surface: of one component with a triangle at each point. Returns n x (k + pairs). Throws
 * SolveFailure, Aborted.
 */
Eigen::MatrixXd EmbedByLandmarks(
  const Surface& surface, const std::vector<int>& landmarks, const Progress& progress = {});

/// The same with distances over a length that is given, for surfaces of unlike extent.
Eigen::MatrixXd EmbedByLandmarks(const Surface& surface, const std::vector<int>& landmarks,
  double length, const Progress& progress = {});

/// The same numbers of distances (s x k) and the ComputeGradientOrientations of all or the first of
/// them, for some of the landmarks. turnSign: 1, or -1 for the mirror image.
Eigen::MatrixXd EmbedByDistances(const Eigen::MatrixXd& distances, const Eigen::MatrixXd& turns,
  const std::vector<int>& chosen, double turnSign);

} // namespace shape
