#include "Materials/Private/CellSampling.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Mesh/CellFaces.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

using namespace cell_kind;

constexpr double TaskSize = 48.0;   ///< maximum edge of a task, in voxels
constexpr double BatchWork = 1.0e6; ///< voxels between two reports of progress
constexpr double Tolerance = 1e-9;  ///< in voxels: rounding of positions on the box

/// Returns the cell's corners in the order of CellCube; nullptr for other kinds of cells.
const int* FindCubeOrder(int kind)
{
  static constexpr int hexahedron[] = { 0, 1, 3, 2, 4, 5, 7, 6 },
                       tetrahedron[] = { 0, 1, 2, 2, 3, 3, 3, 3 },
                       wedge[] = { 0, 1, 2, 2, 3, 4, 5, 5 }, pyramid[] = { 0, 1, 3, 2, 4, 4, 4, 4 };
  return kind == Hexahedron ? hexahedron
    : kind == Tetrahedron   ? tetrahedron
    : kind == Wedge         ? wedge
    : kind == Pyramid       ? pyramid
                            : nullptr;
}

void RequireSolidCells(const Cells& cells)
{
  const auto isOther = [](int kind) { return !FindCubeOrder(kind); };
  const auto count = std::count_if(cells.Kinds.begin(), cells.Kinds.end(), isOther);
  if (count > 0)
  {
    const auto first = std::find_if(cells.Kinds.begin(), cells.Kinds.end(), isOther);
    throw InvalidInput("the Input has " + std::to_string(count) +
      (count == 1 ? " cell" : " cells") +
      " of other types than tetrahedra, pyramids, wedges and "
      "hexahedra (first cell " +
      std::to_string(first - cells.Kinds.begin()) +
      "); divide them with Tetrahedralize, or remove them with Extract Cells By Type");
  }
  for (Eigen::Index cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    const int first = cells.Offsets(cell), size = cells.Offsets(cell + 1) - first;
    const auto corners = cells.Corners.segment(first, size);
    if (size != GetCornerCount(cells.Kinds(cell)) || corners.minCoeff() < 0 ||
      corners.maxCoeff() >= cells.Points.rows())
    {
      throw InvalidInput(
        "the Input's cell " + std::to_string(cell) + " refers to a missing point; repair the mesh");
    }
  }
}

/// The shape functions of the eight corners at the eight Gauss points, and their derivatives along
/// the axes of the cube.
struct GaussRule
{
  Eigen::Matrix<double, 8, 8> Values;
  std::array<Eigen::Matrix<double, 8, 8>, 3> Derivatives;

  GaussRule()
  {
    const double offset = 0.5 / std::sqrt(3.0);
    for (int point = 0; point < 8; ++point)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        double factor[3], slope[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          const double position = (point >> axis & 1) != 0 ? 0.5 + offset : 0.5 - offset;
          const bool isUpper = (corner >> axis & 1) != 0;
          factor[axis] = isUpper ? position : 1.0 - position;
          slope[axis] = isUpper ? 1.0 : -1.0;
        }
        this->Values(point, corner) = factor[0] * factor[1] * factor[2];
        this->Derivatives[0](point, corner) = slope[0] * factor[1] * factor[2];
        this->Derivatives[1](point, corner) = factor[0] * slope[1] * factor[2];
        this->Derivatives[2](point, corner) = factor[0] * factor[1] * slope[2];
      }
    }
  }
};

} // namespace

CubeSamples SampleCube(const CellCube& cube)
{
  static const GaussRule rule;
  CubeSamples samples;
  samples.Points = rule.Values.lazyProduct(cube);
  const CellCube a = rule.Derivatives[0].lazyProduct(cube),
                 b = rule.Derivatives[1].lazyProduct(cube),
                 c = rule.Derivatives[2].lazyProduct(cube);
  for (int i = 0; i < 8; ++i)
  {
    samples.Volumes[i] = std::abs(a.row(i).cross(b.row(i)).dot(c.row(i))) / 8.0;
  }
  return samples;
}

