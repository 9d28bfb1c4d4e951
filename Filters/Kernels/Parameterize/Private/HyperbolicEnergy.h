#pragma once

#include "Parameterize/HyperbolicTile.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// The position of a point: an isometry of an unknown point, or a given one.
struct HyperbolicPosition
{
  int Unknown = -1; ///< index, or -1 for a given position
  int Motion = -1;  ///< index of the isometry that moves the unknown, or -1 for none
  Eigen::Vector3d Given = Eigen::Vector3d::UnitZ(); ///< if there is no unknown
};

/// An edge between two positions.
struct HyperbolicEdge
{
  int From, To;  ///< indices of positions
  double Weight; ///< >= 0
};

/**
 * The discrete harmonic energy of a map to the hyperbolic plane: the sum of w d^2 / 2 over edges,
 * where d is the distance between an edge's ends (Aigerman and Lipman 2016, equation 1, halved). It
 * is convex along geodesics. At its minimum, each unknown lies in the convex hull of its
 * neighbours.
 *
 * Unknowns are points of the hyperboloid (HyperbolicTile.h). Derivatives refer to displacements
 * along geodesics, in an orthonormal frame at each point: two numbers for each unknown.
 */
class HyperbolicEnergy
{
public:
  HyperbolicEnergy(std::vector<HyperbolicPosition> positions, std::vector<HyperbolicMotion> motions,
    std::vector<HyperbolicEdge> edges, int unknowns);

  /// unknowns: n x 3.
  double Value(const Eigen::MatrixXd& unknowns) const;

  struct Derivatives
  {
    Eigen::VectorXd Gradient;            ///< 2 n
    Eigen::SparseMatrix<double> Hessian; ///< 2 n x 2 n, positive semi-definite
  };
  Derivatives Differentiate(const Eigen::MatrixXd& unknowns) const;

  /// Moves each unknown (n x 3) along a geodesic by its displacement (2 n).
  static Eigen::MatrixXd Move(
    const Eigen::MatrixXd& unknowns, const Eigen::VectorXd& displacements);

  /// Returns all positions (k x 3).
  Eigen::MatrixXd Positions(const Eigen::MatrixXd& unknowns) const;

private:
  /// A point and the frame at it.
  struct Framed
  {
    Eigen::Vector3d Point;
    Eigen::Matrix<double, 3, 2> Frame;
  };
  Eigen::Vector3d PointOf(int position, const Eigen::MatrixXd& unknowns) const;
  Framed FrameOf(int position, const Eigen::MatrixXd& unknowns) const;

  std::vector<HyperbolicPosition> All;
  std::vector<HyperbolicMotion> Motions;
  std::vector<Eigen::Matrix3d> Rounded; ///< the same, for the energy
  std::vector<HyperbolicEdge> Edges;
  int Unknowns;
};

} // namespace shape
