#pragma once

#include "Distance/HausdorffDistance.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Gathers places that ask for smaller cells into magnifiers that are apart from each other: of two
/// that are near only the first stays.
class RefinementSeeds
{
public:
  /// cellSize: of the grid that they are places of.
  explicit RefinementSeeds(double cellSize)
    : CellSize(cellSize)
  {
  }

  /// times: how much stronger than usual its magnifier is.
  void Add(const Eigen::RowVector3d& centre, double times = 1.0);

  /// Those that are farther than nearly wanted, the farthest first, the stronger the farther.
  void AddDistant(const SampledDistances& far, double wanted);

  /// Hexahedra of a lower scaled Jacobian than accepted.
  void AddBad(const HexMesh& mesh, double accepted);

  const std::vector<RefinementSeed>& Seeds() const { return this->Gathered; }

  /// Whether the magnifiers are for most of a solid of so many cells.
  bool AreMostOf(Eigen::Index cells) const;

private:
  double CellSize;
  std::vector<RefinementSeed> Gathered;
};

} // namespace shape
