#include "Correspondence/Evaluate/SurfaceMapFacts.h"

#include "Correspondence/Pair/ReversedArea.h"
#include "Laplacian/CotangentWeights.h"

#include <cmath>

namespace shape
{
namespace
{

/// The straight distance (n) between each point of a surface and its image under two maps in turn.
Eigen::VectorXd ReturnDistances(
  const Mesh& mesh, const SurfacePoints& there, const Mesh& other, const SurfacePoints& back)
{
  return (
    PullBack(there, other.Triangles, PullBack(back, mesh.Triangles, mesh.Points)) - mesh.Points)
    .rowwise()
    .norm();
}

/// The share of the mass that belongs to points with a short distance.
double ComputeCoverage(const Eigen::VectorXd& masses, const Eigen::VectorXd& distances)
{
  constexpr double maximum = 0.02; // of the root of the area
  const double area = masses.sum();
  return (distances.array() <= maximum * std::sqrt(area)).select(masses, 0.0).sum() / area;
}

} // namespace

SurfaceMapFacts EvaluateMaps(const Surface& a, const Surface& b, const SurfaceMaps& maps)
{
  const Eigen::MatrixXd images = PullBack(maps.AToB, b.Triangles(), b.Points());
  const TriangleAngles angles = ComputeTriangleAngles(a);
  const Eigen::SparseMatrix<double> stiffness = BuildPositiveStiffness(
    BuildCotangentStiffness(a.Triangles(), angles.Cotangents, a.Points().rows()), 0.0);
  const Eigen::VectorXd masses =
    ComputeLumpedMasses(a.Triangles(), angles.Areas, a.Points().rows());
  const Eigen::VectorXd massesB = ComputePointAreas(b);
  const double areaA = masses.sum(), areaB = massesB.sum();
  SurfaceMapFacts facts;
  // Divided by the target's area, so that a uniform scale of either surface does not matter.
  facts.DirichletEnergy = 0.5 * (images.transpose() * (stiffness * images)).trace() / areaB;
  const Eigen::VectorXd returns = ReturnDistances(a, maps.AToB, b, maps.BToA);
  facts.RoundTrip = masses.dot(returns) / (areaA * std::sqrt(areaA));
  facts.CoverageOfA = ComputeCoverage(masses, returns);
  facts.CoverageOfB = ComputeCoverage(massesB, ReturnDistances(b, maps.BToA, a, maps.AToB));
  facts.ReversedArea = ComputeReversedArea(a, b, maps.AToB);
  // Between the values of true and of mirrored maps: see SurfaceMapFacts::Mirrored.
  constexpr double maximum = 0.3;
  facts.Mirrored = facts.ReversedArea > maximum;
  return facts;
}

} // namespace shape
