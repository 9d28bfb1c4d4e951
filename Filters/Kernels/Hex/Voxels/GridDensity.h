#pragma once

#include "Distance/HausdorffDistance.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// Magnifies space by a factor exp(Strength) at Centre, which fades within a few Radius.
struct RefinementSeed
{
  Eigen::RowVector3d Centre;
  double Radius = 1.0;
  double Strength = 0.0;
};

/**
 * A smooth one-to-one map that magnifies space around some positions. A uniform grid in its image
 * is therefore finer there. The map is the flow, for a time of 1, of the velocity
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

/// Collects seeds at positions that need smaller cells. A position close to an earlier seed is
/// ignored.
class RefinementSeeds
{
public:
  /// cellSize: the cell size of the grid that the positions belong to.
  explicit RefinementSeeds(double cellSize)
    : CellSize(cellSize)
  {
  }

  /// times: the strength of the seed, relative to the usual one.
  void Add(const Eigen::RowVector3d& centre, double times = 1.0);

  /// Adds the positions whose distance is at least 0.9 of `wanted`, the farthest first. The farther
  /// a position, the stronger its seed.
  void AddDistant(const SampledDistances& far, double wanted);

  /// Adds the centroids of hexahedra whose scaled Jacobian is below `accepted`.
  void AddBad(const HexMesh& mesh, double accepted);

  const std::vector<RefinementSeed>& Seeds() const { return this->Gathered; }

  /// Whether the seeds magnify a large part, about 0.3, of a solid with this number of cells.
  bool AreMostOf(Eigen::Index cells) const;

private:
  double CellSize;
  std::vector<RefinementSeed> Gathered;
};

} // namespace shape
