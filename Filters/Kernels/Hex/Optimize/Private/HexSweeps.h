#pragma once

#include "Base/Progress.h"
#include "Hex/Optimize/Private/StarEnergy.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Moves the points of hexahedra one after another to lower the energy around each point. Points
 * that share no hexahedron are moved in parallel, so any number of threads gives the same bits.
 */
class HexSweeps
{
public:
  /// Copies the mesh, whose indices must be in range. The constraint must outlive this object.
  HexSweeps(const HexMesh& mesh, const PointConstraint& constraint);

  /// Lowers the energy (StarEnergy) around each point, or around each marked point if `marked` is
  /// not empty. A point is skipped if its neighbourhood has not moved since the point's last
  /// update.
  void Lower(double sharpness, const std::vector<char>& marked = {}, const Progress& progress = {});

  /// Moves each point, or each marked point, half way to the mean of those neighbours that have no
  /// more freedom than the point, within the constraint. A point on the surface thus follows its
  /// neighbours on the surface only.
  void Smooth(const std::vector<char>& marked = {}, const Progress& progress = {});

  /// Projects every point to the nearest position that the constraint allows.
  void Project();

  /// Marks the points of hexahedra with a scaled Jacobian below `bad` (MarkPointsOfBadHexahedra).
  /// Only hexahedra that have changed since the last call are evaluated.
  std::vector<char> MarkBad(double bad);

  Eigen::MatrixXd Positions() const { return this->Points.transpose(); }

private:
  void FindIndependentSets();
  template <typename Body>
  void ForAll(const std::vector<char>& marked, const Progress& progress, const Body& body);
  void MoveTowardsMean(int point);
  void Move(int point, double sharpness);

  /// Whether a point was updated at this sharpness, and no point of the hexahedra around it has
  /// moved since then.
  bool IsAtRest(int point) const;

  const StarEnergy::Corners Hexahedra;
  const Eigen::VectorXd MinimumSquares; ///< minimum^2 of each hexahedron, see StarEnergy
  Eigen::Matrix3Xd Points;
  const PointConstraint& Constraint;
  std::vector<std::vector<std::array<int, 2>>> Around;
  std::vector<std::vector<int>> IndependentSets;
  double Sharpness = 0.0; ///< the sharpness of the last sweep
  int Now = 0;            ///< number of independent sets processed so far
  /// For each point: the value of Now when it last moved, and when it was last updated.
  std::vector<int> MovedAt, LookedAt;
  /// When each point last changed its position, by however little.
  std::vector<int> ChangedAt;
  Eigen::VectorXd ScaledJacobians; ///< of the hexahedra, at the last call of MarkBad
  int EvaluatedAt = 0;             ///< the value of Now then
};

} // namespace shape
