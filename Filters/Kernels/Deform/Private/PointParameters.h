#pragma once

#include "Deform/DeformOptions.h"
#include "Deform/UpwindFront.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

namespace shape
{

/// The parameters of a deformation at each node of a graph.
struct PointParameters
{
  Eigen::VectorXd Powers; ///< k of equation 4
  Eigen::VectorXd Scales; ///< of offsets
};

/// Throws InvalidInput where an option is out of its range.
void RequireOptions(const DeformOptions& options);

/// Throws InvalidInput where a field has another size than there are points, or a value that is
/// negative or not finite.
void RequireFields(const DeformFields& fields, Eigen::Index points);

/// shape: the graph of the points that `fields` are given at; the first nodes of the swept graph
/// are its nodes. Throws InvalidInput (RequireFields).
PointParameters FindParameters(const PointGraph& shape, const FrontSweep& sweep,
  const DeformOptions& options, const DeformFields& fields);

} // namespace shape
