#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A crease: points of a surface, each joined to the next by an edge.
struct FeatureCurve
{
  std::vector<int> Points;      ///< of a closed curve the first is not repeated
  bool Closed = false;          ///< then it has no corner
  std::array<int, 2> Patches{}; ///< on either side, the lower number first
  double Angle = 0.0;           ///< in degrees, inside, between the triangles: the mean along it
};

/// A surface cut into patches along its creases.
struct SurfaceFeatures
{
  Eigen::VectorXi PatchOf; ///< m: of each triangle
  int Patches = 0;
  std::vector<FeatureCurve> Curves; ///< where two patches meet, from corner to corner
  std::vector<int> Corners;         ///< points where creases meet or end
  double CreaseLength = 0.0;        ///< of all edges as sharp as a crease
  double CurveLength = 0.0;         ///< of those on curves: less if patches were too small
  /// The share of the creases that are curves; 1 if nothing is sharp.
  double CurveShare() const
  {
    return this->CreaseLength > 0.0 ? this->CurveLength / this->CreaseLength : 1.0;
  }
};

/**
 * The creases of a surface that bound patches: edges whose triangles' normals are more than `angle`
 * degrees apart. A crease that ends inside a patch is extended to another one along the shortest
 * path over edges of at least three eighths of the angle, if there is such a path that does not
 * meet the other crease at a small angle. A patch smaller than `minimumArea` is merged with the
 * neighbour that it has the longest boundary with. One patch and no curves if no edge is sharp, or
 * if less than two thirds of the sharp edges bound patches of more than a thousandth of the area:
 * then they are noise, as in a scan.
 *
 * surface: closed, oriented consistently. Throws InvalidInput as RequireIndices.
 */
SurfaceFeatures FindFeatures(const Surface& surface, double angle, double minimumArea);

/// The same surface with no curve and no corner, and one patch.
SurfaceFeatures RemoveCurves(const SurfaceFeatures& features);

/// The patches of the surface, each with the points that it uses.
std::vector<Mesh> SplitIntoPatches(const Mesh& mesh, const SurfaceFeatures& features);

} // namespace shape