CellSampling::CellSampling(const Cells& cells, const VoxelImage& image, double step, double margin)
  : Mesh(cells)
  , Indices(ToIndices(image, cells.Points))
  , Step(step)
{
  RequireSolidCells(cells);
  RequireFinite(this->Indices, "the Input");
  this->Low.setConstant(-margin);
  this->High << image.Size[0] - 1, image.Size[1] - 1, image.Size[2] - 1;
  this->High.array() += margin;
  this->Tasks.reserve(cells.Kinds.size());
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    this->AddTasks(cell, this->ToCube(cell), true);
  }
}

void CellSampling::AddTasks(int cell, const CellCube& cube, bool isWhole)
{
  Eigen::Index axis = 0;
  const Eigen::Vector3d edges = FindEdges(cube);
  const bool isOutside = this->Relate(cube) == Relation::Outside;
  if (!isOutside && edges.maxCoeff(&axis) > TaskSize)
  {
    for (const CellCube& half : Halve(cube, static_cast<int>(axis)))
    {
      this->AddTasks(cell, half, false);
    }
    return;
  }
  const double work = isOutside ? 1.0 : (edges / this->Step).cwiseMax(1.0).prod();
  this->Tasks.push_back({ cell, isWhole ? -1 : static_cast<int>(this->Cubes.size()), work });
  if (!isWhole)
  {
    this->Cubes.push_back(cube);
  }
}

void CellSampling::Run(const std::function<void(int task)>& work, const Progress& progress) const
{
  for (int first = 0; first < this->Count();)
  {
    int last = first;
    for (double sum = 0.0; last < this->Count() && sum < BatchWork; ++last)
    {
      sum += this->Tasks[last].Work;
    }
    const int grain = std::max(1, (last - first) / 256);
    ParallelFor(last - first, grain,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          work(first + i);
        }
      });
    first = last;
    progress(static_cast<double>(first) / this->Count());
  }
}

CellCube CellSampling::ToCube(int cell) const
{
  const int* order = FindCubeOrder(this->Mesh.Kinds(cell));
  CellCube cube;
  for (int corner = 0; corner < 8; ++corner)
  {
    cube.row(corner) =
      this->Indices.row(this->Mesh.Corners(this->Mesh.Offsets(cell) + order[corner]));
  }
  return cube;
}

CellSampling::Relation CellSampling::Relate(const CellCube& cube) const
{
  const Eigen::RowVector3d low = cube.colwise().minCoeff(), high = cube.colwise().maxCoeff();
  if ((high.array() <= this->Low.array()).any() || (low.array() >= this->High.array()).any())
  {
    return Relation::Outside;
  }
  const bool isInside = (low.array() >= this->Low.array() - Tolerance).all() &&
    (high.array() <= this->High.array() + Tolerance).all();
  return isInside ? Relation::Inside : Relation::Crossing;
}

bool CellSampling::Contains(const Eigen::RowVector3d& index) const
{
  return (index.array() >= this->Low.array()).all() && (index.array() <= this->High.array()).all();
}

Eigen::Vector3d CellSampling::FindEdges(const CellCube& cube)
{
  Eigen::Vector3d edges = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      if ((corner >> axis & 1) == 0)
      {
        edges(axis) =
          std::max(edges(axis), (cube.row(corner | 1 << axis) - cube.row(corner)).squaredNorm());
      }
    }
  }
  return edges.cwiseSqrt();
}

std::array<CellCube, 2> CellSampling::Halve(const CellCube& cube, int axis)
{
  std::array<CellCube, 2> halves = { cube, cube };
  for (int corner = 0; corner < 8; ++corner)
  {
    if ((corner >> axis & 1) == 0)
    {
      const int other = corner | 1 << axis;
      halves[0].row(other) = halves[1].row(corner) = 0.5 * (cube.row(corner) + cube.row(other));
    }
  }
  return halves;
}

} // namespace shape
