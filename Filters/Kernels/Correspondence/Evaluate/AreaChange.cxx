#include "Correspondence/Evaluate/AreaChange.h"

#include "Spectrum/LaplaceEigenproblem.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/// onto: the image on `from` of each point of `to`.
double ChangeOfGram(
  const Surface& from, const Surface& to, const SurfacePoints& onto, const Progress& progress)
{
  constexpr Eigen::Index functions = 10;
  const auto size = static_cast<int>(std::min(functions, from.Points().rows()));
  const LaplaceEigenpairs spectrum = SolveLaplaceEigenproblem(from, size, progress);
  const Eigen::MatrixXd pulled = PullBack(onto, from.Triangles(), spectrum.Eigenfunctions);
  const Eigen::VectorXd masses = ComputePointAreas(to);
  // Eigenfunctions are orthonormal in the areas of their own surface.
  const double scale = spectrum.Masses.sum() / masses.sum();
  const Eigen::MatrixXd gram = scale * (pulled.transpose() * masses.asDiagonal() * pulled);
  return (gram - Eigen::MatrixXd::Identity(size, size)).norm() / std::sqrt(size);
}

} // namespace

double ComputeAreaChange(
  const Surface& a, const Surface& b, const SurfaceMaps& maps, const Progress& progress)
{
  const double onB = ChangeOfGram(a, b, maps.BToA, progress.Part(0.0, 0.5)),
               onA = ChangeOfGram(b, a, maps.AToB, progress.Part(0.5, 1.0));
  return 0.5 * (onA + onB);
}

} // namespace shape
