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
 * The hexahedra around a point, as a function of where it is:
 *
 *   E(x) = sum over the corners that x belongs to of exp(sharpness (1 - s)),
 *
 * s being the determinant of a corner's three edges divided by their lengths, where it is positive
 * by sqrt(length^2 + minimum^2): the scaled Jacobian alone would let edges shrink to nothing.
 * minimum is 0.05 of an edge of the hexahedron, and stays so while points move: else the stars
 * would not be parts of one energy, and lowering them by turns would lead nowhere. (Where it is
 * negative, shrinking must not help.) Any position has a value, also where hexahedra are inverted.
 * The greater the sharpness, the more it is the worst corner that counts: log(E) / sharpness tends
 * to 1
 * - min s.
 */
class StarEnergy
{
public:
  /// Hexahedra whose corners are beside each other in memory.
  using Corners = Eigen::Matrix<int, Eigen::Dynamic, 8, Eigen::RowMajor>;

  /// around: the hexahedra of a point, each with the corner that it is; leastSquares: minimum^2 of
  /// each hexahedron.
  StarEnergy(const Eigen::Matrix3Xd& points, const Corners& hexahedra,
    const Eigen::VectorXd& leastSquares, const std::vector<std::array<int, 2>>& around);

  /// minimum^2 of each hexahedron.
  static Eigen::VectorXd MinimumSquares(const HexMesh& mesh);

  double Value(const Eigen::Vector3d& x, double sharpness) const;

  struct Expansion
  {
    double Value = 0.0;
    Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
    /// A positive definite stand-in for the second derivative: exact in the first derivatives of s.
    Eigen::Matrix3d Curvature = Eigen::Matrix3d::Zero();
  };
  Expansion Expand(const Eigen::Vector3d& x, double sharpness) const;

  /// The length of the longest edge from x to a neighbour.
  double Reach(const Eigen::Vector3d& x) const;

private:
  /// A hexahedron seen from one of its corners: the ends of the three edges from there, and the
  /// corners across the faces between the second and third of them, and so on around.
  struct View
  {
    std::array<Eigen::Vector3d, 3> Ends, Across;
    double MinimumSquare;
  };
  boost::container::small_vector<View, 12> Views; // 8 at most points
};

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
