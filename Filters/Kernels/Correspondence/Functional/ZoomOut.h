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
  int Last = 120; ///< eigenfunctions of each surface at the end, at most as many as spectra have
  int Step = 6;   ///< by which they become more; >= 1
};

/// Samples of a surface and its spectrum.
struct SampledSpectrum
{
  const Eigen::MatrixXi& Triangles;
  const LaplaceEigenpairs& Spectrum;
  const std::vector<int>& Samples; ///< points
};

/**
 * The k x l matrix C that minimises |from - to C'|^2: from (s x k) and to (s x l) hold the values
 * of eigenfunctions at s samples that correspond. A ridge of 1e-9 of the normal equations' diagonal
 * decides if samples are fewer than eigenfunctions.
 */
Eigen::MatrixXd FitCoefficients(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to);

/// Two functional maps: each takes coefficients of a function on one surface, in its
/// eigenfunctions, to those of its image on the other one.
struct FunctionalMaps
{
  Eigen::MatrixXd AToB, BToA; ///< k x k
};

/**
 * Refines a map between two surfaces: from functional maps to points' maps, nearest in the images
 * of the eigenfunctions, and back with more eigenfunctions (Melzi, Ren, Rodola, Sharma, Wonka and
 * Ovsjanikov, "ZoomOut: spectral upsampling for efficient shape correspondence", 2019, equations 1
 * to 3), both ways at once: each functional map is fitted to both points' maps (Ren, Melzi,
 * Ovsjanikov and Wonka, "MapTree: recovering multiple solutions in the space of maps", 2020,
 * section 5), so that they end near each other's inverse.
 *
 * map: k x k, from a to b, of spectra of surfaces whose area is 1. landmarks: kept near each other,
 * each with the weight of a twentieth of the samples. Throws Aborted.
 */
FunctionalMaps RefineByZoomOut(const SampledSpectrum& a, const SampledSpectrum& b,
  const Eigen::MatrixXd& map, const Landmarks& landmarks, const ZoomOutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
