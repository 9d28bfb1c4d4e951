#pragma once

#include "Base/Progress.h"
#include "Deform/BoundaryHandle.h"
#include "Deform/DeformOptions.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <vector>

namespace shape
{

/// Facts about a prepared deformation.
struct DeformFacts
{
  /// Number of components not connected to the handle; each is linked at its nearest points.
  int Islands = 0;
  int EmptyBands = 0;    ///< number of points that have no upwind point within UpwindRadius
  int ZeroWeights = 0;   ///< number of points for which all upwind weights are 0
  int WeldedPoints = 0;  ///< number of points that coincide with an earlier one
  int Segments = 0;      ///< number of connected parts, each of one label; 0 without labels
  int BasePoints = 0;    ///< number of points of the coarse shape; 0 in full resolution
  bool Streamed = false; ///< whether the weights are too many to be stored
};

struct DeformedShape
{
  Eigen::MatrixXd Points;                 ///< n x 3
  std::vector<Eigen::Matrix3d> Rotations; ///< n rotations of the shape, one at each point
  Eigen::VectorXd Arrivals = {};          ///< n arrival times (ShapeDeformation::Arrivals), or none
  Eigen::VectorXi Protrusions = {};       ///< n labels (ShapeDeformation::Protrusions), or none
};

/**
 * A shape prepared for being deformed by one handle any number of times. It stores the weights, so
 * a new pose of the handle takes one pass over them.
 *
 * See equations 4 to 9 of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics
 * Interface 2010). If sample q_j goes to qhat_j and rotates by R_j, point p goes to
 *
 *   phat = sum_j w_j (qhat_j + s R_j (p - q_j)) / sum_j w_j,
 *
 * and rotates by the rotation nearest to sum_j w_j R_j. This equals the blend of frames of section
 * 2.1, but needs no frames, since the frames of inner points cancel. A rigid motion of the handle
 * moves the shape rigidly, for any weights. If the handle is also scaled by s = Scale, the shape
 * undergoes that similarity. If the handle does not move, the points are returned unchanged, bit
 * for bit.
 */
class ShapeDeformation
{
public:
  /// See PrepareDeformation.
  ShapeDeformation(const PointGraph& graph, const BoundaryHandle& handle,
    const DeformOptions& options = {}, const DeformFields& fields = {},
    const Progress& progress = {});
  ~ShapeDeformation();

  /// Returns the shape for a pose of the handle. Points that the front reaches later than `reach`,
  /// in the model's units, may be left out; their rows are then undefined. This makes a pass over
  /// few points fast, for the optimisation of frames (equation 12). Several threads may call it.
  /// Throws InvalidInput if the pose does not have one position and one rotation for each sample;
  /// Aborted.
  DeformedShape Deform(const HandlePose& pose,
    double reach = std::numeric_limits<double>::infinity(), const Progress& progress = {}) const;

  /// The arrival time of the front at each point (n values): its distance from the handle along
  /// edges.
  const Eigen::VectorXd& Arrivals() const;

  /// The label of the protrusion that contains each point (FindProtrusions; n values), if SegmentBy
  /// is Protrusions; otherwise none.
  const Eigen::VectorXi& Protrusions() const;

  const DeformFacts& Facts() const;

private:
  struct Prepared;
  std::unique_ptr<Prepared> Impl;
};

/**
 * Prepares a shape for a handle by the method and at the resolution of the options.
 *
 * graph: the shape's points and their links (BuildPointGraph). Throws InvalidInput if an option is
 * out of range, a field has the wrong size, or the handle has no samples or an invalid one. Also
 * throws InvalidInput if the shape is smaller than 1e-9 of the common bounding box of shape and
 * handle. Throws Aborted.
 */
std::unique_ptr<ShapeDeformation> PrepareDeformation(const PointGraph& graph,
  const BoundaryHandle& handle, const DeformOptions& options = {}, const DeformFields& fields = {},
  const Progress& progress = {});

} // namespace shape
