#include "Fill/HoleFiller.h"

#include "Base/Errors.h"
#include "Fill/LoopCorners.h"
#include "Fill/Private/FairPatch.h"
#include "Geometry/VertexNormals.h"
#include "Laplacian/Membrane.h"

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

const Eigen::MatrixXd NoNormals(0, 3);

/// Replaces a patch by the membrane with the same layout.
void Tauten(HolePatch& patch, const Eigen::MatrixXd& loop, const Progress& progress)
{
  // The layout is conformal to the membrane, and cotangent weights are conformally invariant: the
  // first harmonic map is already near.
  constexpr int rounds = 2;
  patch.Surface.Points = SolveMembrane(BuildFlatSurface(patch), loop, rounds, progress);
}

} // namespace

HoleFiller::HoleFiller(BoundaryLoop loop, const HoleFillerOptions& options)
  : Border(std::move(loop))
  , Options(options)
{
  RequireOption(options.EdgeGrowth >= 0.0 && options.EdgeGrowth <= 1.0, "EdgeGrowth",
    options.EdgeGrowth, "at least 0 and at most 1");
  RequireOption(options.MaximumPoints >= 1, "MaximumPoints", options.MaximumPoints, "at least 1");
  this->Sizes = { ComputeBoundarySizes(this->Border.Points), options.EdgeGrowth,
    options.MaximumPoints, options.IsTaken, FindOuterChords(this->Border) };
}

HoleFill HoleFiller::Fill(FillMethod method, const DeformOptions& options,
  const PoseOptions& frames, const Progress& progress)
{
  constexpr Eigen::Index fewest = 3;
  if (this->Border.Points.rows() < fewest)
  {
    HoleFill none;
    none.Patch = { this->Border.Points, Eigen::MatrixXi(0, 3) };
    return none;
  }
  switch (method)
  {
    case FillMethod::Deformation:
      return this->Deformation(options, frames, progress);
    case FillMethod::Membrane:
      return this->Membrane(progress);
    default:
      return this->Fair(progress);
  }
}

/// The membrane; its normals replace those that the loop lacks.
const HolePatch& HoleFiller::Span(const Progress& progress)
{
  if (!this->Coarse)
  {
    const Eigen::MatrixXd& points = this->Border.Points;
    this->Coarse = BuildMembranePatch(points, this->Sizes, progress);
    const Eigen::MatrixXd normals =
      ComputePatchBoundaryNormals(this->Coarse->Surface, points.rows());
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
    {
      if (this->Border.Normals.row(i).squaredNorm() == 0.0)
      {
        this->Border.Normals.row(i) = normals.row(i);
      }
    }
  }
  return *this->Coarse;
}

double HoleFiller::Deviation(const Mesh& patch) const
{
  return ComputeMeanAngle(
    ComputePatchBoundaryNormals(patch, this->Border.Points.rows()), this->Border.Normals);
}

/// Section 4.1 of Schmidt and Singh: membrane, free-boundary map, and deformation of the flat disk.
HoleFill HoleFiller::Deformation(
  const DeformOptions& options, const PoseOptions& frames, const Progress& progress)
{
  if (!this->Deformed)
  {
    HolePatch patch = RemeshPatch(
      this->Span(progress.Part(0.0, 0.2)), this->Sizes, NoNormals, progress.Part(0.2, 0.4));
    this->Deformed = std::make_unique<HoleDeformation>(
      std::move(patch), this->Border, this->Options.OptimizeNormals, progress.Part(0.4, 0.7));
  }
  HoleFill fill;
  fill.Patch.Triangles = this->Deformed->Triangles();
  fill.Patch.Points = this->Deformed->Points(options, frames, progress.Part(0.7, 1.0));
  fill.DeviationBefore = this->Deformed->DeviationBefore();
  fill.DeviationAfter = this->Deviation(fill.Patch);
  return fill;
}

/// The fair surface that section 4.1 recommends for loops far from a plane (Schneider and Kobbelt).
HoleFill HoleFiller::Fair(const Progress& progress)
{
  if (!this->FairFill)
  {
    const HolePatch& membrane = this->Span(progress.Part(0.0, 0.1));
    FairPatchResult fair =
      BuildFairPatch(membrane, this->Border, this->Sizes, progress.Part(0.1, 1.0));
    HoleFill fill;
    fill.Patch = std::move(fair.Patch);
    fill.DeviationBefore = this->Deviation(membrane.Surface);
    fill.DeviationAfter = this->Deviation(fill.Patch);
    fill.Converged = fair.Converged;
    constexpr double unsettled = 45.0;
    fill.IsSound = !fair.IsBalloon && (fair.Converged || fill.DeviationAfter < unsettled);
    this->FairFill = std::move(fill);
  }
  return *this->FairFill;
}

HoleFill HoleFiller::Membrane(const Progress& progress)
{
  if (!this->MembraneFill)
  {
    HolePatch patch = RemeshPatch(
      this->Span(progress.Part(0.0, 0.3)), this->Sizes, NoNormals, progress.Part(0.3, 0.6));
    Tauten(patch, this->Border.Points, progress.Part(0.6, 1.0));
    HoleFill fill;
    fill.Patch = std::move(patch.Surface);
    fill.DeviationBefore = fill.DeviationAfter = this->Deviation(fill.Patch);
    this->MembraneFill = std::move(fill);
  }
  return *this->MembraneFill;
}

/// The flat disk is the shape, its outline the handle. Equation 12 is solved once, here.
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
  // The normals at the loop depend on the triangles beside it only.
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
  // The frame without bias is that of the flat disk, laid into the hole.
  BiasFrames(this->Handle, this->Handle.Normals, frames, pose,
    FitHandleRotation(this->Handle, this->Loop.Points));
  const double all = std::numeric_limits<double>::infinity();
  Eigen::MatrixXd points = this->Prepared->Deform(pose, all, progress.Part(0.7, 1.0)).Points;
  // Exact to the last bit, so that the fill joins the surface.
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
