#pragma once

#include "Base/Progress.h"
#include "Harmonic/LinearVolumeMap.h"
#include "Harmonic/VolumeRegistration.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

namespace shape
{

/**
 * What RegisterVolume lowers, as a function of the images of the boundary's points: the mean
 * squared distance from the target and back, and the distortion of the harmonic map.
 */
class RegistrationEnergy
{
public:
  /// boundary: closed, facing outwards, without unused points. scale: lengths of the image without
  /// distortion / lengths of the solid. map: the options of the harmonic maps. Throws the
  /// exceptions of LinearVolumeMap; SolveFailure if no position inside is found.
  RegistrationEnergy(const Surface& boundary, const Surface& target, double scale,
    const LinearVolumeMapOptions& map, const Progress& progress = {});

  /// The energy of some images, and what its gradient needs.
  struct State
  {
    double Distance = 0.0;       ///< mean squared, of both directions, / the target's size squared
    double Distortion = 0.0;     ///< mean symmetric Dirichlet energy; infinite if the map folds
    ChargeSet Map;               ///< the harmonic map
    Eigen::MatrixXd ByImages;    ///< n x 3: the derivative of Distance by the images
    Eigen::MatrixXd ByJacobians; ///< that of Distortion by the Jacobians inside

    /// An isometry has distortion 6.
    double Value(double weight) const { return this->Distance + weight * (this->Distortion - 6.0); }
  };

  /// images: n x 3. Throws the exceptions of LinearVolumeMap::Fit.
  State Evaluate(const Eigen::MatrixXd& images, const Progress& progress = {}) const;

  /// Returns the derivative of Value(weight) by the images. The distortion must be finite. Throws
  /// the exceptions of LinearVolumeMap::Gradient.
  Eigen::MatrixXd Gradient(const State& state, double weight, const Progress& progress = {}) const;

  /// Returns the distances and the distortion of a state of these images.
  RegistrationQuality Judge(const Eigen::MatrixXd& images, const State& state) const;

private:
  void AddDistances(const Eigen::MatrixXd& images, State& state, const Progress& progress) const;
  void AddDistortion(State& state, const Progress& progress) const;

  Surface Boundary;
  SurfaceLocator Target;
  double Scale, Size;      ///< Size: the longest side of the target's box
  Eigen::VectorXd Areas;   ///< of the boundary's points; their sum is 1
  Eigen::MatrixXd Samples; ///< on the target, evenly spread
  Eigen::MatrixXd Inside;  ///< positions in the solid
  Eigen::VectorXd Shares;  ///< of the positions; their sum is 1
  LinearVolumeMap Solver;
};

} // namespace shape
