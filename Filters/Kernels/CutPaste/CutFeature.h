#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/GapBridges.h"
#include "CutPaste/LoopSides.h"
#include "CutPaste/SurfaceDivision.h"
#include "Fill/FillHoles.h"
#include "Geodesics/CreasePath.h"
#include "Geodesics/SurfaceLoop.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

struct CutFeatureOptions
{
  LoopSide Side = LoopSide::Smaller;
  int LoopIndex = -1;      ///< index (from 0) of the curve to cut along; if -1, all curves
  CreaseOptions Path;      ///< how creases attract the curve between its points
  double SnapShare = 0.05; ///< see CurveImprintingOptions
  bool FillHole = true;    ///< whether the hole that the feature leaves is filled
  /// The fill's triangles grow to the size of the surface's triangles beside the loop.
  FillHolesOptions Fill;
};

/// A feature cut from a surface.
struct CutFeatureResult
{
  DividedPart Feature;
  DividedPart Rest;              ///< the rest of the surface and, if FillHole is set, the fills
  std::vector<FilledHole> Holes; ///< the filled holes of Rest
  /// The bases of the feature, at each cut loop whose hole was filled, the longest loop first. The
  /// origin of each is the centre of the fill.
  std::vector<FeatureFootprint> Bases;
  int WeldedPoints = 0; ///< number of points of the surface that were welded: see WeldedSurface
  int Loops = 0;        ///< number of closed loops along which the feature was cut
  /// Number of ignored parts of curves. A curve that touches itself has several parts, of which
  /// only the longest is used.
  int LoopsLeftOut = 0;
  double CutLength = 0.0; ///< total length of the edges between feature and rest
  CrossedGaps Gaps;       ///< the gaps that the loops cross
};

/**
 * Cuts features from one surface, any number of times, along closed curves on it or along the
 * border of selected triangles. See section 4.2 of Schmidt and Singh, "Drag-and-drop surface
 * composition" (Graphics Interface 2010). "To 'cut' a feature surface S, we simply segment it from
 * the base surface based on a fixed boundary loop, and fill the hole [...]. To ensure that the
 * original mesh is recovered if we drop a feature back in the same position, we embed the loop in a
 * parameterization of the fill region, and also take the initial boundary frames from this new
 * surface." The result's Bases store the loops and these frames.
 *
 * Curves may have any position on the surface, since triangles that they cross are split
 * (ImprintCurves). Existing holes of the surface remain. If a cut ends at the surface's boundary,
 * there is no hole to fill.
 *
 * If points of a curve are on parts of the surface that are not connected, such as panels, the
 * curve crosses gaps between them that are not wider than the mean edge (FindGapBridges). The loops
 * then have sides across gaps, which are edges of the fill, but of neither part.
 *
 * A point at which two parts of the result touch without a common edge is duplicated. A cutter
 * stores what depends on the surface alone. It must not be used by several threads at once.
 */
class FeatureCutter
{
public:
  /// surface: any triangles. Seams are not treated as boundaries (WeldedSurface), and triangles
  /// that contain a point twice are ignored. Throws InvalidInput if no triangle has three distinct
  /// positions, an index is out of range or a coordinate is not finite; Aborted.
  explicit FeatureCutter(const shape::Surface& surface, const Progress& progress = {});
  ~FeatureCutter();
  FeatureCutter(const FeatureCutter&) = delete;
  FeatureCutter& operator=(const FeatureCutter&) = delete;

  ///@{
  /**
   * Cuts one feature. curves: closed, each with at least 3 points (k x 3) on or near the surface;
   * the last point is joined to the first. isSelected: m flags, non-zero for each selected
   * triangle.
   *
   * Throws InvalidInput if a gap between consecutive points of a curve is wider than the mean edge.
   * Throws InvalidInput if an option is out of range or a point is not finite. Also throws
   * InvalidInput if a curve encloses nothing or does not divide the surface, or if the selection
   * has no edge in common with the rest. Throws the exceptions of SurfaceFiller; Aborted.
   */
  CutFeatureResult Cut(const std::vector<Eigen::MatrixXd>& curves,
    const CutFeatureOptions& options = {}, const Progress& progress = {});
  CutFeatureResult Cut(const std::vector<char>& isSelected, const CutFeatureOptions& options = {},
    const Progress& progress = {}) const;
  ///@}

private:
  /// The surface on which curves are traced: Joined, without or with bridges across gaps.
  struct Traced;
  Traced& SurfaceUnder(const std::vector<Eigen::MatrixXd>& curves, const Progress& progress);
  std::vector<Eigen::MatrixXd> Chosen(
    const std::vector<Eigen::MatrixXd>& curves, const CutFeatureOptions& options) const;

  shape::Surface Surface;
  WeldedSurface Joined;
  std::unique_ptr<Traced> Plain, Bridged; ///< created when the first curve needs them
};

/// Cuts a single feature from a surface. Throws the exceptions of FeatureCutter.
CutFeatureResult CutFeature(const Surface& surface, const std::vector<Eigen::MatrixXd>& curves,
  const CutFeatureOptions& options = {}, const Progress& progress = {});
CutFeatureResult CutFeature(const Surface& surface, const std::vector<char>& isSelected,
  const CutFeatureOptions& options = {}, const Progress& progress = {});

} // namespace shape
