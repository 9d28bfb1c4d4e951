#pragma once

#include "Base/Progress.h"
#include "Harmonic/Private/HarmonicDistortion.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

namespace shape
{

/**
 * What RegisterVolume lowers, as a function of the images of the boundary's points: the distance D
 * of the image of the boundary and the target, and the distortion S of the harmonic map.
 *
 * D is half the mean squared distance from the images to the target, plus half that from positions
 * on the target to the image, divided by the squared longest side of the target's box. Closest
 * points do not contribute to its derivative, because they minimise the distance (the envelope
 * theorem). The derivative is exact wherever the closest point is unique.
 */
class RegistrationEnergy
{
public:
  /// solid: where it is before the registration. triangles: its boundary's, as indices into
  /// FilledSolid::Boundary. target: with an area. Throws the exceptions of HarmonicDistortion.
  RegistrationEnergy(FilledSolid solid, Eigen::MatrixXi triangles, const Surface& target,
    const Progress& progress = {});

  struct Terms
  {
    double Distance = 0.0;        ///< D
    double Distortion = 0.0;      ///< S, the mean symmetric Dirichlet energy; 6 for an isometry
    Eigen::MatrixXd ByDistance;   ///< k x 3: the derivative of D by the images
    Eigen::MatrixXd ByDistortion; ///< k x 3: that of S, if S is finite

    double Value(double weight) const { return this->Distance + weight * (this->Distortion - 6.0); }
    Eigen::MatrixXd Gradient(double weight) const
    {
      return this->ByDistance + weight * this->ByDistortion;
    }
  };

  /// images: k x 3. Throws Aborted.
  Terms Evaluate(const Eigen::MatrixXd& images, const Progress& progress = {}) const;

  /// Returns a bound of the Hessian of Terms::Value(weight) at an isometry: that of distances in
  /// all directions, and of 4 |grad u|^2 for a displacement u. This object must outlive it.
  BoundaryHessian ApproximateHessian(double weight, const Progress& progress = {}) const;

  /// Returns the image of the boundary.
  Surface Image(const Eigen::MatrixXd& images) const { return this->Boundary.WithPoints(images); }

  const HarmonicDistortion& Map() const { return this->Harmonic; }
  double Size() const { return this->Longest; } ///< the longest side of the target's box

private:
  HarmonicDistortion Harmonic;
  Surface Boundary; ///< before the registration
  SurfaceLocator Target;
  double Longest;
  Eigen::VectorXd Shares;  ///< of the boundary's points in its area; their sum is 1
  Eigen::MatrixXd Samples; ///< on the target, evenly spread
};

} // namespace shape
