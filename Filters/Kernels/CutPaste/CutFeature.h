#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/LoopSides.h"
#include "CutPaste/SurfaceDivision.h"
#include "Fill/FillHoles.h"
#include "Geodesics/SurfaceLoop.h"
#include "Geodesics/SurfacePath.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace shape
{

struct CutFeatureOptions
{
  LoopSide Side = LoopSide::Smaller;
  int LoopIndex = -1;      ///< of the curve that cuts, from 0 on; -1: all
  double SnapShare = 0.05; ///< see CurveImprintingOptions
  bool FillHole = true;    ///< whether the hole that the feature leaves is filled
  FillHolesOptions Fill;   ///< whose triangles become as large as the surface's beside the loop
};

/// A feature cut from a surface.
struct CutFeatureResult
{
  DividedPart Feature;
  DividedPart Rest;              ///< the rest of the surface and, if FillHole is set, the fills
  std::vector<FilledHole> Holes; ///< of Rest
  std::optional<FeatureFootprint>
    Base; ///< at the feature's longest cut loop, if its hole was filled
  Eigen::RowVector3d Seed = Eigen::RowVector3d::Zero(); ///< of the base: the centre of the fill
  int WeldedPoints = 0;                                 ///< of the surface: see WeldedSurface
  int Loops = 0;          ///< closed loops of the feature that were cut
  int LoopsLeftOut = 0;   ///< parts of curves that touch themselves, except the longest
  double CutLength = 0.0; ///< of all edges between feature and rest
};

/**
 * Cuts features from one surface, along closed curves on it or by its triangles, again and again:
 * section 4.2 of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010).
 * "To 'cut' a feature surface S, we simply segment it from the base surface based on a fixed
 * boundary loop, and fill the hole [...]. To ensure that the original mesh is recovered if we drop
 * a feature back in the same position, we embed the loop in a parameterization of the fill region,
 * and also take the initial boundary frames from this new surface": the result's Base.
 *
 * Curves may run anywhere: triangles that they cross are split (ImprintCurves). Holes that the
 * surface had remain. If a cut ends at the surface's boundary, there is no hole to fill; a point at
 * which two parts of the result only touch is duplicated. Owns what depends on the surface alone;
 * not for several threads at once.
 */
class FeatureCutter
{
public:
  /// surface: any triangles; seams are no boundary (WeldedSurface), and triangles with a point
  /// twice are ignored. Throws InvalidInput if there is no triangle of three positions, an index is
  /// out of range or a coordinate is not finite; Aborted.
  explicit FeatureCutter(const shape::Surface& surface, const Progress& progress = {});
  FeatureCutter(const FeatureCutter&) = delete;
  FeatureCutter& operator=(const FeatureCutter&) = delete;

  ///@{
  /**
   * curves: closed, each k x 3 points on the surface or near it, at least 3, the last joined to the
   * first. isSelected: m, of each triangle.
   *
   * Throws InvalidInput if an option or a point is wrong, if a curve encloses nothing or does not
   * divide the surface, or if the selection has no edge in common with the rest; as SurfaceFiller;
   * Aborted.
   */
  CutFeatureResult Cut(const std::vector<Eigen::MatrixXd>& curves,
    const CutFeatureOptions& options = {}, const Progress& progress = {});
  CutFeatureResult Cut(const std::vector<char>& isSelected, const CutFeatureOptions& options = {},
    const Progress& progress = {}) const;
  ///@}

private:
  std::vector<SurfaceLoop> LoopsThrough(
    const std::vector<Eigen::MatrixXd>& curves, int index, const Progress& progress);

  shape::Surface Surface;
  WeldedSurface Joined;
  std::unique_ptr<SurfaceLocator> Locator; ///< of Joined, like Paths: made for the first curve
  std::unique_ptr<SurfacePaths> Paths;
};

///@{
/// Cuts once.
CutFeatureResult CutFeature(const Surface& surface, const std::vector<Eigen::MatrixXd>& curves,
  const CutFeatureOptions& options = {}, const Progress& progress = {});
CutFeatureResult CutFeature(const Surface& surface, const std::vector<char>& isSelected,
  const CutFeatureOptions& options = {}, const Progress& progress = {});
///@}

} // namespace shape
