#pragma once

#include "Deform/UpwindFront.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

namespace shape
{

/// The options of a deformation. Numbers are at most 1e6. Sections, equations and figures are those
/// of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010).
struct DeformOptions
{
  enum class MethodType
  {
    UpwindFront,     ///< each point relative to the points directly upwind (section 2.1)
    BoundaryRelative ///< each point relative to the handle alone (equation 5)
  };
  MethodType Method = MethodType::UpwindFront;
  /// BoundaryRelative only: whether equation 2 is integrated along the curves of the handle, in
  /// closed form, instead of summed over their points. The result then does not depend on how
  /// straight parts of the curves are sampled. The closed form exists for k = 2 and Euclidean
  /// distances, so it is off by default; with it, any other Rigidity is refused.
  bool IntegrateCurves = false;
  /// The rigidity of the shape; > 0. The power k of equation 4 is 2 / Rigidity, at most 32.
  double Rigidity = 1.0;
  enum class RigidityByType
  {
    Uniform,
    Distance, ///< the farthest points are RigidityContrast times as rigid as the handle
    Curvature ///< flat parts are RigidityContrast times as rigid as the most curved ones
  };
  RigidityByType RigidityBy = RigidityByType::Uniform;
  double RigidityContrast = 4.0; ///< > 0
  double Scale = 1.0;            ///< factor of the offsets from upwind points to a point; > 0
  /// Factor of Scale at the points farthest from the handle; > 0. Elsewhere, the factor changes
  /// linearly with the arrival time, from 1 at the handle.
  double InnerScale = 1.0;
  /// r_u of equation 6, in mean edges; > 0. A larger radius pulls the shape towards the handle.
  double UpwindRadius = 2.1;
  using DistanceType = FrontDistance;
  DistanceType Distance = DistanceType::Euclidean; ///< d of equation 4
  enum class MultiresolutionType
  {
    Automatic, ///< on for shapes with more than 2000 points
    On,
    Off
  };
  MultiresolutionType Multiresolution = MultiresolutionType::Automatic;
  enum class SegmentByType
  {
    Array,      ///< parts by DeformFields::Segments, or one part if there are no labels
    Protrusions ///< parts by the protrusions of the shape (FindProtrusions)
  };
  SegmentByType SegmentBy = SegmentByType::Array;
  /// The minimum length of a protrusion, as a share of the last arrival time; from 0 to 1.
  double MinimumProtrusion = 0.1;
  /// Whether the deformed shape is smoothed, which spreads the distortion evenly (Fig. 16).
  bool LaplacianSmoothing = false;
};

bool operator==(const DeformOptions& a, const DeformOptions& b);

/// Returns whether the method is boundary-relative and integrates along curves.
bool IntegratesCurves(const DeformOptions& options);

/// Values at the points of a shape; each has n entries or none.
struct DeformFields
{
  Eigen::VectorXd Rigidity; ///< factor of DeformOptions::Rigidity; >= 0
  Eigen::VectorXd Scale;    ///< factor of DeformOptions::Scale; >= 0
  Eigen::VectorXi Segments; ///< labels of parts that are deformed one after another (Fig. 9)
};

/// The parameters of a deformation at each node of a graph.
struct PointParameters
{
  Eigen::VectorXd Powers; ///< k of equation 4
  Eigen::VectorXd Scales; ///< factors of the offsets
};

/// Throws InvalidInput if an option is out of range.
void RequireOptions(const DeformOptions& options);

/// Throws InvalidInput if the size of a field is not the number of points, or if a value is
/// negative or not finite.
void RequireFields(const DeformFields& fields, Eigen::Index points);

/// Computes the parameters of each node of the swept graph. shape: the graph of the points to which
/// `fields` belong; its nodes are the first nodes of the swept graph. Throws InvalidInput when
/// RequireFields does.
PointParameters FindParameters(const PointGraph& shape, const FrontSweep& sweep,
  const DeformOptions& options, const DeformFields& fields);

} // namespace shape
