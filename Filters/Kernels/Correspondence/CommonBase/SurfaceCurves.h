#pragma once

#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// A curve along edges of two surfaces: for each surface, its points in order. Consecutive points
/// are joined by an edge. A closed curve ends at the point where it begins, on both surfaces.
struct CurvePair
{
  std::vector<int> OnA, OnB;
};

/// Returns the points of a curve along edges that passes the points nearest to positions (k x 3) in
/// order, by shortest paths along edges. Where these points jump to and fro by an edge or two, what
/// lies between is left out. name: of the surface, in messages. Throws InvalidInput if a position
/// is not finite or far from the surface (FindNearestPoints), or if the curve is not longer than an
/// edge, or closed without enclosing anything.
std::vector<int> TraceEdgeCurve(
  const Surface& surface, const Eigen::MatrixXd& positions, const std::string& name);

/// Returns a curve with the points that have new numbers on A and B.
CurvePair Renumber(
  const CurvePair& curve, const Eigen::VectorXi& numbersOfA, const Eigen::VectorXi& numbersOfB);

} // namespace shape
