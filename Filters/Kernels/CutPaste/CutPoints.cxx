#include "CutPaste/CutPoints.h"

#include "Base/Errors.h"
#include "CutPaste/FootprintLayout.h"
#include "CutPaste/PointTarget.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/Extent.h"
#include "Mesh/UsedPoints.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Whether the marked points are to the left of the loop.
bool IsFeatureLeft(const SampledLoops& loops, const std::vector<int>& loop, LoopSide side,
  const std::vector<char>& isFeature)
{
  if (side == LoopSide::Left || side == LoopSide::Right)
  {
    return side == LoopSide::Left;
  }
  return loops.MarkSide(loop, LoopSide::Left) == isFeature;
}

double AreaOf(const SampledSurface& samples, const std::vector<char>& isFeature)
{
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(samples.Surface).rowwise().norm();
  double sum = 0.0;
  for (Eigen::Index t = 0; t < areas.size(); ++t)
  {
    bool isInside = true;
    for (const int corner : samples.Surface.Triangles.row(t))
    {
      isInside = isInside && isFeature[corner] != 0;
    }
    sum += isInside ? areas(t) * samples.Shares(t) : 0.0;
  }
  return sum;
}

} // namespace

PointCutter::PointCutter(SampledSurface samples, const Progress& progress)
  : Samples(std::move(samples))
  , Loops(std::make_unique<SampledLoops>(this->Samples, progress))
{
  RequireExtent(this->Samples.Surface.Points, "the points");
}

// 1. Trace the loop from point to point (SampledLoops::Trace).
// 2. Mark the points on the side that is the feature (SampledLoops::MarkSide).
// 3. Fill the hole of the rest (FillRest), and find the base on it (FindBase).
CutPointsResult PointCutter::Cut(
  const Eigen::MatrixXd& curve, const CutPointsOptions& options, const Progress& progress)
{
  CutPointsResult result;
  result.Loop =
    this->Loops->Trace(curve, progress.Part(0.0, 0.3, "connecting the loop on the points"));
  std::vector<char> isFeature = this->Loops->MarkSide(result.Loop, options.Side);
  if (!IsFeatureLeft(*this->Loops, result.Loop, options.Side, isFeature))
  {
    std::reverse(result.Loop.begin(), result.Loop.end());
  }
  std::vector<char> isRest(isFeature.size(), 0);
  std::transform(isFeature.begin(), isFeature.end(), isRest.begin(),
    [](char feature) { return static_cast<char>(feature == 0); });
  for (std::size_t i = 0; i < result.Loop.size(); ++i)
  {
    isFeature[result.Loop[i]] = 1;
    result.CutLength += (this->Samples.Surface.Points.row(result.Loop[i]) -
      this->Samples.Surface.Points.row(result.Loop[(i + 1) % result.Loop.size()]))
                          .norm();
  }
  for (int i = 0; i < static_cast<int>(isFeature.size()); ++i)
  {
    if (isFeature[i] != 0)
    {
      result.Feature.push_back(i);
    }
    if (isRest[i] != 0)
    {
      result.Rest.push_back(i);
    }
  }
  result.FeatureArea = AreaOf(this->Samples, isFeature);
  progress(0.4);
  if (options.FillHole)
  {
    this->FillRest(options, result, progress.Part(0.4, 0.7, "filling the hole"));
    this->FindBase(result, progress.Part(0.7, 1.0, "finding the base"));
  }
  progress(1.0);
  return result;
}

void PointCutter::FillRest(
  const CutPointsOptions& options, CutPointsResult& result, const Progress& progress) const
{
  const Surface curve(this->Samples.Surface.Points(result.Loop, Eigen::all), Eigen::MatrixXi(0, 3));
  std::vector<int> rim(result.Loop.size());
  std::iota(rim.begin(), rim.end(), 0);
  SurfaceFiller filler(
    curve, { rim }, this->Samples.Normals(result.Loop, Eigen::all), options.Fill.Filler);
  FilledSurface filled = filler.Fill(options.Fill, progress);
  result.Fill = std::move(filled.Surface);
  result.Holes = std::move(filled.Holes);
  const auto size = static_cast<Eigen::Index>(result.Loop.size());
  result.FillNormals = ComputeVertexNormals(result.Fill, NormalWeight::Max)
                         .bottomRows(result.Fill.Points.rows() - size);
}

/// The base is embedded in the parameterization of the fill region (section 4.2), here of the rest
/// with the fill's points: on it, the feature is pasted in place.
void PointCutter::FindBase(CutPointsResult& result, const Progress& progress) const
{
  const Eigen::Index added = result.FillNormals.rows();
  const auto kept = static_cast<Eigen::Index>(result.Rest.size());
  Eigen::MatrixXd points(kept + added, 3), normals(kept + added, 3);
  points << this->Samples.Surface.Points(result.Rest, Eigen::all),
    result.Fill.Points.bottomRows(added);
  normals << this->Samples.Normals(result.Rest, Eigen::all), result.FillNormals;
  std::vector<int> triangles(result.Fill.Triangles.rows());
  std::iota(triangles.begin(), triangles.end(), 0);
  const Eigen::RowVector3d seed = FindCenterOfTriangles(Surface(result.Fill), triangles);
  PointTarget home(
    ConnectSamples(points, normals, {}, progress.Part(0.0, 0.6)), {}, progress.Part(0.6, 0.8));
  std::vector<int> on, loop;
  const std::vector<int> rowOf = InvertIndices(result.Rest, this->Samples.Surface.Points.rows());
  const std::vector<int> featureRow =
    InvertIndices(result.Feature, this->Samples.Surface.Points.rows());
  for (const int point : result.Loop)
  {
    on.push_back(rowOf[point]);
    loop.push_back(featureRow[point]);
  }
  result.Bases = { BuildFootprintOnPoints(
    home, { seed, std::move(loop), std::move(on) }, progress.Part(0.8, 1.0)) };
}

} // namespace shape
