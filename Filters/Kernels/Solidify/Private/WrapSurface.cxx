#include "Solidify/Private/WrapSurface.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Search/ClosestPoint.h"
#include "Solidify/Private/GridContour.h"
#include "Solidify/Private/GridFlood.h"
#include "Solidify/Private/GridSurface.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solidify/Private/SheetPlates.h"
#include "Solidify/Private/SolidSampling.h"
#include "Solids/GridWinding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Eigen::RowVector3i;

/// The first and last crossing of an edge of the grid with triangles.
struct EdgeHits
{
  double First, Last; ///< positions along the axis
  int FirstTriangle, LastTriangle;
};

/// The solid of a wrap on a grid.
class Wrapping
{
public:
  Wrapping(const Mesh& surface, double spacing, double gap, const Progress& progress)
    : Surface(surface)
    , Radius(0.5 * gap)
    , Thickness(0.9 * spacing)
    , Locator(this->Surface)
  {
    this->Solid.Grid =
      MakeGrid(surface, spacing, static_cast<int>(std::ceil(this->Radius / spacing)) + 2);
    this->FindEdgeHits(progress.Part(0.0, 0.1));
    this->MeasureDistances(progress.Part(0.1, 0.6));
    this->FindAir(progress.Part(0.6, 1.0));
  }

  /// Whether there is air on both sides of every triangle.
  bool HasOnlySheets() const
  {
    return std::none_of(this->Solid.Inside.begin(), this->Solid.Inside.end(),
      [](char isInside) { return isInside != 0; });
  }

  /// Returns the boundary of the solid, after points around sheets were added to it.
  Mesh Contour(const Progress& progress)
  {
    this->AddPlates(progress.Part(0.0, 0.2));
    const std::vector<GridEdge> edges = FindBoundaryEdges(this->Solid);
    std::vector<EdgeCrossing> crossings;
    crossings.reserve(edges.size());
    for (const GridEdge edge : edges)
    {
      crossings.push_back(this->Cross(edge));
    }
    return ContourGrid(this->Solid, edges, crossings, progress.Part(0.2, 1.0));
  }

private:
  const SampledGrid& Grid() const { return this->Solid.Grid; }

  RowVector3i IndicesOf(int point) const
  {
    const RowVector3i& counts = this->Grid().Counts;
    return { point % counts(0), point / counts(0) % counts(1), point / counts(0) / counts(1) };
  }
  RowVector3d PositionOf(int point) const
  {
    const RowVector3i at = this->IndicesOf(point);
    return this->Grid().Point(at(0), at(1), at(2));
  }

