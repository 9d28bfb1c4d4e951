#pragma once

#include "Harmonic/HarmonicMapTypes.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

#include <string>
#include <vector>

namespace shape
{

/// A closed surface inside a solid whose image is given.
struct ExactSurface
{
  shape::Surface Surface;
  Eigen::MatrixXd Targets; ///< n x 3: the images of its points
  std::string Name;        ///< what errors call it: "feature 2"
};

struct PiecewiseVolumeMapOptions
{
  /// A border's triangles are cut into 4^so many for the layer inside, which must meet the curved
  /// values of the map outside, not chords of them; >= 0. With 1 instead of 0, jumps of MultiLevel
  /// are 2 to 3 times smaller at 6 times the cost.
  int InterfaceRefinement = 1;
  /// How thick a skin is, / the boundary's longest side: so many times the greatest jump / the
  /// targets' longest side. In a thinner one the map turns more sharply, in a thicker one it stays
  /// away from the layer's own for longer. At most half of the way to the charges beyond the
  /// border, or to the next border.
  double SkinPerJump = 20.0;
};

struct PiecewiseVolumeMapResult
{
  /// Errors at one surface of the map, divided by the longest side of the boundary's targets' box.
  struct Border
  {
    double RMSEVertices = 0.0; ///< at its points
    double RMSEInside = 0.0;   ///< at a position in each of its triangles (ComputeOffCentres)
    double Maximum = 0.0;      ///< over both
    /// How far the two layers' fitted maps are from each other, without the skin, at random
    /// positions; 0 for the boundary.
    double JumpRMS = 0.0, JumpMaximum = 0.0;
  };
  PiecewiseCharges Charges;
  std::vector<HarmonicVolumeMapResult> Layers; ///< by region; without Map
  std::vector<Border> Borders;                 ///< by region: of the surface around it; 0: of
                                               ///< the boundary and the voids beside it
  double RMSEFeatures = 0.0;                   ///< as in HarmonicVolumeMapResult
  double OffsetDistance = 0.0; ///< the minimum of the layers', / the boundary's longest side
};

/**
 * The harmonic volume map that meets closed surfaces inside, too: each is a border between layers,
 * and each layer has a harmonic map of its own.
 *
 * One harmonic map cannot: by the maximum principle it moves an inner point no farther from where
 * the map of the boundary takes it than it moves the boundary. The layers are solved from the
 * outside inwards by ComputeHarmonicVolumeMap, each with charges on both sides of it. An inner
 * layer takes the values of the map around it as those at its border, and in a thin skin inside the
 * border the one map passes into the other (PiecewiseHarmonicMap), so that the whole is continuous
 * to rounding.
 *
 * Where a border's triangles meet at an angle, two maps that are smooth beyond it agree only to the
 * difference of their derivatives times the height of the facets over a smooth surface: that is the
 * least that jumps of fitted maps come to. On the phantom of 2562, 1926 and 1538 points, whose
 * skull and brain go to a polycube and a cube, Accelerated leaves RMSEInside 2.6e-4, 5.2e-4
 * and 1.1e-4 over, and jumps of 6.9e-4 and 2.5e-4 (RMS) for the skin to make up for; with 23042,
 * 12048 and 11618 points 6.3e-5, 1.4e-4 and 5.9e-5 (Testing/Benchmarks/Phantom.py).
 *
 * Regions are numbered as Tetrahedralize does: 0 inside the boundary, i + 1 inside surface i. A
 * region in several pieces that do not touch has a map for each: all but the first are numbered
 * after the last surface. Features are soft and belong to the layer that they lie in.
 *
 * Throws as ComputeHarmonicVolumeMap and SolidRegions do; InvalidInput if surfaces are not
 * closed, cross or touch, or lie outside.
 */
PiecewiseVolumeMapResult ComputePiecewiseVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const std::vector<ExactSurface>& surfaces,
  const VolumeFeatures& features = {}, const HarmonicVolumeMapOptions& options = {},
  const PiecewiseVolumeMapOptions& layered = {}, const Progress& progress = {});

} // namespace shape
