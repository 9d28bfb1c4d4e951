#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/BaseDomain.h"
#include "Correspondence/CommonBase/SurfaceCurves.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Distortion/Distortion.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct CommonBaseOptions
{
  /// Curves of both surfaces that the map takes onto each other exactly. Points of a curve slide
  /// along it, apart from landmarks on it.
  std::vector<CurvePair> Curves;
  Distortion Measure = Distortion::SymmetricDirichlet; ///< what the map lowers, in both directions
  double Exponent = 1.0;                               ///< of an exponential measure; > 0
};

/// A path of the base domain.
struct BasePath
{
  int Left = -1, Right = -1; ///< the patches on its sides, looking along it
  bool IsCurve = false;      ///< whether it is a piece of a given curve
  /// k x 3 each: its points on A, in order, and their images on B. Points between whose place is
  /// not known within double precision are left out.
  Eigen::MatrixXd OnA, OnB;
};

struct CommonBaseMap
{
  SurfaceMaps Maps;
  int Patches = 0; ///< of the base domain
  ///@{
  /// The patch of each point. On A, patches are those that were traced; on B, they are the images
  /// of these. A point on a path has one of the patches beside it.
  Eigen::VectorXi PatchesOfA, PatchesOfB;
  ///@}
  std::vector<BasePath> Paths;
  int Genus = 0;
  ///@{
  /// The symmetric Dirichlet energy of the map of A and of that of B, each divided by the area of
  /// its surface, after both are scaled to one area; 4 for an isometry.
  double Energy = 0.0, EnergyBack = 0.0;
  ///@}
  ///@{
  /// The mean of the measure over both surfaces, before and after it was lowered. Measures other
  /// than SymmetricDirichlet are lowered from the result with that one.
  double MeasureBefore = 0.0, MeasureAfter = 0.0;
  ///@}
  /// The number of triangles of both surfaces that are not counter-clockwise on the flat surface
  /// through which the map goes, by exact predicates. The map is one to one if there is none.
  int Flipped = 0;
};

/**
 * Computes a one-to-one map between two closed surfaces of the same genus that takes each landmark
 * exactly to its partner and keeps orientation. Each curve goes onto its partner.
 *
 * 1. Both surfaces are divided into the same triangular patches (TraceBaseDomain), and each patch
 * is mapped to the same triangle of the plane. Equilateral triangles, glued along the sides of
 *    patches, are a flat surface with cones at the landmarks, which both surfaces cover once.
 * 2. The points of both surfaces move on the flat surface, across the sides of patches, so that the
 *    symmetric Dirichlet energy falls, or another measure of distortion. It is that of the maps in
 *    both directions together (Smith and Schaefer, "Bijective parameterization with free
 *    boundaries", 2015).
 * 3. A point goes to the point of the other surface at the same position.
 *
 * On the flat surface all positions are multiples of 2^-44. Rotations by 60 degrees are exact then,
 * in coordinates along two sides of a triangle, so that the exact predicates, which keep every
 * triangle counter-clockwise, are exact across patches, too.
 *
 * a, b, landmarks, curves: as for TraceBaseDomain. Throws the exceptions of TraceBaseDomain. Throws
 * SolveFailure if triangles are too small for double precision, usually on a protrusion without a
 * landmark; Aborted.
 */
CommonBaseMap MapThroughBase(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CommonBaseOptions& options = {}, const Progress& progress = {});

} // namespace shape
