#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A crease between two patches of a surface: a sequence of points connected by edges.
struct FeatureCurve
{
  std::vector<int> Points;      ///< in order; a closed curve does not repeat its first point
  bool Closed = false;          ///< whether the curve is closed and has no corner
  std::array<int, 2> Patches{}; ///< the patches on either side, the lower number first
  double Angle = 0.0;           ///< the mean interior dihedral angle along the curve, in degrees
};

/// A surface cut into patches along its creases.
struct SurfaceFeatures
{
  Eigen::VectorXi PatchOf; ///< m: the patch of each triangle
  int Patches = 0;
  std::vector<FeatureCurve> Curves; ///< creases between two patches, from corner to corner
  std::vector<int> Corners;         ///< points where curves meet or end
  double CreaseLength = 0.0;        ///< total length of all sharp edges
  double CurveLength = 0.0;         ///< total length of the sharp edges that lie on curves
  /// The fraction of the length of sharp edges that lies on curves; 1 if no edge is sharp.
  double CurveShare() const
  {
    return this->CreaseLength > 0.0 ? this->CurveLength / this->CreaseLength : 1.0;
  }
};

/**
 * Finds the creases of a surface that bound patches. An edge is sharp if the normals of its
 * triangles differ by more than `angle` degrees; sharp edges form creases.
 *
 * A crease that ends inside a patch is extended to another crease. The extension is the shortest
 * path over edges whose normals differ by at least three eighths of `angle`. The extension must not
 * meet the other crease at a small angle. A patch smaller than `minimumArea` is merged with the
 * adjacent patch with which it shares the longest boundary.
 *
 * The result is a single patch without curves if no edge is sharp, or if the sharp edges are noise,
 * as in a scan. They count as noise if less than two thirds of their length bounds patches larger
 * than a thousandth of the surface's area.
 *
 * surface: closed and consistently oriented. Throws InvalidInput under the conditions of
 * RequireIndices.
 */
SurfaceFeatures FindFeatures(const Surface& surface, double angle, double minimumArea);

/**
 * Finds the creases between given patches, such as the faces of a CAD model, however sharp they
 * are. A patch becomes several if it is not connected. Patches smaller than `minimumArea` are
 * merged as above.
 *
 * patchOf: the given patch of each triangle. CreaseLength is the length of all borders. surface and
 * errors: as above.
 */
SurfaceFeatures FindFeatures(
  const Surface& surface, const Eigen::VectorXi& patchOf, double minimumArea);

/// Returns features of the same surface that have a single patch and no curves or corners.
SurfaceFeatures RemoveCurves(const SurfaceFeatures& features);

/// Returns each patch of a surface as a mesh of its own, without unused points.
std::vector<Mesh> SplitIntoPatches(const Mesh& mesh, const SurfaceFeatures& features);

} // namespace shape
