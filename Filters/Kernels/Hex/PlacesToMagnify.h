#pragma once

#include "Hex/GridWarp.h"
#include "Quality/HausdorffDistance.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Gathers places that ask for smaller cells into magnifiers that are apart from each other: of two
/// that are near only the first stays.
class PlacesToMagnify
{
public:
  /// radius: of the magnifiers.
  explicit PlacesToMagnify(double radius)
    : Radius(radius)
  {
  }

  /// times: how much stronger than usual.
  void Add(const Eigen::RowVector3d& centre, double times = 1.0);

  /// Those that are farther than nearly wanted, the farthest first, the stronger the farther.
  void AddFar(const PlacesAndDistances& far, double wanted);

  const std::vector<Magnifier>& Magnifiers() const { return this->Gathered; }

private:
  double Radius;
  std::vector<Magnifier> Gathered;
};

} // namespace shape
