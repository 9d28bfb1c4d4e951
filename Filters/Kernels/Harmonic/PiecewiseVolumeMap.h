#pragma once

#include "Harmonic/HarmonicMapTypes.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

#include <string>
#include <vector>

namespace shape
{

/// A closed surface inside a solid, with its image.
struct ExactSurface
{
  shape::Surface Surface;
  Eigen::MatrixXd Targets; ///< n x 3: the images of its points
  std::string Name;        ///< name in error messages, such as "feature 2"
};

struct PiecewiseVolumeMapOptions
{
  /// Number of times that the triangles of a border are divided into four before the layer inside
  /// is solved; >= 0. The values of the outer map are not linear inside a triangle, and the inner
  /// map has to match them. With 1 instead of 0, the jumps of MultiLevel are 2 to 3 times smaller
  /// at 6 times the cost.
  int InterfaceRefinement = 1;
  /// Ratio (>= 0) of the thickness of a skin to the maximum jump at its border. The thickness is
  /// relative to the longest side of the boundary, the jump to the longest side of the targets. In
  /// a thinner skin the map bends more sharply; a thicker skin departs from the layer's harmonic
  /// map over a longer distance. The thickness is limited to half the distance to the charges
  /// beyond the border, and to half the distance to the next border.
  double SkinPerJump = 20.0;
};

struct PiecewiseVolumeMapResult
{
  /// Errors at one surface, divided by the longest side of the bounding box of the boundary's
  /// targets.
  struct Border
  {
    double RMSEVertices = 0.0; ///< at its points
    double RMSEInside = 0.0;   ///< at one position in each of its triangles (ComputeOffCentres)
    double Maximum = 0.0;      ///< maximum error at both
    /// Distance between the fitted maps of the two layers at random positions of the border, before
    /// blending in the skin; 0 for the boundary.
    double JumpRMS = 0.0, JumpMaximum = 0.0;
  };
  PiecewiseCharges Charges;
  std::vector<HarmonicVolumeMapResult> Layers; ///< one for each region; Map is left empty
  /// for each region, the errors at the surface around it; for region 0, at the boundary and the
  /// walls of voids in region 0
  std::vector<Border> Borders;
  double RMSEFeatures = 0.0;   ///< see HarmonicVolumeMapResult
  double OffsetDistance = 0.0; ///< minimum over layers, relative to the boundary's longest side
};

/**
 * Computes a volume map that is exact on closed surfaces inside the solid, too. These surfaces are
 * borders between layers, and each layer has its own harmonic map.
 *
 * A single harmonic map cannot do this. By the maximum principle, a harmonic map that moves an
 * inner point by some distance moves a boundary point at least as far. The layers are solved from
 * the outside inwards by ComputeHarmonicVolumeMap, with charges on both sides of each layer. On its
 * outer border, an inner layer takes its boundary values from the map of the surrounding layer. In
 * a thin skin inside the border one map blends into the other (PiecewiseHarmonicMap), so the result
 * is continuous to rounding.
 *
 * At the edges of a border two smooth maps cannot agree exactly. Their difference there is the
 * difference of their derivatives times the height of the facets over a smooth surface. The jumps
 * of fitted maps cannot be smaller. In the benchmark, the phantom has surfaces of 2562, 1926 and
 * 1538 points; its skull is mapped to a polycube and its brain to a cube. Accelerated reaches
 * RMSEInside 2.6e-4, 5.2e-4 and 1.1e-4, with jumps of 6.9e-4 and 2.5e-4 (RMS) that the skins blend.
 * With 23042, 12048 and 11618 points RMSEInside is 6.3e-5, 1.4e-4 and 5.9e-5
 * (Testing/Benchmarks/Phantom.py).
 *
 * Regions are numbered as in Tetrahedralize: 0 inside the boundary, i + 1 inside surface i. A
 * region of several pieces that do not touch has one map for each piece. Its first piece has the
 * region's number; the others are numbered after the last surface. Features are soft and belong to
 * the layer that contains them.
 *
 * Throws the exceptions of ComputeHarmonicVolumeMap and SolidRegions. Throws InvalidInput if a
 * surface is not closed, crosses or touches another, or lies outside the boundary.
 */
PiecewiseVolumeMapResult ComputePiecewiseVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const std::vector<ExactSurface>& surfaces,
  const VolumeFeatures& features = {}, const HarmonicVolumeMapOptions& options = {},
  const PiecewiseVolumeMapOptions& layered = {}, const Progress& progress = {});

} // namespace shape
