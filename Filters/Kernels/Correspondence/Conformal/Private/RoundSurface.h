#pragma once

#include "Base/Progress.h"
#include "Correspondence/Conformal/Private/MoebiusMap.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Parameterize/SphereMap.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A surface of genus 0 on the sphere.
struct RoundSurface
{
  Mesh Sphere;               ///< with fans in the holes
  SphereMapMethod Method;    ///< the method that computed the map
  ComplexPoints Points;      ///< of the sphere
  Eigen::VectorXd LogScales; ///< log(area on the surface / area on the sphere) around each
  Eigen::MatrixXd Embedding; ///< n x d: straight distances are geodesic ones, for area 1
  Eigen::VectorXd Areas;     ///< of all points except those of the fans; the sum is 1
};

/// Computes a surface's conformal map to the sphere, the area scale of that map, and the positions
/// in which images are averaged. first: the method to try first. Throws SolveFailure, Aborted.
RoundSurface MakeRoundSurface(
  const Surface& surface, SphereMapMethod first, const Progress& progress = {});

/// The images of points under a conformal map, and the trust in the map there.
struct ConformalImages
{
  Eigen::MatrixXd Positions; ///< in the target's embedding
  Eigen::VectorXd Trust;     ///< in [0, 1]: 1 / cosh(logarithm of the map's area scale)
};

/// The images of some points of `from` under the map through both spheres and a Moebius map.
/// locator: of to.Sphere.
ConformalImages ComputeConformalImages(const RoundSurface& from, const std::vector<int>& points,
  const RoundSurface& to, const SurfaceLocator& locator, const Eigen::Matrix2cd& moebius);

} // namespace shape
