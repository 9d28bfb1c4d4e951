#include "Harmonic/Private/FreeBoundary.h"

#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/ImageSliding.h"
#include "Harmonic/Private/SolidSamples.h"
#include "Quality/MapQuality.h"
#include "Search/ClosestPoint.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Number of tetrahedra that would fill the solid, if all had the maximum volume. There are about
/// twice as many, or more if the boundary is fine.
constexpr double Parts = 12000.0;

/// Number of positions at which maps are judged.
constexpr int JudgingSamples = 20000;

/// How good a map is.
struct Judgement
{
  double Distortion = 0.0; ///< mean symmetric Dirichlet energy where the map does not fold
  double Folded = 0.0;     ///< share of the positions where it folds

  bool IsBetterThan(const Judgement& other) const
  {
    return this->Distortion < other.Distortion && this->Folded <= other.Folded;
  }
};

/// Judges maps by the derivative of their formula at positions that are not points of the
/// tetrahedra.
class MapJudge
{
public:
  /// solid: fills the boundary. size: images are divided by this.
  MapJudge(const TetrahedralizeResult& solid, double size)
    : Size(size)
    , Positions(SampleTetrahedra(solid.Points, solid.Tetrahedra, JudgingSamples))
  {
  }

  Judgement Judge(const ChargeSet& map, const Progress& progress) const
  {
    const Eigen::MatrixXd rows = EvaluateJacobians(map, this->Positions, progress) / this->Size;
    double sum = 0.0;
    int folded = 0;
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      Eigen::Matrix3d jacobian;
      jacobian << rows.row(i).segment<3>(0), rows.row(i).segment<3>(3), rows.row(i).segment<3>(6);
      if (jacobian.determinant() > 0.0)
      {
        sum += jacobian.squaredNorm() + jacobian.inverse().squaredNorm();
      }
      else
      {
        ++folded;
      }
    }
    const double count = static_cast<double>(rows.rows());
    const double mean = folded < count ? sum / (count - folded) : LargestMeasure;
    return { std::min(mean, LargestMeasure), folded / count };
  }

private:
  double Size;
  Eigen::MatrixXd Positions;
};

} // namespace

FreeBoundaryResult SlideBoundary(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const HarmonicVolumeMapResult& map, const Progress& progress)
{
  // Outline:
  // 1. The solid is filled with tetrahedra.
  // 2. The images slide on the target, to lower the energy of the harmonic map of the tetrahedra.
  // 3. The harmonic map with the new boundary values is solved.
  // 4. It is kept if it is judged better. If not, steps 3 and 4 are repeated with smaller motions.
  TetrahedralizeOptions fill;
  fill.MaximumVolume = std::abs(ComputeEnclosedVolume(boundary)) / Parts;
  const TetrahedralizeResult tetrahedra =
    Tetrahedralize(boundary, {}, fill, progress.Part(0.0, 0.1, "tetrahedralizing the solid"));
  // Images divided by this have the volume of the solid: an isometry up to scale has distortion 6.
  const double size = std::cbrt(std::abs(
    ComputeEnclosedVolume({ targets, boundary.Triangles() }) / ComputeEnclosedVolume(boundary)));
  const MapJudge judge(tetrahedra, size);
  const Judgement before = judge.Judge(map.Map, progress.Part(0.1, 0.15));
  FreeBoundaryResult result{ targets, map, before.Distortion, before.Distortion, before.Folded,
    before.Folded, 0.0 };

  // Step 2.
  FilledSolid solid{ size * tetrahedra.Points, tetrahedra.Tetrahedra, {} };
  std::vector<int> origins; // of the boundary points of the solid
  for (int i = 0; i < tetrahedra.Provenance.Points.size(); ++i)
  {
    if (tetrahedra.Provenance.Points(i) >= 0)
    {
      solid.Boundary.push_back(i);
      origins.push_back(static_cast<int>(tetrahedra.Provenance.Points(i)));
    }
  }
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(targets.rows(), 3);
  motion(origins, Eigen::all) = SlideImages(solid, targets(origins, Eigen::all), target,
                                  progress.Part(0.15, 0.6, "freeing the boundary")) -
    targets(origins, Eigen::all);
  const SurfaceLocator locator(target);
  constexpr int tries = 4;
  for (int i = 0; i < tries && result.Share == 0.0; ++i)
  {
    const Progress part = progress.Part(0.6 + 0.1 * i, 0.7 + 0.1 * i);
    // Step 3.
    const double share = 1.0 - static_cast<double>(i) / tries;
    Eigen::MatrixXd freed = targets;
    freed(origins, Eigen::all) =
      locator.Find((targets + share * motion)(origins, Eigen::all)).Positions;
    HarmonicVolumeMapResult again =
      ComputeHarmonicVolumeMap(boundary, freed, features, options, part.Part(0.0, 0.8));
    // Step 4.
    if (const Judgement after = judge.Judge(again.Map, part.Part(0.8, 1.0));
        after.IsBetterThan(before))
    {
      result = { std::move(freed), std::move(again), before.Distortion, after.Distortion,
        before.Folded, after.Folded, share };
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
