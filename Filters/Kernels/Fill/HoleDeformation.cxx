#include "Fill/HoleDeformation.h"

#include "Fill/LoopNormals.h"

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace shape
{
HoleDeformation::HoleDeformation(
  HolePatch patch, BoundaryLoop loop, bool optimizeNormals, const Progress& progress)
  : Patch(std::move(patch))
  , Loop(std::move(loop))
  , Graph(BuildPointGraph(BuildFlatSurface(this->Patch)))
{
  const Eigen::Index corners = this->Loop.Points.rows();
  Eigen::MatrixXd up = Eigen::MatrixXd::Zero(corners, 3);
  up.col(2).setOnes();
  this->Handle = BuildCurveHandle(this->Graph.Positions.topRows(corners), true, up);
  this->Prepared =
    PrepareDeformation(this->Graph, this->Handle, this->PreparedFor, {}, progress.Part(0.0, 0.5));
  BoundaryNormalsOptions options;
  options.LineSearches = optimizeNormals ? options.LineSearches : 0;
  options.Reach = 4.0 * this->Graph.MeanLength;
  this->Frames = OptimizeBoundaryNormals(
    *this->Prepared, this->Handle, PoseHandle(this->Handle, this->Loop.Points, this->Loop.Normals),
    this->Loop.Normals,
    [&](const DeformedShape& shape) {
      return ComputePatchBoundaryNormals({ shape.Points, this->Triangles() }, corners);
    },
    options, progress.Part(0.5, 1.0));
}

Eigen::MatrixXd HoleDeformation::Points(
  const DeformOptions& options, const PoseOptions& frames, const Progress& progress)
{
  if (!(options == this->PreparedFor))
  {
    this->Prepared =
      PrepareDeformation(this->Graph, this->Handle, options, {}, progress.Part(0.0, 0.7));
    this->PreparedFor = options;
  }
  HandlePose pose = this->Frames.Pose;
  BiasFrames(this->Handle, this->Handle.Normals, frames, pose);
  const double all = std::numeric_limits<double>::infinity();
  Eigen::MatrixXd points = this->Prepared->Deform(pose, all, progress.Part(0.7, 1.0)).Points;
  points.topRows(this->Loop.Points.rows()) = this->Loop.Points;
  return points;
}

Eigen::MatrixXd ComputePatchBoundaryNormals(const Mesh& patch, Eigen::Index loop)
{
  std::vector<int> points(loop);
  std::iota(points.begin(), points.end(), 0);
  return ComputeBoundaryNormals(patch, TriangleFans(patch.Triangles, patch.Points.rows()), points);
}

} // namespace shape