  void FindEdgeHits(const Progress& progress)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ForEachGridCrossing(
        this->Surface, this->Grid(), axis,
        [&](const GridCrossing& crossing)
        {
          const RowVector3i& at = crossing.Before;
          const GridEdge edge =
            3 * static_cast<GridEdge>(this->Grid().Index(at(0), at(1), at(2))) + axis;
          const double position = crossing.Position;
          EdgeHits& hits =
            this->Hits
              .emplace(edge, EdgeHits{ position, position, crossing.Triangle, crossing.Triangle })
              .first->second;
          if (position < hits.First)
          {
            hits.First = position;
            hits.FirstTriangle = crossing.Triangle;
          }
          if (position > hits.Last)
          {
            hits.Last = position;
            hits.LastTriangle = crossing.Triangle;
          }
        },
        progress.Part(axis / 3.0, (axis + 1) / 3.0));
    }
  }

  /// Distances from the triangles; for a block of points that is far from them, a lower bound.
  void MeasureDistances(const Progress& progress)
  {
    constexpr int size = 6;
    const RowVector3i& counts = this->Grid().Counts;
    const RowVector3i blocks = (counts.array() + size - 1) / size;
    const double reach = 0.5 * std::sqrt(3.0) * (size - 1) * this->Grid().Spacing;
    const double far = this->Radius + 2.0 * this->Grid().Spacing;
    this->Distances.assign(counts.prod(), 0.0F);
    std::vector<int> near;
    for (int z = 0; z < blocks(2); ++z)
    {
      Eigen::MatrixXd centres(blocks(0) * blocks(1), 3);
      for (int i = 0; i < centres.rows(); ++i)
      {
        centres.row(i) = this->Grid().Origin +
          this->Grid().Spacing *
            (size * RowVector3d(i % blocks(0), i / blocks(0), z).array() + 0.5 * (size - 1))
              .matrix();
      }
      const double begin = static_cast<double>(z) / blocks(2), end = (z + 1.0) / blocks(2);
      const Eigen::VectorXd distances =
        this->Locator.Find(centres, progress.Part(begin, 0.8 * begin + 0.2 * end)).Distances;
      near.clear();
      for (int i = 0; i < centres.rows(); ++i)
      {
        this->AddBlock({ i % blocks(0), i / blocks(0), z }, size, distances(i) - reach, far, near);
      }
      this->MeasureAt(near, progress.Part(0.8 * begin + 0.2 * end, end));
    }
  }

  void AddBlock(
    const RowVector3i& block, int size, double bound, double far, std::vector<int>& near)
  {
    const RowVector3i low = size * block,
                      high = (low.array() + size).min(this->Grid().Counts.array());
    for (int z = low(2); z < high(2); ++z)
    {
      for (int y = low(1); y < high(1); ++y)
      {
        for (int x = low(0); x < high(0); ++x)
        {
          const int point = this->Grid().Index(x, y, z);
          if (bound > far)
          {
            this->Distances[point] = static_cast<float>(bound);
          }
          else
          {
            near.push_back(point);
          }
        }
      }
    }
  }

  void MeasureAt(const std::vector<int>& points, const Progress& progress)
  {
    Eigen::MatrixXd positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      positions.row(static_cast<Eigen::Index>(i)) = this->PositionOf(points[i]);
    }
    const ClosestPoints found = this->Locator.Find(positions, progress);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const auto row = static_cast<Eigen::Index>(i);
      this->Distances[points[i]] = static_cast<float>(found.Distances(row));
      if (found.Distances(row) <= this->Thickness)
      {
        this->Beside.emplace_back(points[i], found.Positions.row(row));
      }
    }
  }

  void FindAir(const Progress& progress)
  {
    const auto radius = static_cast<float>(this->Radius);
    const std::vector<char> outside = FloodGrid(
      this->Grid(), { 0 }, [&](int, int to) { return this->Distances[to] > radius; },
      progress.Part(0.0, 0.4));
    this->Swept = ComputeGridDistances(this->Grid(), outside, progress.Part(0.4, 1.0));
    // A ball around a point of the flood contains no triangle.
    this->Air.resize(outside.size());
    std::transform(this->Swept.begin(), this->Swept.end(), this->Air.begin(),
      [&](float swept) { return static_cast<char>(swept <= radius); });
    // The flood's points are a grid, so their balls leave a layer of up to half a diagonal of a
    // cell beside triangles. Two steps along edges pass through it in every direction.
    for (int step = 0; step < 2; ++step)
    {
      std::vector<int> joined;
      for (const auto& [point, nearest] : this->Beside)
      {
        if (this->Air[point] == 0 && this->HasAirBeside(point))
        {
          joined.push_back(point);
        }
      }
      for (const int point : joined)
      {
        this->Air[point] = 1;
      }
    }
    this->Solid.Inside.resize(this->Air.size());
    std::transform(this->Air.begin(), this->Air.end(), this->Solid.Inside.begin(),
      [](char isAir) { return static_cast<char>(isAir == 0); });
  }

  /// Whether an edge to a point in the air crosses no triangle.
  bool HasAirBeside(int point) const
  {
    const std::array<int, 3> steps = this->StepsOf();
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int first : { point - steps[axis], point })
      {
        const int other = first == point ? point + steps[axis] : first;
        if (this->Air[other] != 0 && this->Hits.count(3 * static_cast<GridEdge>(first) + axis) == 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  std::array<int, 3> StepsOf() const
  {
    return { 1, this->Grid().Counts(0), this->Grid().Counts(0) * this->Grid().Counts(1) };
  }

  /// Points beside a triangle belong to the solid if there is air at their mirror images, too.
  void AddPlates(const Progress& progress)
  {
    progress(0.0);
    for (const auto& [point, nearest] : this->Beside)
    {
      const RowVector3d mirrored = 2.0 * nearest - this->PositionOf(point);
      const RowVector3i cell =
        ((mirrored - this->Grid().Origin) / this->Grid().Spacing).array().floor().cast<int>();
      bool isAir = true;
      for (int corner = 0; corner < 8; ++corner)
      {
        isAir = isAir &&
          this->Air[this->Grid().Index(
            cell(0) + (corner & 1), cell(1) + (corner >> 1 & 1), cell(2) + (corner >> 2))] != 0;
      }
      if (isAir)
      {
        this->Solid.Inside[point] = 1;
      }
    }
  }

  EdgeCrossing Cross(GridEdge edge) const
  {
    const auto first = static_cast<int>(edge / 3);
    const auto axis = static_cast<int>(edge % 3);
    const int second = first + this->StepsOf()[axis];
    const bool leaves = this->Solid.Inside[first] != 0;
    const int inside = leaves ? first : second, outside = leaves ? second : first;
    if (this->Air[inside] != 0)
    {
      return { this->ShareAt(this->Distances, inside, outside, this->Thickness, leaves), {} };
    }
    const auto hits = this->Hits.find(edge);
    if (hits == this->Hits.end())
    {
      return { this->ShareAt(this->Swept, inside, outside, this->Radius, leaves), {} };
    }
    const double position = leaves ? hits->second.Last : hits->second.First;
    const Eigen::Matrix3d corners =
      GetCorners(this->Surface, leaves ? hits->second.LastTriangle : hits->second.FirstTriangle);
    RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).normalized();
    if ((normal(axis) > 0.0) != leaves)
    {
      normal = -normal;
    }
    return { (position - this->PositionOf(first)(axis)) / this->Grid().Spacing, normal };
  }

  /// Where values, linear along an edge, reach a level: the share from its first point.
  double ShareAt(
    const std::vector<float>& values, int inside, int outside, double level, bool insideFirst) const
  {
    const double begin = values[inside], end = values[outside];
    double share = (level - begin) / (end - begin);
    share = share > 0.0 && share < 1.0 ? share : 0.5;
    return insideFirst ? share : 1.0 - share;
  }

  shape::Surface Surface;
  double Radius, Thickness;
  SurfaceLocator Locator;
  GridSolid Solid;
  std::unordered_map<GridEdge, EdgeHits> Hits;
  std::vector<float> Distances; ///< from the triangles
  std::vector<float> Swept;     ///< distances from the first flood
  std::vector<char> Air;
  std::vector<std::pair<int, RowVector3d>> Beside; ///< points and their nearest positions
};

} // namespace

