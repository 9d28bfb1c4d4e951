#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/FunctionalGuide.h"
#include "Correspondence/Functional/ZoomOut.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

struct FunctionalMapFitOptions
{
  int Size = 30;                  ///< eigenfunctions of each surface; >= 1
  double LaplacianWeight = 1e-2;  ///< w_L: commutativity with the Laplacians; >= 0
  double DescriptorWeight = 1e-1; ///< w_D: commutativity with multiplication by descriptors; >= 0
  /// w_O: commutativity with the descriptors' rotated gradients; >= 0.
  double OrientationWeight = 1e-2;
  /// A number n >= 1: only every n-th computed descriptor gives operators, since consecutive ones
  /// are similar. Each given descriptor does.
  int OperatorStride = 5;
};

/// A surface, its spectrum, and functions of its points that are invariant under bending.
struct SurfaceDescriptors
{
  shape::Surface Surface;
  const LaplaceEigenpairs& Spectrum;
  const Eigen::MatrixXd& Descriptors; ///< n x q
  /// How many of the descriptors, the last ones, are given and not computed.
  Eigen::Index Given = 0;
};

/**
 * Computes the functional map that takes the descriptors of one surface to those of another one.
 * Its matrix C, in the bases of the first eigenfunctions of both surfaces, minimises
 *
 *   |C A - B|^2 + w_L |C L1 - L2 C|^2 + w_D sum |C P1 - P2 C|^2 + w_O sum |C O1 - O2 C|^2
 *
 * by conjugate gradients. Here
 *
 * - A and B are the descriptors' coefficients (Ovsjanikov et al., "Functional maps: a flexible
 *   representation of maps between shapes", 2012);
 * - L1 and L2 are diagonal matrices of the eigenvalues, divided by the largest eigenvalue of the
 *   two surfaces;
 * - P1 and P2 multiply a function by a descriptor (Nogneng and Ovsjanikov, "Informative descriptor
 *   preservation via commutativity for shape matching", 2017);
 * - O1 and O2 take f to <normal, grad(descriptor) x grad(f)>, which distinguishes a map from its
 *   mirror image (Ren, Poulenard, Wonka and Ovsjanikov, "Continuous and orientation-preserving
 *   correspondences via functional maps", 2018, section 4).
 *
 * Each descriptor is divided by its norm. In |C A - B|^2, the given descriptors together have the
 * weight of the computed ones, since few of them say as much. Each sum over operators is divided by
 * their number and by the mean of their squared norms.
 *
 * a, b: surfaces of area 1, each with q descriptors. Returns the Size x Size matrix C, which takes
 * coefficients on a to coefficients on b. Throws Aborted.
 */
Eigen::MatrixXd FitFunctionalMap(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options = {}, const Progress& progress = {});

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
 * (FitFunctionalMap). RefineByZoomOut refines it. Then each point is mapped to the position,
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
