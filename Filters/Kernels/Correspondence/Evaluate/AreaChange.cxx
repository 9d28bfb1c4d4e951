#include "Correspondence/Evaluate/AreaChange.h"

#include "Spectrum/LaplaceEigenproblem.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

constexpr Eigen::Index Functions = 10;

LaplaceEigenpairs Solve(const Surface& surface, const Progress& progress)
{
  return SolveLaplaceEigenproblem(
    surface, static_cast<int>(std::min(Functions, surface.Points().rows())), progress);
}

/// onto: the image on `from` of each point of `to`.
double ChangeOfGram(const Eigen::MatrixXi& triangles, const LaplaceEigenpairs& from,
  const LaplaceEigenpairs& to, const SurfacePoints& onto)
{
  const Eigen::MatrixXd pulled = PullBack(onto, triangles, from.Eigenfunctions);
  // Eigenfunctions are orthonormal in the areas of their own surface.
  const double scale = from.Masses.sum() / to.Masses.sum();
  const Eigen::MatrixXd gram = scale * (pulled.transpose() * to.Masses.asDiagonal() * pulled);
  const Eigen::Index size = gram.rows();
  return (gram - Eigen::MatrixXd::Identity(size, size)).norm() /
    std::sqrt(static_cast<double>(size));
}

} // namespace

double ComputeAreaChange(
  const Surface& a, const Surface& b, const SurfaceMaps& maps, const Progress& progress)
{
  const LaplaceEigenpairs ofA = Solve(a, progress.Part(0.0, 0.5)),
                          ofB = Solve(b, progress.Part(0.5, 1.0));
  return 0.5 *
    (ChangeOfGram(a.Triangles(), ofA, ofB, maps.BToA) +
      ChangeOfGram(b.Triangles(), ofB, ofA, maps.AToB));
}

} // namespace shape
