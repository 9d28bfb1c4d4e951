#pragma once

#include "Base/Progress.h"
#include "Materials/VoxelImage.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace shape
{

/**
 * The corners of a trilinear image of the unit cube, in units of voxels. Bit a of a corner's number
 * is its coordinate along axis a of the cube. Every linear solid cell is such an image: the corners
 * of tetrahedra, wedges and pyramids are repeated.
 */
using CellCube = Eigen::Matrix<double, 8, 3>;

/// The volume of a cube, and its eight Gauss points with their shares of the volume. The rule is
/// exact for the product of a linear function and the Jacobian of the cube.
struct CubeSamples
{
  CellCube Points; ///< one in each row
  std::array<double, 8> Volumes;
};

CubeSamples SampleCube(const CellCube& cube);

/**
 * Divides solid cells into cubes that are smaller than a voxel.
 *
 * A cube is halved along its longest direction until its edges are no longer than `step` voxels.
 * Where it crosses the boundary of a box of voxels, the limit is an eighth of that. Outside of the
 * box it is not divided. The box is that of the samples, enlarged by `margin` voxels on each side.
 * Cells larger than 48 voxels are divided among several tasks.
 */
class CellSampling
{
public:
  /// Throws InvalidInput if a cell is no linear solid cell, or if a point is not finite.
  CellSampling(const Cells& cells, const VoxelImage& image, double step, double margin = 0.0);

  struct Task
  {
    int Cell;
    int Cube;    ///< index into Cubes, or -1: the entire cell
    double Work; ///< estimated number of voxels
  };

  int Count() const { return static_cast<int>(this->Tasks.size()); } ///< number of tasks
  int GetCell(int task) const { return this->Tasks[task].Cell; }

  /// Calls work(task) for each task, in parallel. Throws Aborted.
  void Run(const std::function<void(int task)>& work, const Progress& progress) const;

  /// Calls visit(index, volume, isInside) for each Gauss point of the cubes of a task. index: the
  /// position in voxels. volume: in voxels. isInside: whether the box contains the position.
  template <typename Visit>
  void ForEachSample(int task, Visit&& visit) const
  {
    const Task& given = this->Tasks[task];
    this->Divide(given.Cube < 0 ? this->ToCube(given.Cell) : this->Cubes[given.Cube], visit);
  }

private:
  enum class Relation
  {
    Inside,
    Crossing,
    Outside
  };

  CellCube ToCube(int cell) const;
  Relation Relate(const CellCube& cube) const;
  bool Contains(const Eigen::RowVector3d& index) const;
  /// The edge lengths of the cube along its three axes: the maximum of four edges each.
  static Eigen::Vector3d FindEdges(const CellCube& cube);
  static std::array<CellCube, 2> Halve(const CellCube& cube, int axis);
  void AddTasks(int cell, const CellCube& cube, bool isWhole);

  template <typename Visit>
  void Divide(const CellCube& cube, Visit& visit) const
  {
    const Relation relation = this->Relate(cube);
    const double limit = relation == Relation::Crossing ? this->Step / 8.0 : this->Step;
    Eigen::Index axis = 0;
    if (relation != Relation::Outside && FindEdges(cube).maxCoeff(&axis) > limit)
    {
      for (const CellCube& half : Halve(cube, static_cast<int>(axis)))
      {
        this->Divide(half, visit);
      }
      return;
    }
    const CubeSamples samples = SampleCube(cube);
    for (int i = 0; i < 8; ++i)
    {
      const Eigen::RowVector3d index = samples.Points.row(i);
      visit(index, samples.Volumes[i],
        relation == Relation::Inside || (relation == Relation::Crossing && this->Contains(index)));
    }
  }

  const Cells& Mesh;
  Eigen::MatrixXd Indices; ///< of the mesh's points
  Eigen::RowVector3d Low, High;
  double Step;
  std::vector<Task> Tasks;
  std::vector<CellCube> Cubes;
};

} // namespace shape
