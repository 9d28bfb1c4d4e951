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
  /// Samples used in a step, the first ones, for each of its eigenfunctions: few samples for coarse
  /// maps, more for finer ones. 0: all samples in every step; otherwise >= 1.
  double SamplesPerFunction = 0.0;
};

/// The spectrum of a surface, and samples of its points.
struct SampledSpectrum
{
  const Eigen::MatrixXi& Triangles;
  const LaplaceEigenpairs& Spectrum;
  const std::vector<int>& Samples; ///< indices of points, coarse ones first
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
  Eigen::MatrixXd AToB, BToA; ///< k_B x k_A, k_A x k_B
};

/// The functional map of an isometry is orthogonal, so its transpose is the first guess of the
/// inverse.
inline FunctionalMaps WithTranspose(const Eigen::MatrixXd& map)
{
  return { map, map.transpose() };
}

/**
 * Refines a map between two surfaces by alternating between functional maps and point maps, each
 * time adding eigenfunctions. A point map takes each sample to the vertex of the other surface
 * with the nearest eigenfunction values, after the functional map has been applied to them (Melzi,
 * Ren, Rodola, Sharma, Wonka and Ovsjanikov, "ZoomOut: spectral upsampling for efficient shape
 * correspondence", 2019, equations 1 to 3). Both directions are refined together: each functional
 * map is fitted to both point maps, so the two functional maps end up nearly inverse to each other
 * (Ren, Melzi, Ovsjanikov and Wonka, "MapTree: recovering multiple solutions in the space of maps",
 * 2020, section 5).
 *
 * start: the initial functional maps, for surfaces scaled to area 1. They may have different
 * numbers of rows and columns; the first step begins with the larger one. Without steps, the result
 * is start. landmarks: each pair has the weight of a thousandth of all samples in the fits. Throws
 * Aborted.
 */
FunctionalMaps RefineByZoomOut(const SampledSpectrum& a, const SampledSpectrum& b,
  const FunctionalMaps& start, const Landmarks& landmarks, const ZoomOutOptions& options = {},
  const Progress& progress = {});

/// Returns the point maps of functional maps: each point goes to the position with the nearest row
/// of eigenfunctions, also inside triangles (Ezuz and Ben-Chen, "Deblurring and denoising of maps
/// between shapes", 2017). Throws Aborted.
SurfaceMaps FindPointMaps(const SampledSpectrum& a, const SampledSpectrum& b,
  const FunctionalMaps& maps, const Progress& progress = {});

} // namespace shape
