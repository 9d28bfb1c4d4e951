#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/FunctionalMapFitOptions.h"
#include "Correspondence/Pair/ZoomOut.h"

#include <Eigen/Core>

#include <array>
#include <memory>

namespace shape
{

/**
 * Computes the functional map that takes the descriptors of one surface to those of another one.
 * Its matrix C, in the bases of the first eigenfunctions of both surfaces, minimises
 *
 *   E(C) = |C A - B|^2 + w_L |C L1 - L2 C|^2 + w_D sum |C P1 - P2 C|^2 + w_O sum |C O1 - O2 C|^2
 *     + w_K sum |C K1 - K2 C|^2 + w_N |C N1 - N2 C|^2
 *
 * by conjugate gradients. Here
 *
 * - A and B are the descriptors' coefficients (Ovsjanikov et al., "Functional maps: a flexible
 *   representation of maps between shapes", 2012);
 * - L1 and L2 are diagonal matrices of the eigenvalues, divided by the largest eigenvalue of the
 *   two surfaces, l. With the mask Resolvent, w_L weights |C R1 - R2 C|^2 instead, where R are the
 *   complex resolvents of the roots of L: sqrt(l) / (l + 1) and 1 / (l + 1) are their parts (Ren,
 *   Panine, Wonka and Ovsjanikov, "Structured regularization of functional map computations", 2019,
 *   section 4);
 * - P1 and P2 multiply a function by a descriptor (Nogneng and Ovsjanikov, "Informative descriptor
 *   preservation via commutativity for shape matching", 2017);
 * - O1 and O2 take f to <normal, grad(descriptor) x grad(f)>, which distinguishes a map from its
 *   mirror image (Ren, Poulenard, Wonka and Ovsjanikov, "Continuous and orientation-preserving
 *   correspondences via functional maps", 2018, section 4);
 * - K1 and K2 multiply a function by a curve: the inner product of K f and g is the mean of f g
 * over the curve's points. A matched curve gives a pair of such operators (the idea of Gehre,
 * Bronstein, Kobbelt and Solomon, "Interactive curve constrained functional maps", 2018);
 * - N1 and N2 are the changes of the Laplacians if the points are displaced by h times their unit
 * normals, or h times given vectors, with h = Displacement (Corman, Solomon, Ben-Chen, Guibas and
 * Ovsjanikov, "Functional characterization of intrinsic and extrinsic geometry", 2017), divided by
 * h; for h = 0, the limit of this quotient (Corman and Ovsjanikov, "Functional characterization of
 * deformation fields", 2018). Along the normals, they depend on the curvatures, which the
 * Laplacians do not. Along given vectors, they tell how these stretch the surface.
 *
 * Each descriptor is divided by its norm. In |C A - B|^2, the given descriptors together have the
 * weight of the computed ones, since few of them say as much. Each sum over operators is divided by
 * their number and by the mean of their squared norms.
 *
 * a, b: surfaces of area 1, each with q descriptors and equally many curves. Returns the Size x
 * Size matrix C, which takes coefficients on a to coefficients on b. w_C and w_I are not used.
 * Throws Aborted.
 */
Eigen::MatrixXd FitFunctionalMap(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options = {}, const Progress& progress = {});

/**
 * The energy of both directions together, C12 from a to b and C21 from b to a:
 *
 *   E(C12) + E(C21) + w_C / k (|C12' C12 - I|^2 + |C21' C21 - I|^2)
 *     + w_I / k (|C12 C21 - I|^2 + |C21 C12 - I|^2)
 *
 * with E of FitFunctionalMap and k = Size. The functional maps of an isometry are orthogonal
 * (Ovsjanikov et al. 2012, theorem 5.1), and two maps that are inverse to each other are one map
 * (Eynard, Rodola, Glashoff and Bronstein, "Coupled functional maps", 2016).
 */
class FunctionalMapEnergy
{
public:
  FunctionalMapEnergy(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
    const FunctionalMapFitOptions& options, const Progress& progress = {});
  ~FunctionalMapEnergy();

  double Value(const FunctionalMaps& maps) const;
  FunctionalMaps Gradient(const FunctionalMaps& maps) const;
  /// The coefficients of the polynomial Value(maps + t direction) of t, from the constant one.
  std::array<double, 5> Along(const FunctionalMaps& maps, const FunctionalMaps& direction) const;

  /// The maps that minimise E(C12) + E(C21).
  FunctionalMaps Start(const Progress& progress = {}) const;

private:
  struct Terms;
  std::unique_ptr<Terms> Both;
};

/**
 * Computes the functional maps of both directions. If w_C and w_I are 0, these are FitFunctionalMap
 * and its transpose. Otherwise, they minimise FunctionalMapEnergy, by nonlinear conjugate gradients
 * (Polak and Ribiere) with exact line search, from its Start. Throws Aborted.
 */
FunctionalMaps FitFunctionalMaps(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options = {}, const Progress& progress = {});

} // namespace shape
