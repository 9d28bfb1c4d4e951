#pragma once

#include "Deform/Private/NodeDeformation.h"

#include <Eigen/Core>

namespace shape
{

/// Integrals along a segment, over s from 0 at its first end to 1 at its last, of a function of s
/// divided by d^2 + epsilon, where d is the distance of a point from the position at s.
struct SegmentIntegrals
{
  double First; ///< of 1 - s
  double Last;  ///< of s
  double Inner; ///< of s (1 - s)
};

/**
 * Evaluates these integrals in closed form. first, last: the ends of the segment, relative to the
 * point; they must differ. epsilon: positive.
 *
 * Let L be the length of the segment, t = (s - 1/2) L the arc length from its midpoint, m that of
 * the point's foot on the segment's line, and h^2 the squared distance from this line plus epsilon.
 * Then d^2 + epsilon = (t - m)^2 + h^2, and with J_k the integral of t^k / ((t - m)^2 + h^2) over t
 * from -L/2 to L/2,
 *
 *   J_0 = angle / h, where the angle is that under which the segment is seen from the height h:
 *         its tangent is h L / (h^2 + m^2 - L^2 / 4);
 *   J_1 = m J_0 + 1/2 log(((L/2 - m)^2 + h^2) / ((L/2 + m)^2 + h^2)), because t = (t - m) + m;
 *   J_2 = L + 2 m J_1 - (m^2 + h^2) J_0, because t^2 = ((t - m)^2 + h^2) + 2 m t - (m^2 + h^2).
 *
 * With s = 1/2 + t/L, and ds = dt / L, the results are, in units of 1 / length^2,
 * First = (J_0 / 2 - J_1 / L) / L, Last = (J_0 / 2 + J_1 / L) / L, Inner = (J_0 / 4 - J_2 / L^2) /
 * L.
 */
SegmentIntegrals IntegrateInverseSquare(
  const Eigen::Vector3d& first, const Eigen::Vector3d& last, double epsilon);

/**
 * Boundary-relative deformation with the integral of equation 2 along the curves among the sources,
 * for the power k = 2 of equation 4, in closed form.
 *
 * Positions and frames are interpolated linearly along each segment: at s, the sample a + s (b - a)
 * goes to (1 - s) ahat + s bhat and rotates by (1 - s) R_a + s R_b. This matrix is in general no
 * rotation: across their common axis it shrinks offsets by up to the cosine of half the angle
 * between R_a and R_b. A rotation by a growing angle has no closed form; further samples with
 * rotations as frames reduce the angle. The prediction of the sample at s for a point p is then
 *
 *   (1 - s) (ahat + R_a (p - a)) + s (bhat + R_b (p - b)) + s (1 - s) (R_b - R_a) (b - a),
 *
 * so the integral of the predictions needs the three SegmentIntegrals alone. A further sample on a
 * segment, with the interpolated position and frame, changes nothing. Sources on no curve are added
 * with the weights of equation 5, relative to a strip along the curves that is CurveWidth wide.
 *
 * The integrals are evaluated in each pass, in double precision: nothing is stored.
 */
class BoundaryIntegral : public NodeDeformation
{
public:
  /// Throws InvalidInput if a power is not 2, if there is no curve, or if the graph is not
  /// connected; Aborted.
  explicit BoundaryIntegral(NodeProblem problem, const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

private:
  NodeProblem Problem;
  FrontSweep Sweep;
  Eigen::MatrixXd Rests; ///< 3 x n: the positions by rank, relative to the centre of the graph
  double Epsilon;        ///< of equation 4, in the model's units
};

} // namespace shape
