#include "Fill/Private/FairPatch.h"

#include "Laplacian/Membrane.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// A patch that becomes fair. Order of calls: Start, Settle, Refine, Result.
class FairSearch
{
public:
  FairSearch(const HolePatch& membrane, const BoundaryLoop& loop, const PatchSizes& sizes)
    : Membrane(membrane)
    , Loop(loop)
    , Wanted(sizes)
    , MaximumArea(10.0 * ComputeArea(membrane.Surface))
    , IsCoarse(loop.Points.rows() > 64)
  {
  }

  /// Begins with a spherical cap or a biharmonic surface over the membrane's layout.
  void Start(const Progress& progress)
  {
    // Beyond, a spherical cap is nearer to the fair surface than a biharmonic surface is.
    constexpr double steep = 60.0 * M_PI / 180.0;
    PatchSizes sizes = this->Wanted;
    if (std::abs(ComputeMeanTilt(this->Loop)) > steep)
    {
      this->IsCoarse = true;
      sizes.Growth = std::max(sizes.Growth, BulgingGrowth);
      this->Patch = { { BuildSphericalCap(this->Membrane, this->Loop),
                        this->Membrane.Surface.Triangles },
        this->Membrane.Flat };
      this->Patch = RemeshPatch(this->Patch, sizes, this->Loop.Normals, progress.Part(0.0, 0.5));
      this->MakeFair(progress.Part(0.5, 1.0));
      return;
    }
    constexpr double flatGrowth = 0.5;
    sizes.Growth = this->IsCoarse ? std::max(sizes.Growth, flatGrowth) : sizes.Growth;
    this->Patch =
      RemeshPatch(this->Membrane, sizes, Eigen::MatrixXd(0, 3), progress.Part(0.0, 0.5));
    const Mesh flat = BuildFlatSurface(this->Patch);
    this->Patch.Surface.Points = SolveBiharmonicSurface(flat, this->Loop, progress.Part(0.5, 0.5));
    this->MakeFair(progress.Part(0.5, 1.0));
    this->Stretch = ComputeMaximumStretch(flat, this->Patch.Surface);
  }

  /// Remeshes until the triangles stay even.
  /// The fair surface is larger than its start, and stretched triangles approximate curvature
  /// badly. Each round starts nearer to the solution.
  void Settle(const Progress& progress)
  {
    constexpr double uneven = 1.5;
    constexpr int rounds = 4;
    PatchSizes sizes = this->Wanted;
    sizes.Growth = std::max(sizes.Growth, BulgingGrowth);
    for (int round = 0;
         round < rounds && !this->IsBalloon() && (this->Stretch > uneven || !this->Fair.Converged);
         ++round)
    {
      this->IsCoarse = true;
      const double begin = static_cast<double>(round) / rounds;
      this->Patch =
        RemeshPatch(this->Patch, sizes, this->Loop.Normals, progress.Part(begin, begin));
      this->MakeFair(progress.Part(begin, begin + 1.0 / rounds));
    }
  }

  /// Remeshes to the wanted size, again if triangles do not stay even.
  void Refine(const Progress& progress)
  {
    constexpr double slightlyUneven = 1.3, uneven = 1.5;
    constexpr int rounds = 2;
    bool isNeeded = this->IsCoarse || this->Stretch > slightlyUneven;
    this->IsCoarse = false;
    for (int round = 0; round < rounds && !this->IsBalloon() && isNeeded; ++round)
    {
      const double begin = static_cast<double>(round) / rounds, middle = begin + 0.1;
      this->Patch =
        RemeshPatch(this->Patch, this->Wanted, this->Loop.Normals, progress.Part(begin, middle));
      this->MakeFair(progress.Part(middle, begin + 1.0 / rounds));
      isNeeded = this->Stretch > uneven;
    }
  }

  bool IsBalloon() const { return !(ComputeArea(this->Patch.Surface) < this->MaximumArea); }
  FairPatchResult Result() const
  {
    return { this->Patch.Surface, this->Fair.Converged, this->IsBalloon() };
  }

private:
  static constexpr double BulgingGrowth = 0.25; ///< growth of edges away from the loop

  void MakeFair(const Progress& progress)
  {
    FairSurfaceOptions options;
    // In edges: a coarse patch is remeshed anyway.
    constexpr double roughly = 0.05;
    options.Tolerance = this->IsCoarse ? roughly : options.Tolerance;
    const Mesh before = this->Patch.Surface;
    this->Fair = SolveFairSurface(before, this->Loop.Normals, options, progress);
    this->Patch.Surface.Points = this->Fair.Points;
    this->Stretch = ComputeMaximumStretch(before, this->Patch.Surface);
  }

