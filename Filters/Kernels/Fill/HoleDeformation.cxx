#include "Fill/HoleDeformation.h"

#include "Fill/RimNormals.h"

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace shape
{
HoleDeformation::HoleDeformation(
  HolePatch patch, SurfaceRim rim, bool optimizeNormals, const Progress& progress)
  : Patch(std::move(patch))
  , Rim(std::move(rim))
  , Graph(MakePointGraph(FlatSurface(this->Patch)))
{
  const Eigen::Index corners = this->Rim.Points.rows();
  Eigen::MatrixXd up = Eigen::MatrixXd::Zero(corners, 3);
  up.col(2).setOnes();
  this->Handle = CurveHandle(this->Graph.Places.topRows(corners), true, up);
  this->Prepared =
    PrepareDeformation(this->Graph, this->Handle, this->PreparedFor, {}, progress.Part(0.0, 0.5));
  BoundaryNormalsOptions options;
  options.LineSearches = optimizeNormals ? options.LineSearches : 0;
  options.Reach = 4.0 * this->Graph.MeanLength;
  this->Frames = OptimizeBoundaryNormals(
    *this->Prepared, this->Handle, PoseHandle(this->Handle, this->Rim.Points, this->Rim.Normals),
    this->Rim.Normals,
    [&](const DeformedShape& shape) {
      return PatchRimNormals({ shape.Points, this->Triangles() }, corners);
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
  points.topRows(this->Rim.Points.rows()) = this->Rim.Points;
  return points;
}

Eigen::MatrixXd PatchRimNormals(const Mesh& patch, Eigen::Index rim)
{
  std::vector<int> points(rim);
  std::iota(points.begin(), points.end(), 0);
  return RimNormals(patch, TriangleFans(patch.Triangles, patch.Points.rows()), points);
}

} // namespace shape
