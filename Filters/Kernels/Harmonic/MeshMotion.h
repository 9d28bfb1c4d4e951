#pragma once

#include "Base/Progress.h"
#include "Harmonic/RadialBasisField.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct MeshMotionOptions
{
  enum class MethodType
  {
    Harmonic = 0,   ///< the displacement is harmonic: ComputeHarmonicVolumeMap, Accelerated
    RadialBasis = 1 ///< it is a sum of radial basis functions: FitRadialBasis
  };
  MethodType Method = MethodType::Harmonic;
  /// Error of the displacement at the boundary, relative to the largest displacement, above which
  /// Harmonic refines the boundary and RadialBasis adds centres. The rest of the error is carried
  /// to the points around. >= 0.
  double Tolerance = 1e-3;
  /// Distance up to which a boundary point lies on the surface that moves it, relative to the
  /// longest side of the mesh's box (FindBoundaryMotion). >= 0.
  double MatchTolerance = 1e-6;
  RadialBasisOptions::KernelType Kernel = RadialBasisOptions().Kernel; ///< RadialBasis
  double SupportRadius = RadialBasisOptions().SupportRadius;           ///< RadialBasis
  int MaximumCentres = RadialBasisOptions().MaximumCentres;            ///< RadialBasis
};

struct MeshMotionResult
{
  Eigen::MatrixXd Points; ///< n x 3: the moved points
  int Centres = 0;        ///< number of charges, or of centres of radial basis functions
  /// Largest error of the fitted displacement at a boundary point, relative to the largest
  /// displacement, before the correction that makes it exact.
  double BoundaryError = 0.0;
};

/**
 * Moves the points of a mesh with its boundary.
 *
 * The displacement is fitted to that of the boundary points, and evaluated at all others. What the
 * fit leaves at the boundary is carried to the points around it: its value at the closest position
 * of the boundary is added, with a factor that decreases smoothly to 0 over four spacings of the
 * boundary's points. So boundary points move exactly as given, and thin layers of cells move with
 * their wall. An affine displacement of the whole boundary moves all points by the same affine map,
 * up to rounding.
 *
 * Radial basis functions are what flow solvers use (A. de Boer, M. S. van der Schoot, H. Bijl,
 * "Mesh deformation based on radial basis function interpolation", 2007).
 *
 * points: n x 3, of the mesh. boundary: m triangles over these points, the closed surface around
 * the mesh and its voids, such as the one around a body in a flow. displacements: n x 3, used at
 * the points of the boundary only.
 *
 * Throws InvalidInput if a number of rows is wrong, a value is not finite, an option is out of
 * range or, with Harmonic, if the boundary is not one closed surface around a solid and its voids;
 * SolveFailure; Aborted.
 */
MeshMotionResult MoveMesh(const Eigen::MatrixXd& points, const Eigen::MatrixXi& boundary,
  const Eigen::MatrixXd& displacements, const MeshMotionOptions& options = {},
  const Progress& progress = {});

/// The displacement of the boundary points of a mesh, from a surface that tells it in a part.
struct BoundaryMotion
{
  Eigen::MatrixXd Displacements; ///< n x 3; 0 at inner points and where the surface is not
  int Moving = 0;                ///< number of boundary points on the surface
  int Fixed = 0;                 ///< number of other boundary points
  int Unmatched = 0;             ///< number of points of the surface that are off the boundary
};

/**
 * Finds the displacement of boundary points: where a point lies on `surface`, the displacement of
 * its points is interpolated; elsewhere it is 0. images: the positions that the surface's points
 * move to. tolerance: the distance up to which a point lies on the surface, relative to the longest
 * side of the mesh's box; >= 0.
 *
 * Throws InvalidInput if no boundary point lies on the surface, or it has no triangle; Aborted.
 */
BoundaryMotion FindBoundaryMotion(const Eigen::MatrixXd& points, const Eigen::MatrixXi& boundary,
  const Surface& surface, const Eigen::MatrixXd& images, double tolerance,
  const Progress& progress = {});

} // namespace shape
