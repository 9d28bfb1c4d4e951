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
  int Last = 120; ///< eigenfunctions of each surface at the end, limited by the spectra's sizes
  int Step = 6;   ///< eigenfunctions added in each step; >= 1
};

/// The spectrum of a surface, and samples of its points.
struct SampledSpectrum
{
  const Eigen::MatrixXi& Triangles;
  const LaplaceEigenpairs& Spectrum;
  const std::vector<int>& Samples; ///< indices of points
};

/**
 * Returns the k x l matrix C that minimises |from - to C'|^2. from (s x k) and to (s x l) hold the
 * values of eigenfunctions at s corresponding samples. A ridge of 1e-9 times the diagonal of the
 * normal equations makes the solution unique when there are fewer samples than eigenfunctions.
 */
Eigen::MatrixXd FitCoefficients(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to);

/// Two functional maps. Each takes the coefficients of a function on one surface to those of its
/// image on the other surface.
struct FunctionalMaps
{
  Eigen::MatrixXd AToB, BToA; ///< k x k
};

/**
 * Refines a map between two surfaces by alternating between functional maps and point maps, adding
 * eigenfunctions each time. A point map takes each point to its nearest one in the images of the
 * eigenfunctions (Melzi, Ren, Rodola, Sharma, Wonka and Ovsjanikov, "ZoomOut: spectral upsampling
 * for efficient shape correspondence", 2019, equations 1 to 3). Both directions are refined
 * together: each functional map is fitted to both point maps, so the two end nearly inverse to each
 * other (Ren, Melzi, Ovsjanikov and Wonka, "MapTree: recovering multiple solutions in the space of
 * maps", 2020, section 5).
 *
 * map: k x k, from a to b, for surfaces scaled to area 1. landmarks: kept near each other, each
 * with the weight of a thousandth of the samples. Throws Aborted.
 */
FunctionalMaps RefineByZoomOut(const SampledSpectrum& a, const SampledSpectrum& b,
  const Eigen::MatrixXd& map, const Landmarks& landmarks, const ZoomOutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
