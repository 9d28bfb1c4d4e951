#include "Harmonic/PiecewiseHarmonicMap.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"
#include "Solids/Nesting.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace shape
{

namespace
{

using Eigen::RowVector3d;

/// Returns the triangles of the wanted regions, with the points that they use.
template <typename Wanted>
Mesh Part(const Surface& surface, const Eigen::VectorXi& regions, const Wanted& wanted)
{
  std::vector<int> triangles;
  for (int t = 0; t < surface.Triangles().rows(); ++t)
  {
    if (wanted(regions.size() == 0 ? 0 : regions(t)))
    {
      triangles.push_back(t);
    }
  }
  return ExtractTriangles(surface, triangles);
}

void RequireValidCharges(const PiecewiseCharges& charges)
{
  const auto count = static_cast<Eigen::Index>(charges.Maps.size());
  const Eigen::Index m = charges.Surface.Triangles().rows();
  const bool regionsFit =
    charges.Regions.size() == m || (charges.Regions.size() == 0 && count == 1);
  if (count == 0 || !regionsFit ||
    (charges.Skins.size() != 0 &&
      (charges.Skins.size() != count || charges.Skins.minCoeff() < 0.0)))
  {
    throw InvalidInput("the map has " + std::to_string(count) + " regions, " + std::to_string(m) +
      " triangles, " + std::to_string(charges.Regions.size()) + " region numbers and " +
      std::to_string(charges.Skins.size()) +
      " skins; give one region number for each triangle, and one skin >= 0 for each region");
  }
  for (Eigen::Index r = 0; r < count && charges.Regions.size() > 0; ++r)
  {
    if ((charges.Regions.array() == static_cast<int>(r)).count() == 0)
    {
      throw InvalidInput("no triangle of the map's surface bounds region " + std::to_string(r) +
        "; number regions from 0 without gaps");
    }
  }
  for (const int region : charges.Regions)
  {
    if (region < PiecewiseCharges::Void || region >= count)
    {
      throw InvalidInput("a triangle of the map's surface bounds region " + std::to_string(region) +
        ", but there are " + std::to_string(count) +
        " regions; number regions from 0, and use -1 for the walls of voids");
    }
  }
}

/// Returns the map of h and phi of a repair; null if it has no tetrahedra.
std::unique_ptr<const FiniteElementMap> JoinShares(const PiecewiseCharges& charges)
{
  const MapRepair& repair = charges.Repair;
  if (repair.Elements.Tetrahedra.rows() == 0)
  {
    return nullptr;
  }
  if (charges.Maps.size() > 1)
  {
    throw InvalidInput("the map has " + std::to_string(charges.Maps.size()) +
      " regions and a repair; only a map of one region can be repaired");
  }
  if (repair.Shares.size() != repair.Elements.Points.rows() || repair.Elements.Images.cols() != 3 ||
    !(repair.Shares.minCoeff() >= 0.0 && repair.Shares.maxCoeff() <= 1.0))
  {
    throw InvalidInput("the repair of the map has " +
      std::to_string(repair.Elements.Points.rows()) + " points and " +
      std::to_string(repair.Shares.size()) +
      " shares; give each point an image of three coordinates and one share from 0 to 1");
  }
  FiniteElements joined = repair.Elements;
  joined.Images.conservativeResize(Eigen::NoChange, 4);
  joined.Images.col(3) = repair.Shares;
  return std::make_unique<const FiniteElementMap>(std::move(joined));
}

} // namespace

double ComputeFarthest(double offsetDistance, const Eigen::MatrixXd& points)
{
  return 0.5 * offsetDistance * ComputeLongestBoxEdge(points);
}

PiecewiseHarmonicMap::PiecewiseHarmonicMap(
  const PiecewiseCharges& charges, const Progress& progress)
  : Maps(charges.Maps)
  , Skins(charges.Skins.size() > 0 ? charges.Skins : Eigen::VectorXd::Zero(charges.Maps.size()))
  , Device(charges.Device)
  , FarthestOutside(charges.Farthest)
  , Borders(charges.Maps.size())
  , Parents(charges.Maps.size(), 0)
  , Repair(JoinShares(charges))
  , Walls(charges.Maps.size(), Mesh{ Eigen::MatrixXd(0, 3), Eigen::MatrixXi(0, 3) })
{
  RequireValidCharges(charges);
  if (this->Repair)
  {
    constexpr double tolerance = 1e-6;
    this->RepairTolerance = tolerance * ComputeLongestBoxEdge(this->Repair->Elements().Points);
  }
  const std::string name = "the surface of the Map";
  // The surfaces are checked and oriented; then each region gets its border, its parent, and the
  // walls of its voids.
  if (this->Maps.size() > 1)
  {
    // Checked together: no two components may touch.
    OrientByNesting(charges.Surface, name, progress.Part(0.0, 0.5));
  }
  const Mesh solid = Part(charges.Surface, charges.Regions, [](int region) { return region <= 0; });
  this->Solid =
    std::make_unique<SignedDistance>(OrientByNesting(solid, name, progress.Part(0.5, 1.0)));
  for (int r = 1; r < this->RegionCount(); ++r)
  {
    const Mesh border =
      Part(charges.Surface, charges.Regions, [r](int region) { return region == r; });
    this->Borders[r] = std::make_unique<SignedDistance>(OrientByNesting(border, name));
  }
  this->FindParents();
  const Mesh walls = Part(
    charges.Surface, charges.Regions, [](int region) { return region == PiecewiseCharges::Void; });
  if (walls.Triangles.rows() > 0)
  {
    for (const Mesh& wall : SplitComponents(walls))
    {
      Mesh& known = this->Walls[this->RegionsAt(ComputeCentroids(wall).topRows(1))(0)];
      known = JoinMeshes({ known, wall });
    }
  }
}

void PiecewiseHarmonicMap::FindParents()
{
  const int count = this->RegionCount();
  const auto within = [&](int inner, int outer)
  {
    const Eigen::MatrixXd position =
      ComputeCentroids(this->Borders[inner]->GetSurface()).topRows(1);
    return this->Borders[outer]->Evaluate(position).Distances(0) < 0.0;
  };
  // The depth of a region is the number of borders around it. The deepest of them is its parent.
  std::vector<int> depths(count, 0);
  for (int r = 1; r < count; ++r)
  {
    for (int other = 1; other < count; ++other)
    {
      depths[r] += other != r && within(r, other);
    }
  }
  for (int r = 1; r < count; ++r)
  {
    this->Order.push_back(r);
    for (int other = 1; other < count; ++other)
    {
      if (other != r && within(r, other) &&
        (this->Parents[r] == 0 || depths[other] > depths[this->Parents[r]]))
      {
        this->Parents[r] = other;
      }
    }
  }
  // Locate needs outer regions before inner ones.
  std::stable_sort(
    this->Order.begin(), this->Order.end(), [&](int a, int b) { return depths[a] < depths[b]; });
}

Mesh PiecewiseHarmonicMap::BoundaryOf(int region) const
{
  // The surface around the region, the walls of its voids, and the borders of the regions inside
  // it.
  Mesh boundary = this->Walls[region];
  if (region == 0)
  {
    boundary = this->Solid->GetSurface().AsMesh();
    // The walls of voids in inner regions do not bound region 0.
    if (this->RegionCount() > 1)
    {
      const std::vector<Mesh> parts = SplitComponents(boundary);
      boundary = { Eigen::MatrixXd(0, 3), Eigen::MatrixXi(0, 3) };
      for (const Mesh& part : parts)
      {
        if (this->RegionsAt(ComputeCentroids(part).topRows(1))(0) == 0)
        {
          boundary = JoinMeshes({ boundary, part });
        }
      }
    }
  }
  else
  {
    boundary = JoinMeshes({ this->Borders[region]->GetSurface(), boundary });
  }
  for (const int other : this->Order)
  {
    if (this->Parents[other] == region)
    {
      boundary = JoinMeshes({ boundary, this->Borders[other]->GetSurface() });
    }
  }
  return boundary;
}

PiecewiseHarmonicMap::Positions PiecewiseHarmonicMap::Locate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  // Borders are visited from the outside inwards. A point starts in region 0 and enters a region if
  // it is in the region's parent and inside its border.
  const Eigen::Index n = points.rows();
  Positions positions{ Eigen::VectorXi::Zero(n), Eigen::VectorXd::Zero(n),
    Eigen::MatrixXd::Zero(n, 3) };
  double done = 0.0;
  for (const int region : this->Order)
  {
    const double next = done + 1.0 / static_cast<double>(this->Order.size());
    const SignedDistance& border = *this->Borders[region];
    const Eigen::MatrixXd& onBorder = border.GetSurface().Points();
    // Distances are evaluated only in the border's box.
    const RowVector3d low = onBorder.colwise().minCoeff();
    const RowVector3d high = onBorder.colwise().maxCoeff();
    std::vector<int> near;
    for (int i = 0; i < n; ++i)
    {
      if (positions.Regions(i) == this->Parents[region] &&
        (points.row(i).array() >= low.array()).all() &&
        (points.row(i).array() <= high.array()).all())
      {
        near.push_back(i);
      }
    }
    const SignedDistance::Result at =
      border.Evaluate(points(near, Eigen::all), progress.Part(done, next));
    for (std::size_t k = 0; k < near.size(); ++k)
    {
      const int i = near[k];
      if (!(at.Distances(k) < 0.0))
      {
        continue;
      }
      positions.Regions(i) = region;
      // A point of an inner region is no longer in the skin of the outer one.
      positions.Shares(i) = 0.0;
      positions.Slopes.row(i).setZero();
      const double depth = -at.Distances(k), skin = this->Skins(region), u = depth / skin;
      if (depth < skin)
      {
        // s(u) of the header and its gradient. The gradient is s'(u) / skin times that of the
        // depth, a unit vector away from the closest position.
        positions.Shares(i) = (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u);
        positions.Slopes.row(i) =
          -6.0 * u * (1.0 - u) / (skin * depth) * (points.row(i) - at.Closest.Positions.row(k));
      }
    }
    done = next;
  }
  return positions;
}

