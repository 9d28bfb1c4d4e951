#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <vector>

namespace shape
{

/**
 * The energy of the hexahedra around a point, as a function of the point's position x:
 *
 *   E(x) = sum over the corners that x belongs to of exp(sharpness (1 - s)).
 *
 * s is the determinant of a corner's three edges, divided by the product of their lengths. If the
 * determinant is not negative, each length is replaced by sqrt(length^2 + minimum^2): otherwise
 * edges could shrink to nothing at no cost. If the determinant is negative, lengths are not
 * changed, so that shrinking does not lower the energy.
 *
 * minimum is 0.05 times the mean edge length of the hexahedron. It is not updated while points
 * move. Otherwise the energies around different points would not be parts of one total energy, and
 * lowering one after another would not converge.
 *
 * The energy is defined for any position, even if hexahedra are inverted. The greater the
 * sharpness, the more the worst corner dominates: log(E) / sharpness tends to 1 - min s.
 */
class StarEnergy
{
public:
  /// Hexahedra whose corners are contiguous in memory.
  using Corners = Eigen::Matrix<int, Eigen::Dynamic, 8, Eigen::RowMajor>;

  /// around: the hexahedra around the point, each with the index of the point among its corners.
  /// leastSquares: minimum^2 of each hexahedron.
  StarEnergy(const Eigen::Matrix3Xd& points, const Corners& hexahedra,
    const Eigen::VectorXd& leastSquares, const std::vector<std::array<int, 2>>& around);

  /// Returns minimum^2 of each hexahedron.
  static Eigen::VectorXd MinimumSquares(const HexMesh& mesh);

  double Value(const Eigen::Vector3d& x, double sharpness) const;

  struct Expansion
  {
    double Value = 0.0;
    Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
    /// A positive definite approximation of the Hessian. The terms with first derivatives of s are
    /// exact, and those with second derivatives are approximated.
    Eigen::Matrix3d Curvature = Eigen::Matrix3d::Zero();
  };
  Expansion Expand(const Eigen::Vector3d& x, double sharpness) const;

  /// Returns the length of the longest edge from x to a neighbour.
  double Reach(const Eigen::Vector3d& x) const;

private:
  /// A hexahedron seen from one of its corners. Ends: the ends of the three edges from the corner.
  /// Across: for each of the three faces at the corner, the diagonally opposite corner of the face.
  /// The face of edges 2 and 3 comes first, and the others follow in cyclic order.
  struct View
  {
    std::array<Eigen::Vector3d, 3> Ends, Across;
    double MinimumSquare;
  };
  boost::container::small_vector<View, 12> Views; // most points have 8
};

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
