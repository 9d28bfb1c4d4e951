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

/// What was met while a deformation was prepared.
struct DeformFacts
{
  int Islands = 0;       ///< pieces that no edge joins to the handle, joined where they are nearest
  int EmptyBands = 0;    ///< points with nothing within UpwindRadius before them
  int ZeroWeights = 0;   ///< points upwind of which all weights are 0
  int WeldedPoints = 0;  ///< points at the place of an earlier one
  int Segments = 0;      ///< connected parts of one label; 0 without labels
  int BasePoints = 0;    ///< of the coarse shape; 0 in full resolution
  bool Streamed = false; ///< the weights are too many to be kept
};

struct DeformedShape
{
  Eigen::MatrixXd Points;                 ///< n x 3
  std::vector<Eigen::Matrix3d> Rotations; ///< n: how the shape turns at each point
};

/**
 * A shape prepared for being deformed by one handle, again and again: the weights are kept, so that
 * a new pose of the handle is one pass over them.
 *
 * Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010), equations 4 to
 * 9. Where sample q_j goes to qhat_j and turns by R_j, point p goes to
 *
 *   phat = sum_j w_j (qhat_j + s R_j (p - q_j)) / sum_j w_j,
 *
 * and turns by the rotation nearest to sum_j w_j R_j, which is the blend of frames of section 2.1
 * without the frames: those of inner points cancel. A rigid motion of the handle is that motion of
 * the shape, for any weights; with the handle scaled by s = Scale, that similarity; an unmoved
 * handle returns the points themselves, bit for bit.
 */
class ShapeDeformation
{
public:
  /// See PrepareDeformation.
  ShapeDeformation(const PointGraph& graph, const BoundaryHandle& handle,
    const DeformOptions& options = {}, const DeformFields& fields = {},
    const Progress& progress = {});
  ~ShapeDeformation();

  /// The shape where the handle has this pose. Points that the front reaches later than `reach`, in
  /// the model's units, need not be computed: their rows mean nothing. A pass over few points is
  /// quick: for optimisations of the frames (equation 12). Several threads may call it. Throws
  /// InvalidInput where the pose has another number of samples; Aborted.
  DeformedShape Deform(const HandlePose& pose,
    double reach = std::numeric_limits<double>::infinity(), const Progress& progress = {}) const;

  /// When the front arrives at each point (n): how far it is from the handle along edges.
  const Eigen::VectorXd& Arrivals() const;

  const DeformFacts& Facts() const;

private:
  struct Prepared;
  std::unique_ptr<Prepared> Impl;
};

/**
 * Prepares a shape for a handle by the method and at the resolution that the options name.
 *
 * graph: of the shape's points (BuildPointGraph). Throws InvalidInput where an option is out of its
 * range, a field has another size, the handle has no samples or a wrong one, or the shape is less
 * than 1e-9 as large as it and the handle together; Aborted.
 */
std::unique_ptr<ShapeDeformation> PrepareDeformation(const PointGraph& graph,
  const BoundaryHandle& handle, const DeformOptions& options = {}, const DeformFields& fields = {},
  const Progress& progress = {});

} // namespace shape
