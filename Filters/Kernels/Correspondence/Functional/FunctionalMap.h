#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/FunctionalMapFit.h"
#include "Correspondence/Functional/ZoomOut.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct FunctionalMapOptions
{
  int Samples = 500;    ///< points of each surface that the refinement uses; >= 10
  int Descriptors = 25; ///< energies of the wave kernel, and times of the heat kernel; >= 1
  FunctionalMapFitOptions Fit;
  ZoomOutOptions Refinement;
};

/**
 * Corresponding points of two surfaces that differ nearly by bending: a functional map fitted to
 * the wave and heat kernel signatures and to the wave kernels from landmarks (FitFunctionalMap),
 * refined by RefineByZoomOut, and the points' places nearest in the images of all eigenfunctions:
 * precise, inside triangles (Ezuz and Ben-Chen, "Deblurring and denoising of maps between shapes",
 * 2017).
 *
 * Both surfaces may have borders and several components; sizes may differ, each is taken with its
 * area as 1. Without landmarks a surface with a symmetry may be mapped to its mirror image. Throws
 * InvalidInput where an option is out of range or a surface is no consistently oriented 2-manifold,
 * SolveFailure, Aborted.
 */
SurfaceMaps ComputeFunctionalMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const FunctionalMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
