#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <vector>

namespace shape
{

/**
 * Fits maps of a surface to itself by its eigenfunctions: the functional map is fitted to the point
 * map, and the point map to the functional map, in turn (Ovsjanikov et al. 2012, section 6). The
 * functional map of an isometry is orthogonal and commutes with the Laplacian (section 3). Each one
 * is replaced by the nearest such matrix. Without this, errors that vary slowly over the surface
 * remain: 1 to 5 % on an ellipsoid.
 */
class SelfMaps
{
public:
  /// surface: connected, with a triangle at each point. Throws SolveFailure, Aborted.
  explicit SelfMaps(const Surface& surface, const Progress& progress = {});

  /// Returns the images of all points under the map of few eigenfunctions that takes the points
  /// `from` to the points `to`. Throws Aborted.
  SurfacePoints Fit(
    const std::vector<int>& from, const std::vector<int>& to, const Progress& progress = {}) const;
  /// Refines such a map with twice as many eigenfunctions. Throws Aborted.
  SurfacePoints Refine(const SurfacePoints& map, const Progress& progress = {}) const;

private:
  Eigen::MatrixXd FindIsometry(const Eigen::MatrixXd& fitted) const;
  SurfacePoints FindImages(const Eigen::MatrixXd& fitted) const;
  SurfacePoints Iterate(
    SurfacePoints map, int functions, int iterations, const Progress& progress) const;

  Surface Scaled;
  Eigen::VectorXd Masses;
  LaplaceEigenpairs Spectrum;
};

} // namespace shape
