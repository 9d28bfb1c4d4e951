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
 * column i increases away from point i. The result is s x k^2: column i k + j is the sine of the
 * angle from the gradient of function i to that of function j, seen from outside. A mirror image
 * has the opposite signs. mesh: its triangles face outwards.
 */
Eigen::MatrixXd ComputeGradientOrientations(
  const Mesh& mesh, const Eigen::MatrixXd& functions, const std::vector<int>& points);

/**
 * Describes each point of a surface relative to k of its points, by numbers that bending changes
 * little. These are the distances along the surface divided by the root of its area
 * (ComputeHeatDistances). They are followed by the ComputeGradientOrientations, with a small
 * weight, of every two of the first 12 points. Points of two surfaces with similar rows correspond
 * if the k points do. The orientations distinguish the sides of the landmarks where distances
 * cannot: the back is not mistaken for the front.
 *
 * surface: of one component with a triangle at each point. Returns n x (k + pairs). Throws
 * SolveFailure, Aborted.
 */
Eigen::MatrixXd EmbedByLandmarks(
  const Surface& surface, const std::vector<int>& landmarks, const Progress& progress = {});

/// The same with distances divided by a given length, for surfaces of different extent.
Eigen::MatrixXd EmbedByLandmarks(const Surface& surface, const std::vector<int>& landmarks,
  double length, const Progress& progress = {});

/// The same from known distances (s x k) and the ComputeGradientOrientations `turns`, of all or of
/// the first landmarks. chosen: the landmarks to use. turnSign: 1, or -1 for the mirror image.
Eigen::MatrixXd EmbedByDistances(const Eigen::MatrixXd& distances, const Eigen::MatrixXd& turns,
  const std::vector<int>& chosen, double turnSign);

} // namespace shape
