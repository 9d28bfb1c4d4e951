#include "Search/CellLocator.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Mesh/SurfaceWork.h"
#include "Search/ClosestPoint.h"
#include "Search/Private/CellInterpolation.h"

#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shape
{

namespace
{

using Eigen::RowVector3d;

int GetCornerCount(const Cells& cells, int cell)
{
  return cells.Offsets(cell + 1) - cells.Offsets(cell);
}

/// The indices of the cells of the highest dimension, 3 or 2, and that dimension.
std::vector<int> CellsThatCount(const Cells& cells, int& dimension)
{
  dimension = 2;
  std::vector<int> numbers;
  vtkNew<vtkGenericCell> cell;
  for (int c = 0; c < cells.Kinds.size(); ++c)
  {
    if (cells.Kinds(c) == VTK_POLYHEDRON)
    {
      throw InvalidInput("cell " + std::to_string(c) +
        " is a polyhedron, which has no shape functions; apply Tetrahedralize first");
    }
    if (GetCornerCount(cells, c) == 0)
    {
      continue;
    }
    cell->SetCellType(cells.Kinds(c));
    const int here = cell->GetCellDimension();
    if (here > dimension)
    {
      dimension = here;
      numbers.clear();
    }
    if (here == dimension)
    {
      numbers.push_back(c);
    }
  }
  if (numbers.empty())
  {
    throw InvalidInput(
      "there is no polygon and no solid cell; give a surface or a solid (Delaunay 3D "
      "makes one from points)");
  }
  return numbers;
}

/// The bounding box of a cell, slightly enlarged because the faces of a curved one bulge.
Eigen::AlignedBox3d BoxOf(const Cells& cells, int number, vtkGenericCell* cell)
{
  Eigen::AlignedBox3d box;
  for (int k = cells.Offsets(number); k < cells.Offsets(number + 1); ++k)
  {
    box.extend(cells.Points.row(cells.Corners(k)).transpose());
  }
  cell->SetCellType(cells.Kinds(number));
  const double share = cell->IsLinear() ? CellRounding : 0.25;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(share * box.diagonal().norm());
  return { box.min() - margin, box.max() + margin };
}

/// The visitor with which Eigen's tree search finds a cell that contains Place.
struct ContainingCell
{
  const Cells& Grid;
  const std::vector<Eigen::AlignedBox3d>& Boxes; ///< of all cells
  vtkGenericCell* Cell;                          ///< to work with
  RowVector3d Position;
  int Number = -1;
  Eigen::VectorXd Weights = {};

  // Eigen's search calls these two by their names. NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolume(const Eigen::AlignedBox3d& box) const
  {
    return box.contains(this->Position.transpose());
  }
  bool intersectObject(int number)
  {
    if (!this->Boxes[number].contains(this->Position.transpose()))
    {
      return false;
    }
    this->Weights = ComputeCellWeights(this->Grid, number, this->Position, this->Cell);
    this->Number = this->Weights.size() > 0 ? number : -1;
    return this->Number >= 0;
  }
  // NOLINTEND(readability-identifier-naming)
};

/// The function that Eigen's branch and bound minimises outside all cells: the squared distance of
/// Place from the faces of a cell.
struct NearestCell
{
  using Scalar = double;
  const Cells& Grid;
  const std::vector<Eigen::AlignedBox3d>& Boxes; ///< of all cells
  vtkGenericCell* Cell;                          ///< to work with
  RowVector3d Position;
  int Number = -1;
  PointOnEdges Closest = { std::numeric_limits<double>::infinity(), {}, {} };

  // Eigen's search calls these two by their names. NOLINTBEGIN(readability-identifier-naming)
  double minimumOnVolume(const Eigen::AlignedBox3d& box) const
  {
    return box.squaredExteriorDistance(this->Position.transpose());
  }
  double minimumOnObject(int number)
  {
    // Eigen has boxes of pairs of cells only: a cell's own box rules out most of them.
    const double minimum = this->minimumOnVolume(this->Boxes[number]);
    if (minimum > this->Closest.Distance2)
    {
      return minimum;
    }
    const PointOnEdges here =
      FindClosestPointOnEdges(this->Grid, number, this->Position, this->Cell);
    if (here.Distance2 < this->Closest.Distance2)
    {
      this->Closest = here;
      this->Number = number;
    }
    return here.Distance2;
  }
  // NOLINTEND(readability-identifier-naming)
};

using Triplets = std::vector<Eigen::Triplet<double>>;

} // namespace

struct CellLocator::Search
{
  virtual ~Search() = default;
  virtual CellPoints Find(
    const Eigen::MatrixXd& positions, const Progress& progress, double farthest) const = 0;
};

struct CellLocator::SolidSearch : CellLocator::Search
{
  SolidSearch(const Cells& cells, const std::vector<int>& numbers)
    : Grid(cells)
  {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(numbers.size());
    this->Boxes.resize(cells.Kinds.size());
    vtkNew<vtkGenericCell> cell;
    for (const int number : numbers)
    {
      this->Boxes[number] = BoxOf(cells, number, cell);
      boxes.push_back(this->Boxes[number]);
    }
    this->Tree.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
  }

  CellPoints Find(
    const Eigen::MatrixXd& positions, const Progress& progress, double farthest) const override
  {
    const int n = static_cast<int>(positions.rows());
    CellPoints found{ Eigen::VectorXi(n), { n, this->Grid.Points.rows() }, Eigen::VectorXd(n) };
    constexpr int grain = 256;
    std::vector<Triplets> weights((n + grain - 1) / grain); // for each chunk
    ParallelFor(
      n, grain,
      [&](int begin, int end)
      {
        vtkNew<vtkGenericCell> cell;
        for (int i = begin; i < end; ++i)
        {
          found.Distances(i) = this->FindOne(
            positions.row(i), farthest, cell, i, found.Ids(i), weights[begin / grain]);
        }
      },
      progress);
    Triplets all;
    for (const Triplets& some : weights)
    {
      all.insert(all.end(), some.begin(), some.end());
    }
    found.Weights.setFromTriplets(all.begin(), all.end());
    return found;
  }

  /// Finds the cell `id` of a position, appends its `row` of weights, returns its distance.
  double FindOne(const RowVector3d& position, double farthest, vtkGenericCell* cell, int row,
    int& id, Triplets& weights) const
  {
    // First the cells whose boxes contain the position. Only outside all cells does the slower
    // search for the nearest face follow.
    ContainingCell containing{ this->Grid, this->Boxes, cell, position };
    Eigen::BVIntersect(this->Tree, containing);
    id = containing.Number;
    if (id >= 0)
    {
      for (Eigen::Index k = 0; k < containing.Weights.size(); ++k)
      {
        weights.emplace_back(
          row, this->Grid.Corners(this->Grid.Offsets(id) + k), containing.Weights(k));
      }
      return 0.0;
    }
    NearestCell nearest{ this->Grid, this->Boxes, cell, position };
    nearest.Closest.Distance2 = farthest * farthest;
    Eigen::BVMinimize(this->Tree, nearest);
    id = nearest.Number;
    if (id < 0)
    {
      if (std::isfinite(farthest))
      {
        return std::numeric_limits<double>::infinity();
      }
      throw InvalidInput("a position is so far from every cell that its distance overflows; scale "
                         "the shapes to a common size");
    }
    for (int k = 0; k < 3; ++k)
    {
      weights.emplace_back(row, nearest.Closest.Points(k), nearest.Closest.Barycentrics(k));
    }
    return std::sqrt(nearest.Closest.Distance2);
  }

  Cells Grid;
  std::vector<Eigen::AlignedBox3d> Boxes; ///< of all cells; empty for cells that are ignored
  Eigen::KdBVH<double, 3, int> Tree;      ///< of cells
};

struct CellLocator::SurfaceSearch : CellLocator::Search
{
  SurfaceSearch(const Cells& cells, const std::vector<int>& numbers)
    : Locator(this->Triangulate(cells, numbers))
  {
  }

  Mesh Triangulate(const Cells& cells, const std::vector<int>& numbers)
  {
    std::vector<Eigen::RowVector3i> triangles;
    vtkNew<vtkGenericCell> cell;
    vtkNew<vtkIdList> ids;
    vtkNew<vtkPoints> points;
    for (const int number : numbers)
    {
      LoadCell(cells, number, cell);
      cell->Triangulate(0, ids, points);
      for (vtkIdType k = 0; k + 2 < ids->GetNumberOfIds(); k += 3)
      {
        triangles.emplace_back(static_cast<int>(ids->GetId(k)), static_cast<int>(ids->GetId(k + 1)),
          static_cast<int>(ids->GetId(k + 2)));
        this->CellOfTriangle.push_back(number);
      }
      if (ids->GetNumberOfIds() == 0)
      {
        throw InvalidInput("cell " + std::to_string(number) +
          " is a polygon that cannot be split into triangles; repair it");
      }
    }
    Mesh mesh{ cells.Points, Eigen::MatrixXi(triangles.size(), 3) };
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      mesh.Triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
    }
    return mesh;
  }

  CellPoints Find(
    const Eigen::MatrixXd& positions, const Progress& progress, double farthest) const override
  {
    const Mesh& mesh = this->Locator.GetSurface();
    const ClosestPoints closest = this->Locator.Find(positions, progress);
    CellPoints found{ closest.Triangles, { positions.rows(), mesh.Points.rows() },
      closest.Distances };
    Triplets weights;
    weights.reserve(3 * positions.rows());
    for (int i = 0; i < positions.rows(); ++i)
    {
      if (closest.Distances(i) > farthest)
      {
        found.Ids(i) = -1;
        found.Distances(i) = std::numeric_limits<double>::infinity();
        continue;
      }
      found.Ids(i) = this->CellOfTriangle[closest.Triangles(i)];
      for (int k = 0; k < 3; ++k)
      {
        weights.emplace_back(
          i, mesh.Triangles(closest.Triangles(i), k), closest.Barycentrics(i, k));
      }
    }
    found.Weights.setFromTriplets(weights.begin(), weights.end());
    return found;
  }

  std::vector<int> CellOfTriangle; ///< declared before Locator, whose construction fills it
  SurfaceLocator Locator;
};

CellLocator::CellLocator(const Cells& cells, const Progress& progress)
{
  int dimension = 0;
  const std::vector<int> numbers = CellsThatCount(cells, dimension);
  progress(0.5);
  if (dimension == 3)
  {
    SurfaceWork::Note(SurfaceWork::Kind::SearchTree, cells.Points);
    this->Impl = std::make_unique<SolidSearch>(cells, numbers);
  }
  else
  {
    this->Impl = std::make_unique<SurfaceSearch>(cells, numbers);
  }
  progress(1.0);
}

CellLocator::~CellLocator() = default;
CellLocator::CellLocator(CellLocator&&) noexcept = default;
CellLocator& CellLocator::operator=(CellLocator&&) noexcept = default;

CellPoints CellLocator::Find(const Eigen::MatrixXd& positions, const Progress& progress) const
{
  return this->Find(positions, progress, std::numeric_limits<double>::infinity());
}

CellPoints CellLocator::Find(
  const Eigen::MatrixXd& positions, const Progress& progress, double farthest) const
{
  return this->Impl->Find(positions, progress, farthest);
}

} // namespace shape
