#include "Deform/Private/HandleSources.h"

#include "Geometry/FitRotation.h"

namespace shape
{

NodeTransforms MoveSources(const HandleSources& sources, const BoundaryHandle& handle,
  const HandlePose& pose, const Eigen::VectorXd& scales)
{
  const auto count = static_cast<Eigen::Index>(sources.Nodes.size());
  NodeTransforms motions{ Eigen::MatrixXd(3, count), {} };
  motions.Rotations.reserve(count);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero(), shift = position;
    Eigen::Matrix3d blend = Eigen::Matrix3d::Zero();
    for (int c = 0; c < 3; ++c)
    {
      const int sample = sources.Samples(k, c);
      const double share = sources.Shares(k, c);
      position += share * handle.Positions.row(sample);
      shift += share * (pose.Positions.row(sample) - handle.Positions.row(sample));
      blend += share * pose.Rotations[sample];
    }
    // At a sample the rotation is taken as it is: a fit would change its last bits.
    const bool atSample = sources.Shares(k, 0) == 1.0;
    motions.Rotations.push_back(
      atSample ? pose.Rotations[sources.Samples(k, 0)] : FitBlendedRotation(blend));
    // Nodes are on the handle except for rounding, perhaps to single precision.
    const int node = sources.Nodes[k];
    const Eigen::RowVector3d rest = sources.Graph.Positions.row(node) - position;
    const Eigen::Matrix3d turn =
      scales(node) * motions.Rotations.back() - Eigen::Matrix3d::Identity();
    motions.Shifts.col(k) = shift.transpose() + turn * rest.transpose();
  }
  return motions;
}

} // namespace shape
