#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Whether two surfaces have the same shape, up to a motion and a scale.
struct Congruence
{
  enum class RelationType
  {
    None = 0,
    Same = 1,        ///< B is A, moved
    MirrorImage = 2, ///< B is a mirror image of A, and not A itself
    Both = 3         ///< both, because A has a mirror symmetry
  };
  RelationType Relation = RelationType::None;
  ///@{
  /// The root mean square distance of the two surfaces from each other, when A is moved onto B
  /// without and with a reflection, divided by the root of B's area.
  double MotionError = 0.0, ReflectionError = 0.0;
  ///@}
  ///@{
  /// The motion and the reflection, 4 x 4: a column (x, 1) of A goes to its image.
  Eigen::Matrix4d Motion = Eigen::Matrix4d::Identity(), Reflection = Eigen::Matrix4d::Identity();
  ///@}
};

/**
 * Moves A onto B as well as possible, without and with a reflection. Both are scaled to area 1, and
 * their centroids and principal axes are matched, in each of the directions that axes can have.
 * Axes of nearly equal moments are turned in steps of 15 degrees, too. From the best of these, the
 * closest points of samples are fitted in turn (Besl and McKay, "A method for registration of 3-D
 * shapes", 1992). Surfaces are the same if the distance is below 0.005: triangles of another
 * surface in the same place are that near, and poses and individuals are not.
 *
 * a, b: surfaces with an area. Their numbers and triangles do not matter. Throws InvalidInput if a
 * surface has no area; Aborted.
 */
Congruence FindCongruence(const Surface& a, const Surface& b, const Progress& progress = {});

} // namespace shape
