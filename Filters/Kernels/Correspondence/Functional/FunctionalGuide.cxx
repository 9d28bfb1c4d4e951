#include "Correspondence/Functional/FunctionalGuide.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>

namespace shape
{
namespace
{

/// `values` at some points, unless there are none.
Eigen::MatrixXd Restricted(const Eigen::MatrixXd& values, const std::vector<int>& points)
{
  return values.rows() == 0 ? values : Eigen::MatrixXd(values(points, Eigen::all));
}

int PositionOf(int point, const std::vector<int>& points)
{
  return static_cast<int>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
}

/// The first eigenfunctions, of norm 1 if the surface is scaled to area 1, and the root of its
/// area.
struct UnitBasis
{
  Eigen::MatrixXd Functions;
  double Length = 1.0;
};

UnitBasis UnitBasisOf(const Surface& surface, int size, const Progress& progress)
{
  const LaplaceEigenpairs pairs = SolveLaplaceEigenproblem(surface, size, progress);
  const double length = std::sqrt(pairs.Masses.sum());
  return { pairs.Eigenfunctions * length, length };
}

void RequireBasis(
  Eigen::Index size, const std::string& sides, const Surface& surface, const std::string& name)
{
  const Topology topology = RequireManifold(surface, name);
  const auto points = (topology.ComponentId.array() >= 0).count();
  if (size > points)
  {
    throw InvalidInput("the matrix FunctionalMap has " + std::to_string(size) + " " + sides +
      ", but " + name + " has only " + std::to_string(points) +
      " eigenfunctions, one for each point; remove the last " + sides);
  }
}

/// n x ids: the share of each point's area in each region.
Eigen::MatrixXd Indicators(
  const Surface& surface, const SurfaceRegions& regions, const std::vector<int>& ids)
{
  const Eigen::Index points = surface.Points().rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(points, static_cast<Eigen::Index>(ids.size()));
  const auto columnOf = [&](int id)
  {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return at != ids.end() && *at == id ? at - ids.begin() : -1;
  };
  if (regions.OfPoints)
  {
    for (Eigen::Index i = 0; i < points; ++i)
    {
      if (const auto column = columnOf(regions.Ids(i)); column >= 0)
      {
        result(i, column) = 1.0;
      }
    }
    return result;
  }
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(points);
  const Eigen::VectorXd twice = ComputeAreaVectors(surface).rowwise().norm();
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    const auto column = columnOf(regions.Ids(t));
    for (const int corner : surface.Triangles().row(t))
    {
      areas(corner) += twice(t);
      if (column >= 0)
      {
        result(corner, column) += twice(t);
      }
    }
  }
  // A point without area is in no region.
  const Eigen::VectorXd inverses = (areas.array() > 0.0).select(areas.cwiseInverse(), 0.0);
  return inverses.asDiagonal() * result;
}

} // namespace

void RequireFunctionalMap(const Eigen::MatrixXd& matrix)
{
  if (matrix.size() == 0)
  {
    throw InvalidInput("the matrix FunctionalMap has " + std::to_string(matrix.rows()) +
      " rows and " + std::to_string(matrix.cols()) +
      " columns; give one with a row for each eigenfunction of SurfaceB and a column for "
      "each one of SurfaceA");
  }
  if (!matrix.allFinite())
  {
    throw InvalidInput(
      "the matrix FunctionalMap holds a value that is not finite; compute it again");
  }
}

FunctionalGuide WithEigenbases(
  FunctionalGuide guide, const Surface& a, const Surface& b, const Progress& progress)
{
  RequireFunctionalMap(guide.Matrix);
  RequireBasis(guide.Matrix.cols(), "columns", a, "SurfaceA");
  RequireBasis(guide.Matrix.rows(), "rows", b, "SurfaceB");
  const auto sizeOfA = static_cast<int>(guide.Matrix.cols()),
             sizeOfB = static_cast<int>(guide.Matrix.rows());
  const UnitBasis ofA = UnitBasisOf(a, sizeOfA,
                    progress.Part(0.0, 0.5, "computing the bases of the given functional map")),
                  ofB = UnitBasisOf(b, sizeOfB, progress.Part(0.5, 1.0));
  guide.Matrix *= ofA.Length / ofB.Length;
  guide.BasisOfA = ofA.Functions;
  guide.BasisOfB = ofB.Functions;
  return guide;
}

FunctionalGuide AtPoints(
  const FunctionalGuide& guide, const std::vector<int>& pointsA, const std::vector<int>& pointsB)
{
  FunctionalGuide result = guide;
  result.DescriptorsOfA = Restricted(guide.DescriptorsOfA, pointsA);
  result.DescriptorsOfB = Restricted(guide.DescriptorsOfB, pointsB);
  result.DisplacementsOfA = Restricted(guide.DisplacementsOfA, pointsA);
  result.DisplacementsOfB = Restricted(guide.DisplacementsOfB, pointsB);
  result.BasisOfA = Restricted(guide.BasisOfA, pointsA);
  result.BasisOfB = Restricted(guide.BasisOfB, pointsB);
  for (Landmarks& curve : result.Curves)
  {
    for (auto& [pointA, pointB] : curve)
    {
      pointA = PositionOf(pointA, pointsA);
      pointB = PositionOf(pointB, pointsB);
    }
  }
  return result;
}

FunctionalGuide OnCoarse(const FunctionalGuide& guide, const CoarsePair& pair)
{
  std::vector<int> ofA(pair.A().Points().rows()), ofB(pair.B().Points().rows());
  for (int i = 0; i < static_cast<int>(ofA.size()); ++i)
  {
    ofA[i] = pair.FinePointOfA(i);
  }
  for (int i = 0; i < static_cast<int>(ofB.size()); ++i)
  {
    ofB[i] = pair.FinePointOfB(i);
  }
  return AtPoints(guide, ofA, ofB);
}

RegionIndicators ComputeRegionIndicators(const Surface& a, const SurfaceRegions& regionsOfA,
  const Surface& b, const SurfaceRegions& regionsOfB)
{
  const std::set<int> onA(regionsOfA.Ids.begin(), regionsOfA.Ids.end()),
    onB(regionsOfB.Ids.begin(), regionsOfB.Ids.end());
  std::vector<int> common;
  std::set_intersection(onA.begin(), onA.end(), onB.begin(), onB.end(), std::back_inserter(common));
  if (common.empty())
  {
    throw InvalidInput("no region has the same id on SurfaceA and SurfaceB; give corresponding "
                       "regions equal numbers");
  }
  return { Indicators(a, regionsOfA, common), Indicators(b, regionsOfB, common) };
}

} // namespace shape