Eigen::VectorXi PiecewiseHarmonicMap::RegionsAt(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  return this->Locate(points, progress).Regions;
}

namespace
{

/// Returns the points in `region`, and those in a skin that blends with its map.
std::vector<int> Needing(
  const PiecewiseHarmonicMap& map, const PiecewiseHarmonicMap::Positions& positions, int region)
{
  std::vector<int> rows;
  for (int i = 0; i < positions.Regions.size(); ++i)
  {
    const int own = positions.Regions(i);
    if (own == region || (positions.Shares(i) > 0.0 && map.Parent(own) == region))
    {
      rows.push_back(i);
    }
  }
  return rows;
}

double ShareOf(const PiecewiseHarmonicMap::Positions& positions, int i, int region)
{
  return positions.Regions(i) == region ? 1.0 - positions.Shares(i) : positions.Shares(i);
}

} // namespace

Eigen::MatrixXd PiecewiseHarmonicMap::EvaluateRegion(
  int region, const Eigen::MatrixXd& points, const Progress& progress) const
{
  // The default error and number of points.
  return shape::Evaluate(this->Maps[region], points, progress, 1e-10, 0, this->Device);
}

Eigen::MatrixXd PiecewiseHarmonicMap::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  if (this->Repair)
  {
    return this->EvaluateRepaired(points, progress);
  }
  if (this->RegionCount() == 1)
  {
    return this->EvaluateRegion(0, points, progress);
  }
  // Every map is evaluated once, at all points that need it, and added with its share.
  const Positions positions = this->Locate(points, progress.Part(0.0, 0.3));
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(points.rows(), 3);
  for (int r = 0; r < this->RegionCount(); ++r)
  {
    const double part = 0.7 / this->RegionCount();
    const std::vector<int> rows = Needing(*this, positions, r);
    const Eigen::MatrixXd own = this->EvaluateRegion(
      r, points(rows, Eigen::all), progress.Part(0.3 + part * r, 0.3 + part * (r + 1)));
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
      values.row(rows[k]) += ShareOf(positions, rows[k], r) * own.row(k);
    }
  }
  return values;
}

