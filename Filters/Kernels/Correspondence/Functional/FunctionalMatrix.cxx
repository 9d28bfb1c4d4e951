#include "Correspondence/Functional/FunctionalMatrix.h"

namespace shape
{

FunctionalMatrix ComputeFunctionalMatrix(const Surface& a, const Surface& b,
  const SurfacePoints& bToA, int pairs, const Progress& progress)
{
  FunctionalMatrix result;
  result.OfA = SolveLaplaceEigenproblem(
    a, pairs, progress.Part(0.0, 0.5, "computing the eigenfunctions of the given surfaces"));
  result.OfB = SolveLaplaceEigenproblem(b, pairs, progress.Part(0.5, 1.0));
  result.Matrix = result.OfB.Eigenfunctions.transpose() *
    (result.OfB.Masses.asDiagonal() * PullBack(bToA, a.Triangles(), result.OfA.Eigenfunctions));
  return result;
}

Eigen::MatrixXd TransferFunctions(const FunctionalMatrix& map, const Eigen::MatrixXd& functions)
{
  const Eigen::MatrixXd coefficients =
    map.OfA.Eigenfunctions.transpose() * (map.OfA.Masses.asDiagonal() * functions);
  return map.OfB.Eigenfunctions * (map.Matrix * coefficients);
}

} // namespace shape
