#pragma once

#include "Base/Progress.h"
#include "Hex/HexRemesh.h"
#include "Hex/Voxels/TouchingRegionVoxels.h"
#include "Labels/LabelImage.h"

namespace shape
{

/**
 * Extracts the interfaces between the regions of a label image (ExtractLabelSurfaces with its
 * defaults). The frame has the directions of the image's axes; if these are not orthogonal, later
 * ones are made orthogonal to earlier ones.
 *
 * Throws the exceptions of ExtractLabelSurfaces.
 */
LabelledSurfaces SeparateLabels(const LabelImage& image, const Progress& progress = {});

/**
 * Fills regions that touch with hexahedra (BuildRegionHexahedra). No hexahedron is inverted, those
 * of adjacent regions share the points of their interface, and those of each region have the Euler
 * number and the number of components of its surface.
 *
 * options: Method must not be Polycube. FeatureAngle is not used.
 *
 * Throws InvalidInput under the conditions of ConformingRegions, or if an option is out of range or
 * contradicts another; SolveFailure under the conditions of BuildRegionHexahedra, or if hexahedra
 * stay inverted; Aborted.
 */
HexRemeshResult RemeshRegions(const LabelledSurfaces& regions, const HexRemeshOptions& options = {},
  const Progress& progress = {});

} // namespace shape