Eigen::MatrixXd PiecewiseHarmonicMap::Jacobians(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  if (this->Repair)
  {
    return this->RepairedJacobians(points, progress);
  }
  if (this->RegionCount() == 1)
  {
    return shape::EvaluateJacobians(this->Maps[0], points, progress, this->Device);
  }
  // As in Evaluate, with the product rule for the shares.
  const Positions positions = this->Locate(points, progress.Part(0.0, 0.3));
  Eigen::MatrixXd jacobians = Eigen::MatrixXd::Zero(points.rows(), 9);
  for (int r = 0; r < this->RegionCount(); ++r)
  {
    const double part = 0.7 / this->RegionCount();
    const std::vector<int> rows = Needing(*this, positions, r);
    const Eigen::MatrixXd own = shape::EvaluateJacobians(this->Maps[r], points(rows, Eigen::all),
      progress.Part(0.3 + part * r, 0.3 + part * (r + 1)), this->Device);
    std::vector<int> blended;
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
      jacobians.row(rows[k]) += ShareOf(positions, rows[k], r) * own.row(k);
      if (positions.Shares(rows[k]) > 0.0)
      {
        blended.push_back(rows[k]);
      }
    }
    // The derivative of the share (product rule).
    const Eigen::MatrixXd values = this->EvaluateRegion(r, points(blended, Eigen::all), {});
    for (std::size_t k = 0; k < blended.size(); ++k)
    {
      const int i = blended[k];
      const double sign = positions.Regions(i) == r ? -1.0 : 1.0;
      for (int row = 0; row < 3; ++row)
      {
        jacobians.block<1, 3>(i, 3 * row) += sign * values(k, row) * positions.Slopes.row(i);
      }
    }
  }
  return jacobians;
}

