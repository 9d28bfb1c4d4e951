#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/ZoomOut.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

struct FunctionalMapFitOptions
{
  int Size = 30;                   ///< eigenfunctions of each surface; >= 1
  double LaplacianWeight = 1e-2;   ///< of commutativity with the Laplacians; >= 0
  double DescriptorWeight = 1e-1;  ///< of commutativity with products with descriptors; >= 0
  double OrientationWeight = 1e-2; ///< of commutativity with turned gradients of theirs; >= 0
  int OperatorStride = 5; ///< operators are made of every n-th descriptor: neighbours are alike
};

/// A surface's spectrum and functions of its points that do not change if it is bent.
struct SurfaceDescriptors
{
  shape::Surface Surface;
  const LaplaceEigenpairs& Spectrum;
  const Eigen::MatrixXd& Descriptors; ///< n x q
};

/**
 * The functional map that takes descriptors of one surface to those of another one, in their first
 * eigenfunctions: the minimum of
 *
 *   |C A - B|^2 + w_L |C L1 - L2 C|^2 + w_D sum |C P1 - P2 C|^2 + w_O sum |C O1 - O2 C|^2
 *
 * over the descriptors' coefficients A and B (Ovsjanikov et al., "Functional maps: a flexible
 * representation of maps between shapes", 2012), the eigenvalues over their largest L, the
 * operators P of multiplication with each descriptor (Nogneng and Ovsjanikov, "Informative
 * descriptor preservation via commutativity for shape matching", 2017) and O, f to <normal,
 * grad(descriptor) x grad(f)>, by which a map differs from its mirror image (Ren, Poulenard, Wonka
 * and Ovsjanikov, "Continuous and orientation-preserving correspondences via functional maps",
 * 2018, section 4). Each descriptor is divided by its norm, each sum over operators by their number
 * and size. By conjugate gradients.
 *
 * Both surfaces' area is 1, both have q descriptors. Returns Size x Size, from coefficients on a to
 * those on b. Throws Aborted.
 */
Eigen::MatrixXd FitFunctionalMap(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options = {}, const Progress& progress = {});

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
 * refined by RefineByZoomOut, then each point's nearest position in all eigenfunctions:
 * precise, inside triangles (Ezuz and Ben-Chen, "Deblurring and denoising of maps between shapes",
 * 2017).
 *
 * Both surfaces may have boundaries and several components; sizes may differ, each is taken with
 * its area as 1. Without landmarks a surface with a symmetry may be mapped to its mirror image.
 * Throws InvalidInput if an option is out of range or a surface is no consistently oriented
 * 2-manifold, SolveFailure, Aborted.
 */
SurfaceMaps ComputeFunctionalMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const FunctionalMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
