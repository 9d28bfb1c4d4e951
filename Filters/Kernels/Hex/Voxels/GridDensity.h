#pragma once

#include "Distance/HausdorffDistance.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// Space grows around a position: by exp(Strength) there, less and less up to some Radii away.
struct RefinementSeed
{
  Eigen::RowVector3d Centre;
  double Radius = 1.0;
  double Strength = 0.0;
};

/**
 * A smooth one-to-one map of space that magnifies it around some positions, so that a uniform grid
 * in its image is a finer one there: the flow, for a time of 1, of the velocity
 *
 *   v(x) = sum over seeds of Strength (x - Centre) exp(-|x - Centre|^2 / (2 Radius^2)).
 *
 * A flow cannot fold, whatever the seeds are.
 */
class GridDensity
{
public:
  explicit GridDensity(std::vector<RefinementSeed> seeds = {})
    : Seeds(std::move(seeds))
  {
  }

  bool IsIdentity() const { return this->Seeds.empty(); }

  /// points: n x 3.
  Eigen::MatrixXd Forward(const Eigen::MatrixXd& points) const { return this->Flow(points, 1.0); }
  Eigen::MatrixXd Backward(const Eigen::MatrixXd& points) const { return this->Flow(points, -1.0); }

private:
  Eigen::RowVector3d Velocity(const Eigen::RowVector3d& position) const;
  Eigen::MatrixXd Flow(const Eigen::MatrixXd& points, double time) const;

  std::vector<RefinementSeed> Seeds;
};

/// Gathers positions that ask for smaller cells into seeds that are apart from each other: of two
/// that are near only the first stays.
class RefinementSeeds
{
public:
  /// cellSize: of the grid that they are positions of.
  explicit RefinementSeeds(double cellSize)
    : CellSize(cellSize)
  {
  }

  /// times: how much stronger than usual its seed is.
  void Add(const Eigen::RowVector3d& centre, double times = 1.0);

  /// Those that are farther than nearly wanted, the farthest first, the stronger the farther.
  void AddDistant(const SampledDistances& far, double wanted);

  /// Hexahedra of a lower scaled Jacobian than accepted.
  void AddBad(const HexMesh& mesh, double accepted);

  const std::vector<RefinementSeed>& Seeds() const { return this->Gathered; }

  /// Whether the seeds are for most of a solid of this many cells.
  bool AreMostOf(Eigen::Index cells) const;

private:
  double CellSize;
  std::vector<RefinementSeed> Gathered;
};

} // namespace shape
