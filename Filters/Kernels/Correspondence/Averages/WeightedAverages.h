#pragma once

#include "Base/Progress.h"
#include "Correspondence/Averages/PhongProjection.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Spectrum/Smacof.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Weighted averages of landmarks on a surface (Panozzo, Baran, Diamanti and Sorkine-Hornung,
 * "Weighted averages on surfaces", 2013). The average of points with weights is the point of the
 * surface with the least weighted sum of squared distances to them. The surface is embedded in
 * eight dimensions, so that straight distances are close to those along the surface. There the
 * average is the weighted mean, projected to the surface by PhongProjection.
 */
class LandmarkAverages
{
public:
  /// surface: a triangle at each point. landmarks: k >= 3 different points. embedding: n x d (see
  /// PhongProjection), of about the size 1.
  LandmarkAverages(
    const Surface& surface, const std::vector<int>& landmarks, Eigen::MatrixXd embedding);

  /// The inverse problem: returns k weights with sum 1 of which a vertex is the average. The mean
  /// differs from the vertex only perpendicularly to the tangent plane there. Of all such weights,
  /// these have the least sum of w^2 d^4, where d is the distance to the landmark, so near
  /// landmarks count most. At a landmark, its own weight is 1. Weights may be negative.
  Eigen::RowVectorXd WeightsAt(int vertex) const;

  /// The forward problem: returns the average with the given weights (k values with sum 1). start:
  /// a point where the search begins. If only one weight differs from 0, the average is its
  /// landmark.
  SurfacePoint Average(const Eigen::RowVectorXd& weights, const SurfacePoint& start) const;

private:
  const std::vector<int> Landmarks;
  const Eigen::MatrixXd Positions;
  const PhongProjection Projection;
};

/**
 * Maps each point of a surface, in both directions, to the average of the partners of the landmarks
 * with the weights that the point has as an average of the landmarks. Landmarks are mapped exactly
 * to their partners. The map is smooth, but need not be one to one. It needs landmarks all over the
 * surface: a protrusion without one is an extrapolation. The search for an average begins at the
 * point of the other surface with the most similar distances from the landmarks (EmbedByLandmarks).
 *
 * a, b: one component each, of any topology, open or closed, with a triangle at each point.
 * Throws InvalidInput if there are fewer than three landmarks; SolveFailure; Aborted.
 */
SurfaceMaps MapByWeightedAverages(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const SmacofOptions& scaling = {}, const Progress& progress = {});

} // namespace shape