MendedSurface WrapSurface(
  const Mesh& surface, const WrapSurfaceOptions& options, const Progress& progress)
{
  const Mesh joined =
    JoinSoup(surface, options.Defects.Tolerance, progress.Part(0.0, 0.05)).Surface;
  if (joined.Triangles.rows() == 0)
  {
    throw InvalidInput("no triangle of the surface is left; give a surface with an area, or lower "
                       "Tolerance");
  }
  double spacing = ChooseDetailSize(joined, options.DetailSize);
  if (options.GapSize > 0.0 && options.DetailSize == 0.0)
  {
    spacing = std::min(spacing, 0.25 * options.GapSize);
  }
  const double gap = options.GapSize > 0.0 ? options.GapSize : 6.0 * spacing;
  RequireOption(
    gap >= 2.0 * spacing, "GapSize", options.GapSize, "0, or at least twice DetailSize");
  Wrapping wrapping(joined, spacing, gap, progress.Part(0.05, 0.5, "wrapping the surface"));
  if (wrapping.HasOnlySheets())
  {
    constexpr double share = 0.1; // of the spacing
    const double thickness =
      options.SheetThickness > 0.0 ? options.SheetThickness : share * spacing;
    try
    {
      return ThickenSheets(
        surface, thickness, options.Defects, progress.Part(0.5, 0.6, "thickening sheets"));
    }
    catch (const InvalidInput&) // the grid takes over
    {
    }
    catch (const SolveFailure&)
    {
    }
  }
  const Mesh made = wrapping.Contour(progress.Part(0.6, 0.7));
  return AdoptGridSurface(
    made, spacing, surface, options.Defects.SmallestPiece, "the wrap", progress.Part(0.7, 1.0));
}

} // namespace shape
