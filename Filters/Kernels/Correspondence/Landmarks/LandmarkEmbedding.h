#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Computes the sense of rotation in which k points lie around each of s points. functions: n x k;
 * column i is a function that increases away from the i-th of the k points. points: indices of the
 * s points. Returns s x k^2 values: column i k + j is the sine of the angle from the gradient of
 * function i to that of function j, seen from outside. For a mirror image, the signs are opposite.
 * mesh: its triangles face outwards.
 */
Eigen::MatrixXd ComputeGradientOrientations(
  const Mesh& mesh, const Eigen::MatrixXd& functions, const std::vector<int>& points);

/**
 * Describes each point of a surface relative to k of its points, by numbers that bending changes
 * little. The first k numbers are the distances from the k points along the surface
 * (ComputeHeatDistances), divided by the root of its area. The others are the
 * ComputeGradientOrientations of every two of the first 12 points, with a small weight. If the k
 * points of two surfaces correspond, points with similar rows correspond too. The orientations
 * distinguish points that have the same distances, such as one on the front and one on the back.
 *
 * surface: one component, with a triangle at each point. Returns n x (k + number of pairs). Throws
 * SolveFailure, Aborted.
 */
Eigen::MatrixXd EmbedByLandmarks(
  const Surface& surface, const std::vector<int>& landmarks, const Progress& progress = {});

/// Does the same, but divides the distances by `length`. This allows a part to be compared with a
/// complete surface.
Eigen::MatrixXd EmbedByLandmarks(const Surface& surface, const std::vector<int>& landmarks,
  double length, const Progress& progress = {});

/// Does the same for known distances (s x k) and known orientations `turns`
/// (ComputeGradientOrientations), which may cover only the first landmarks. chosen: indices of the
/// landmarks to use. turnSign: 1, or -1 for the mirror image.
Eigen::MatrixXd EmbedByDistances(const Eigen::MatrixXd& distances, const Eigen::MatrixXd& turns,
  const std::vector<int>& chosen, double turnSign);

} // namespace shape
