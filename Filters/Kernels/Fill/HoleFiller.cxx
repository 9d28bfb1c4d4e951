#include "Fill/HoleFiller.h"

#include "Base/Errors.h"
#include "Fill/Private/FairPatch.h"
#include "Fill/Private/OuterChords.h"
#include "Laplacian/Membrane.h"

#include <utility>

namespace shape
{
namespace
{

const Eigen::MatrixXd NoNormals(0, 3);

/// The membrane of a patch's own layout.
void Tauten(HolePatch& patch, const Eigen::MatrixXd& loop, const Progress& progress)
{
  constexpr int rounds = 2;
  patch.Surface.Points = SolveMembrane(BuildFlatSurface(patch), loop, rounds, progress);
}

} // namespace

HoleFiller::HoleFiller(BoundaryLoop loop, const HoleFillerOptions& options)
  : Border(std::move(loop))
  , Options(options)
{
  RequireOption(options.EdgeGrowth >= 0.0, "EdgeGrowth", options.EdgeGrowth, "at least 0");
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

/// The membrane, and its normals where the rim has none.
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

} // namespace shape
