#include "Atlas/SampleQuality.h"

#include "Geometry/FeatureAngle.h"
#include "Geometry/TangentFrame.h"
#include "Hex/Optimize/HexOptimization.h"
#include "Mesh/Extent.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr double OnSample = 1e-6; ///< distance of a point that slides / longest side
constexpr int NoRegion = std::numeric_limits<int>::min();

/// Marks the points of boundary quads whose quads' normals all agree within the feature angle.
std::vector<char> MarkSmoothPoints(const HexMesh& mesh, const Eigen::MatrixXi& quads)
{
  const Eigen::Index count = mesh.Points.rows();
  const auto normal = [&](Eigen::Index quad)
  {
    const auto at = [&](int k) -> Eigen::RowVector3d { return mesh.Points.row(quads(quad, k)); };
    return Eigen::RowVector3d((at(2) - at(0)).cross(at(3) - at(1))).normalized();
  };
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, 3);
  for (Eigen::Index quad = 0; quad < quads.rows(); ++quad)
  {
    for (const int point : quads.row(quad))
    {
      sums.row(point) += normal(quad);
    }
  }
  std::vector<char> smooth(count, 0);
  for (const int point : quads.reshaped())
  {
    smooth[point] = 1;
  }
  // Two normals that differ by the feature angle differ from their mean by half of it.
  const double least = std::cos(0.5 * DefaultFeatureAngle * M_PI / 180.0);
  for (Eigen::Index quad = 0; quad < quads.rows(); ++quad)
  {
    for (const int point : quads.row(quad))
    {
      smooth[point] =
        smooth[point] && normal(quad).dot(sums.row(point).normalized()) >= least ? 1 : 0;
    }
  }
  return smooth;
}

/// Inner points are free, and smooth boundary points slide on the sample.
class SampleConstraint : public PointConstraint
{
public:
  SampleConstraint(const HexMesh& mesh, const Eigen::VectorXi& regions, const Surface& sample)
    : Locator(sample)
    , Guesses(mesh.Points.rows(), -1)
    , Freedoms(mesh.Points.rows(), 3)
    , Given(mesh.Points)
  {
    const Eigen::MatrixXi quads = FindBoundaryQuads(mesh);
    const std::vector<char> smooth = MarkSmoothPoints(mesh, quads);
    const double farthest = OnSample * ComputeLongestBoxEdge(sample);
    for (const int point : quads.reshaped())
    {
      if (this->Freedoms[point] == 3)
      {
        const ClosestPoint closest = this->Locator.FindOne(mesh.Points.row(point));
        this->Guesses[point] = closest.Triangle;
        this->Freedoms[point] = smooth[point] && closest.Distance <= farthest ? 2 : 0;
      }
    }
    std::vector<int> regionOf(mesh.Points.rows(), NoRegion);
    for (Eigen::Index hex = 0; hex < regions.size(); ++hex)
    {
      for (const int point : mesh.Hexahedra.row(hex))
      {
        const bool isBetween = regionOf[point] != NoRegion && regionOf[point] != regions(hex);
        this->Freedoms[point] = isBetween ? 0 : this->Freedoms[point];
        regionOf[point] = regions(hex);
      }
    }
  }

  int Freedom(int point) const override { return this->Freedoms[point]; }

  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override
  {
    const int triangle = this->Find(point, position).Triangle;
    const Eigen::RowVector3d normal =
      this->Locator.GetSurface().AreaVectors().row(triangle).normalized();
    const TangentFrame frame = BuildTangentFrame(position, normal);
    PointDirections directions(3, 2);
    directions << frame.XAxis.transpose(), frame.YAxis.transpose();
    return directions;
  }

  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override
  {
    return this->Freedoms[point] == 0 ? Eigen::RowVector3d(this->Given.row(point))
                                      : this->Find(point, position).Position;
  }

private:
  ClosestPoint Find(int point, const Eigen::RowVector3d& position) const
  {
    const ClosestPoint closest = this->Locator.FindOne(position, this->Guesses[point]);
    this->Guesses[point] = closest.Triangle;
    return closest;
  }

  SurfaceLocator Locator;
  mutable std::vector<int> Guesses; ///< for each point: the triangle found last, or -1
  std::vector<char> Freedoms;
  Eigen::MatrixXd Given;
};

} // namespace

double RaiseSampleQuality(HexMesh& mesh, const Eigen::VectorXi& regions, const Surface& sample,
  double wanted, const Progress& progress)
{
  const Eigen::VectorXd before = ComputeScaledJacobians(mesh);
  if (before.size() == 0 || before.minCoeff() >= wanted)
  {
    progress(1.0);
    return before.size() == 0 ? 1.0 : before.minCoeff();
  }
  HexOptimizationOptions options;
  options.Bad = wanted + BadAbove;
  options.RaiseTo = wanted;
  options.Sweeps = 2;
  options.Marked =
    MarkPointsOfBadHexahedra(mesh.Hexahedra, before, mesh.Points.rows(), options.Bad);
  constexpr int around = 2;
  GrowRings(mesh.Hexahedra, around, options.Marked);
  HexMesh raised = mesh;
  const SampleConstraint constraint(mesh, regions, sample);
  const double minimum = OptimizeHexahedra(raised, constraint, options, progress).MinimumAfter;
  if (minimum <= before.minCoeff())
  {
    progress(1.0);
    return before.minCoeff();
  }
  mesh = std::move(raised);
  progress(1.0);
  return minimum;
}

} // namespace shape