PiecewiseHarmonicMap::RepairPositions PiecewiseHarmonicMap::LocateInRepair(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  FiniteElementMap::Values values = this->Repair->Evaluate(points, progress, this->RepairTolerance);
  RepairPositions at{ std::move(values.Cells), std::move(values.Images),
    Eigen::MatrixXd::Zero(points.rows(), 12) };
  std::vector<int> inside;
  for (int i = 0; i < at.Cells.size(); ++i)
  {
    if (at.Cells(i) >= 0)
    {
      inside.push_back(i);
    }
    else
    {
      at.Values(i, 3) = 1.0;
    }
  }
  at.Gradients(inside, Eigen::all) = this->Repair->Jacobians(at.Cells(inside));
  return at;
}

/// The repair at some points, and f where it has a share.
struct PiecewiseHarmonicMap::RepairedValues
{
  RepairPositions At;
  std::vector<int> Outside; ///< the points outside the core
  Eigen::MatrixXd Charges;  ///< f at these points, one in each row
};

PiecewiseHarmonicMap::RepairedValues PiecewiseHarmonicMap::LocateRepaired(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  RepairedValues found{ this->LocateInRepair(points, progress.Part(0.0, 0.3)), {}, {} };
  for (int i = 0; i < found.At.Cells.size(); ++i)
  {
    if (found.At.Values(i, 3) > 0.0)
    {
      found.Outside.push_back(i);
    }
  }
  found.Charges =
    this->EvaluateRegion(0, points(found.Outside, Eigen::all), progress.Part(0.3, 1.0));
  return found;
}

Eigen::MatrixXd PiecewiseHarmonicMap::EvaluateRepaired(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  const auto [at, rows, charges] = this->LocateRepaired(points, progress);
  // g = h + phi (f - h), and f itself where phi is 1.
  Eigen::MatrixXd values = at.Values.leftCols<3>();
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const double share = at.Values(rows[k], 3);
    values.row(rows[k]) = share < 1.0
      ? RowVector3d(values.row(rows[k]) + share * (charges.row(k) - values.row(rows[k])))
      : RowVector3d(charges.row(k));
  }
  return values;
}

Eigen::MatrixXd PiecewiseHarmonicMap::RepairedJacobians(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  const auto [at, rows, charges] = this->LocateRepaired(points, progress.Part(0.0, 0.6));
  const Eigen::MatrixXd derivatives = shape::EvaluateJacobians(
    this->Maps[0], points(rows, Eigen::all), progress.Part(0.6, 1.0), this->Device);
  // The derivative of g = h + phi (f - h).
  Eigen::MatrixXd jacobians = at.Gradients.leftCols<9>();
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const int i = rows[k];
    const double share = at.Values(i, 3);
    jacobians.row(i) += share * (derivatives.row(k) - jacobians.row(i));
    for (int row = 0; row < 3; ++row)
    {
      jacobians.block<1, 3>(i, 3 * row) +=
        (charges(k, row) - at.Values(i, row)) * at.Gradients.block<1, 3>(i, 9);
    }
  }
  return jacobians;
}

} // namespace shape
