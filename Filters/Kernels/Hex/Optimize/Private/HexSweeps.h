#pragma once

#include "Base/Progress.h"
#include "Hex/Optimize/Private/StarEnergy.h"
#include "Mesh/HexMesh.h"
#include "Untangle/FoldoverFree.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Moves the points of hexahedra one by one, each by what the hexahedra around it want. Points are
 * moved in sets without a common hexahedron, so any number of threads gives the same bits.
 */
class HexSweeps
{
public:
  /// All indices must be in range. The constraint must outlive this; the mesh is copied.
  HexSweeps(const HexMesh& mesh, const PointConstraint& constraint);

  /// Lowers the energy around all points, or those that are marked (StarEnergy). Points around
  /// which nothing has moved since the last time are left out.
  void Lower(double sharpness, const std::vector<char>& marked = {}, const Progress& progress = {});

  /// Moves all points, or those that are marked, half way to the middle of those neighbours that
  /// are as little free as they are: a point of a surface stays amidst those of the surface.
  void Smooth(const std::vector<char>& marked = {}, const Progress& progress = {});

  /// Puts every point where it may be.
  void Project();

  Eigen::MatrixXd Positions() const { return this->Points.transpose(); }

private:
  void FindIndependentSets();
  template <typename Body>
  void ForAll(const std::vector<char>& marked, const Progress& progress, const Body& body);
  void MoveTowardsMean(int point);
  void Move(int point, double sharpness);

  /// Whether nothing in the star of a point has moved since it was moved with this sharpness.
  bool IsAtRest(int point) const;

  const StarEnergy::Corners Hexahedra;
  const Eigen::VectorXd MinimumSquares; ///< of each hexahedron, see StarEnergy
  Eigen::Matrix3Xd Points;
  const PointConstraint& Constraint;
  std::vector<std::vector<std::array<int, 2>>> Around;
  std::vector<std::vector<int>> IndependentSets;
  double Sharpness = 0.0;             ///< of the last sweep
  int Now = 0;                        ///< counts the sets that were gone over
  std::vector<int> MovedAt, LookedAt; ///< when each point has last changed, and been tried
};

} // namespace shape
