#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A crease: points of a surface that are connected by consecutive edges.
struct FeatureCurve
{
  std::vector<int> Points;      ///< in order; a closed curve does not repeat its first point
  bool Closed = false;          ///< whether the curve is closed; it then has no corner
  std::array<int, 2> Patches{}; ///< the patches on either side, the lower number first
  double Angle = 0.0;           ///< the mean interior dihedral angle along the curve, in degrees
};

/// A surface cut into patches along its creases.
struct SurfaceFeatures
{
  Eigen::VectorXi PatchOf; ///< m: the patch of each triangle
  int Patches = 0;
  std::vector<FeatureCurve> Curves; ///< where two patches meet, from corner to corner
  std::vector<int> Corners;         ///< points where creases meet or end
  double CreaseLength = 0.0;        ///< total length of the edges that are as sharp as a crease
  double CurveLength = 0.0;         ///< the part of it on curves: less if patches were too small
  /// The fraction of CreaseLength that lies on curves; 1 if no edge is sharp.
  double CurveShare() const
  {
    return this->CreaseLength > 0.0 ? this->CurveLength / this->CreaseLength : 1.0;
  }
};

/**
 * Finds the creases of a surface that bound patches: edges whose triangles' normals differ by more
 * than `angle` degrees.
 *
 * A crease that ends inside a patch is extended to another crease. The extension is the shortest
 * path over edges of at least three eighths of the angle. It must not meet the other crease at a
 * small angle. A patch smaller than `minimumArea` is merged with the neighbour with which it shares
 * the longest boundary.
 *
 * Returns one patch and no curves if no edge is sharp. It does so, too, if less than two thirds of
 * the sharp edges bound patches of more than a thousandth of the area: they are then noise, as in a
 * scan.
 *
 * surface: closed and consistently oriented. Throws InvalidInput under the conditions of
 * RequireIndices.
 */
SurfaceFeatures FindFeatures(const Surface& surface, double angle, double minimumArea);

/// Returns the features of the same surface with a single patch and no curves or corners.
SurfaceFeatures RemoveCurves(const SurfaceFeatures& features);

/// Returns the patches of the surface, each with the points that it uses.
std::vector<Mesh> SplitIntoPatches(const Mesh& mesh, const SurfaceFeatures& features);

} // namespace shape
