#pragma once

#include "Base/Progress.h"
#include "Hex/Features/RegionTargets.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/TouchingRegionVoxels.h"

#include <vector>

namespace shape
{

/// Hexahedra of regions that touch.
struct RegionFit
{
  HexFit Fit;                     ///< its patches are the pairs of labels along the boundary
  int Curves = 0, CurvesKept = 0; ///< see RegionMatch
  int Junctions = 0, JunctionsKept = 0;
  std::vector<int> CurvePoints; ///< the points of the chains of edges
  double CurveDistance = 0.0;   ///< see ComputeCurveDistance
};

/// The minimum scaled Jacobian that hexahedra of regions need.
inline constexpr double GoodScaledJacobian = 0.3;

/// Whether neither smaller cells nor points that leave the surfaces are worth it: hexahedra have
/// this scaled Jacobian or, if all curves are followed, those away from curves. Where interfaces
/// meet at small angles, so do hexahedra of any size.
bool IsGood(const RegionFit& result);

/**
 * Fits the cells of regions that touch to their surfaces. Sheets of hexahedra are added where
 * interfaces meet at curves (InsertRegionSheets), and layers inside the boundary of each region, so
 * that each hexahedron has at most one face on an interface or on the boundary. Points where four
 * or more regions meet become corners of the surfaces, chains of edges where three meet follow
 * their curves, and other points of interfaces lie on the surface between their two regions
 * (MatchRegions). Then all points are moved to maximise the minimum scaled
 * Jacobian (OptimizeHexahedra). Creases of a surface between two regions are rounded.
 *
 * Where hexahedra stay inverted or are not good (IsGood), points leave the surfaces
 * (RelaxBoundaryAroundBad, with maximumDistance).
 *
 * Throws Aborted.
 */
RegionFit FitRegions(const LabelledCells& cells, const RegionTargets& targets,
  const HexFitOptions& options, double maximumDistance, const Progress& progress = {});

} // namespace shape
