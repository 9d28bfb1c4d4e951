#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/FunctionalGuide.h"
#include "Correspondence/Functional/FunctionalMapFit.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/ZoomOut.h"
#include "Mesh/Surface.h"

namespace shape
{

struct FunctionalMapOptions
{
  /// The descriptors to which the map is fitted.
  enum class DescriptorType
  {
    BuiltIn = 0, ///< the wave and heat kernel signatures, and the wave kernels from landmarks
    Given = 1,   ///< those of Guide
    Both = 2
  };
  DescriptorType Use = DescriptorType::Both;
  int Samples = 500;    ///< points of each surface used by the refinement; >= 10
  int Descriptors = 25; ///< number of wave kernel energies, and of heat kernel times; >= 1
  FunctionalMapFitOptions Fit;
  ZoomOutOptions Refinement;
  FunctionalGuide Guide; ///< descriptors, curves and an initial map that are known
};

/**
 * Computes corresponding points of two surfaces that differ mostly by bending. A functional map is
 * fitted to the wave and heat kernel signatures and to the wave kernels from landmarks
 * (FitFunctionalMaps). RefineByZoomOut refines it. Then each point is mapped to the position,
 * possibly inside a triangle, with the nearest values of all eigenfunctions (Ezuz and Ben-Chen,
 * "Deblurring and denoising of maps between shapes", 2017).
 *
 * The descriptors of options.Guide are added to these, or replace them. A curve gives the means of
 * the wave kernels from its points, as many as a landmark. If the guide has a matrix, nothing is
 * fitted: the matrix is expressed in the eigenfunctions of a and b, and refined.
 *
 * Both surfaces may have boundaries and several components. Their sizes may differ, since each is
 * scaled to area 1. Without landmarks, a symmetric surface may be mapped to its mirror image.
 * Throws InvalidInput if a surface is not a consistently oriented 2-manifold, or if the given
 * descriptors shall be used alone and there are none; SolveFailure; Aborted.
 */
SurfaceMaps ComputeFunctionalMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const FunctionalMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
