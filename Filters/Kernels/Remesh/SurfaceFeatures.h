#pragma once

#include "Mesh/Mesh.h"

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
  double CurveLength = 0.0;         ///< of those on curves: less where patches were too small
  /// The share of the creases that are curves; 1 where nothing is sharp.
  double CurveShare() const
  {
    return this->CreaseLength > 0.0 ? this->CurveLength / this->CreaseLength : 1.0;
  }
};

/**
 * The creases of a surface: edges whose triangles' normals are more than `angle` degrees apart,
 * as far as they bound patches. One that ends inside a patch goes on over edges of at least three
 * eighths of the angle to another one, on the shortest way, where there is such a way that meets
 * the other one at no small angle. A patch smaller than `leastArea` is united with the neighbour it
 * has the longest border with. One patch and no curves where nothing is sharp, or where less than
 * two thirds of what is sharp bound patches of more than a thousandth of the area: then it is
 * noise, as of a scan.
 *
 * mesh: closed, oriented consistently.
 */
SurfaceFeatures FindFeatures(const Mesh& mesh, double angle, double minimumArea);

/// The same surface with no curve and no corner, and one patch.
SurfaceFeatures RemoveCurves(const SurfaceFeatures& features);

/// The patches of the surface, each with the points that it uses.
std::vector<Mesh> SplitIntoPatches(const Mesh& mesh, const SurfaceFeatures& features);

} // namespace shape
