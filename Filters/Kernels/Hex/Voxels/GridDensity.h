#pragma once

#include "Distance/HausdorffDistance.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// Magnifies space at Centre by the factor exp(Strength). The magnification fades within a few
/// times Radius.
struct RefinementSeed
{
  Eigen::RowVector3d Centre;
  double Radius = 1.0;
  double Strength = 0.0;
};

/**
 * A smooth one-to-one map that magnifies space around some positions. A uniform grid in the map's
 * image, mapped back, is therefore finer around these positions. The map is the flow over unit time
 * of the velocity
 *
 *   v(x) = sum over seeds of Strength (x - Centre) exp(-|x - Centre|^2 / (2 Radius^2)).
 *
 * A flow never folds, whatever the seeds are.
 */
class GridDensity
{
public:
  explicit GridDensity(std::vector<RefinementSeed> seeds = {})
    : Seeds(std::move(seeds))
  {
  }

  bool IsIdentity() const { return this->Seeds.empty(); }

  /// Maps positions by the flow. points: n x 3.
  Eigen::MatrixXd Forward(const Eigen::MatrixXd& points) const { return this->Flow(points, 1.0); }
  /// The inverse of Forward.
  Eigen::MatrixXd Backward(const Eigen::MatrixXd& points) const { return this->Flow(points, -1.0); }

private:
  Eigen::RowVector3d Velocity(const Eigen::RowVector3d& position) const;
  Eigen::MatrixXd Flow(const Eigen::MatrixXd& points, double time) const;

  std::vector<RefinementSeed> Seeds;
};

/// Collects seeds at positions that need smaller cells. A position close to an existing seed is
/// ignored.
class RefinementSeeds
{
public:
  /// cellSize: the cell size of the grid that the positions belong to.
  explicit RefinementSeeds(double cellSize)
    : CellSize(cellSize)
  {
  }

  /// Adds a seed at a position. times: the strength of the seed, as a multiple of the usual
  /// strength.
  void Add(const Eigen::RowVector3d& centre, double times = 1.0);

  /// What AddDistant counts as distant, as a fraction of the wanted distance.
  static constexpr double DistantShare = 0.9;

  /// Adds the positions whose distance is at least DistantShare times `wanted`, the farthest first.
  /// For distances above 4 times `wanted`, the strength of the seed grows with the distance. From 8
  /// times `wanted` on, it is twice the usual strength.
  void AddDistant(const SampledDistances& far, double wanted);

  /// Adds the centroids of the hexahedra whose scaled Jacobian is below `accepted`.
  void AddBad(const HexMesh& mesh, double accepted);

  const std::vector<RefinementSeed>& Seeds() const { return this->Gathered; }

  /// Whether the seeds magnify more than about 0.3 of a solid's volume. cells: the number of cells
  /// of the solid.
  bool AreMostOf(Eigen::Index cells) const;

private:
  double CellSize;
  std::vector<RefinementSeed> Gathered;
};

} // namespace shape