  const HolePatch& Membrane;
  const BoundaryLoop& Loop;
  const PatchSizes& Wanted;
  const double MaximumArea;
  bool IsCoarse; ///< whether the patch is coarser than the result
  HolePatch Patch;
  FairSurfaceResult Fair;
  double Stretch = 1.0; ///< by which factor triangles changed when the patch was made fair
};

/// The direction around which a loop runs counter-clockwise.
RowVector3d AxisOf(const Eigen::MatrixXd& loop)
{
  const RowVector3d centre = loop.colwise().mean();
  RowVector3d sum = RowVector3d::Zero();
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const RowVector3d from = loop.row(i) - centre, to = loop.row((i + 1) % loop.rows()) - centre;
    sum += from.cross(to);
  }
  return sum.stableNormalized();
}

} // namespace

FairPatchResult BuildFairPatch(const HolePatch& membrane, const BoundaryLoop& loop,
  const PatchSizes& sizes, const Progress& progress)
{
  FairSearch search(membrane, loop, sizes);
  search.Start(progress.Part(0.0, 0.2));
  search.Settle(progress.Part(0.2, 0.4));
  search.Refine(progress.Part(0.4, 1.0));
  return search.Result();
}

double ComputeMeanTilt(const BoundaryLoop& loop)
{
  const RowVector3d axis = AxisOf(loop.Points);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop.Points.rows(); ++i)
  {
    const Eigen::Index before = (i + loop.Points.rows() - 1) % loop.Points.rows();
    const RowVector3d along =
      loop.Points.row((i + 1) % loop.Points.rows()) - loop.Points.row(before);
    const RowVector3d outwards = along.cross(axis).stableNormalized(), normal = loop.Normals.row(i);
    // The angle in the plane across the loop.
    sum += std::atan2(normal.dot(outwards), normal.dot(axis));
  }
  return sum / static_cast<double>(loop.Points.rows());
}

Eigen::MatrixXd BuildSphericalCap(const HolePatch& patch, const BoundaryLoop& loop)
{
  constexpr double maximum = 150.0 * M_PI / 180.0, minimum = 1e-3;
  double tilt = std::clamp(ComputeMeanTilt(loop), -maximum, maximum);
  tilt = std::abs(tilt) < minimum ? minimum : tilt;
  const Eigen::Index corners = loop.Points.rows();
  const Eigen::MatrixXd circle = patch.Flat.topRows(corners);
  const double radius = circle.rowwise().norm().mean();
  // The plane's axes in space for which the circle is nearest to the loop. If the loop's points are
  // unevenly spaced, their mean is not the circle's centre.
  const RowVector3d loopMean = loop.Points.colwise().mean();
  const Eigen::RowVector2d circleMean = circle.colwise().mean();
  const Eigen::MatrixXd around = circle.rowwise() - circleMean;
  const Eigen::Matrix<double, 3, 2> moments =
    (loop.Points.rowwise() - loopMean).transpose() * around / around.squaredNorm();
  const Eigen::JacobiSVD<Eigen::MatrixXd> fit(moments, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::Matrix<double, 3, 2> axes = fit.matrixU() * fit.matrixV().transpose();
  const RowVector3d up = axes.col(0).cross(axes.col(1)).transpose();
  const double scale = fit.singularValues().sum(); // of the circle in space
  const RowVector3d centre = loopMean - scale * (axes * circleMean.transpose()).transpose();

  Mesh cap{ Eigen::MatrixXd(patch.Flat.rows(), 3), patch.Surface.Triangles };
  // A cap that leaves a circle of radius r at the angle t lies on a sphere of radius r / sin t.
  const double sphere = scale * radius / std::sin(tilt);
  for (Eigen::Index i = 0; i < cap.Points.rows(); ++i)
  {
    const double share = patch.Flat.row(i).norm() / radius;
    // Stereographic projection from the opposite pole: the distance in the plane is proportional to
    // tan(angle / 2).
    const double angle = 2.0 * std::atan(std::tan(0.5 * tilt) * share);
    const RowVector3d way = share > 0.0
      ? RowVector3d((axes * patch.Flat.row(i).transpose()).transpose() / (radius * share))
      : RowVector3d::Zero();
    cap.Points.row(i) =
      centre + sphere * (std::sin(angle) * way + (std::cos(angle) - std::cos(tilt)) * up);
  }
  return cap.Points + SolveHarmonicValues(cap, loop.Points - cap.Points.topRows(corners));
}

} // namespace shape
