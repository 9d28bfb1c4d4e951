#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct ZoomOutOptions
{
  int Last = 120; ///< eigenfunctions of each surface at the end; at most its number of eigenpairs
  int Step = 6;   ///< eigenfunctions added in each step; 0: the given map is not refined
};

/// The spectrum of a surface, and samples of its points.
struct SampledSpectrum
{
  const Eigen::MatrixXi& Triangles;
  const LaplaceEigenpairs& Spectrum;
  const std::vector<int>& Samples; ///< indices of points
};

/**
 * Returns the l x k matrix C that minimises |from - to C|^2. from (s x k) and to (s x l) hold the
 * values of eigenfunctions at s corresponding samples. A ridge of 1e-9 times the largest diagonal
 * entry of the normal equations makes the solution unique when there are fewer samples than
 * eigenfunctions.
 */
Eigen::MatrixXd FitCoefficients(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to);

/// Two functional maps. Each takes the coefficients of a function on one surface to the
/// coefficients of the function's image on the other surface.
struct FunctionalMaps
{
  Eigen::MatrixXd AToB, BToA; ///< k x k
};

/// The functional map of an isometry is orthogonal, so its transpose is the first guess of the
/// inverse.
inline FunctionalMaps WithTranspose(const Eigen::MatrixXd& map)
{
  return { map, map.transpose() };
}

/**
 * Refines a map between two surfaces by alternating between functional maps and point maps, each
 * time adding eigenfunctions. A point map takes each point to the position on the other surface
 * with the nearest eigenfunction values, after the functional map has been applied to them (Melzi,
 * Ren, Rodola, Sharma, Wonka and Ovsjanikov, "ZoomOut: spectral upsampling for efficient shape
 * correspondence", 2019, equations 1 to 3). Both directions are refined together: each functional
 * map is fitted to both point maps, so the two functional maps end up nearly inverse to each other
 * (Ren, Melzi, Ovsjanikov and Wonka, "MapTree: recovering multiple solutions in the space of maps",
 * 2020, section 5).
 *
 * map: the initial functional map from a to b (k x k), for surfaces scaled to area 1. Without
 * steps, the result is this map and its transpose. landmarks: each pair has the weight of a
 * thousandth of all samples in the fits. Throws Aborted.
 */
FunctionalMaps RefineByZoomOut(const SampledSpectrum& a, const SampledSpectrum& b,
  const FunctionalMaps& start, const Landmarks& landmarks, const ZoomOutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
