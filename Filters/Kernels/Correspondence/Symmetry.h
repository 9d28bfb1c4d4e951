#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

struct SymmetryOptions
{
  /// A symmetry changes distances along the surface by at most this share of the root of its area,
  /// on average, and by what the spacing of the search points causes; > 0, at most 0.1.
  double Tolerance = 0.003;
  int MaximumOrder = 64;   ///< of the group; >= 1
  int SearchPoints = 1000; ///< of the coarse surface on which symmetries are searched; >= 100
  /// Points of the surface on which maps are refined; a larger one is coarsened to it; >= 100.
  int CoarsePoints = 5000;
};

/// A symmetry: a map of the surface to itself that keeps distances.
struct Symmetry
{
  SurfacePoints Map; ///< the image of each point
  /// The mean change of distances on the coarse surface, divided by the root of the area.
  double Distortion = 0.0;
  bool Reversing = false; ///< whether it reverses orientation, as a reflection does
  int Order = 1;          ///< the number of times after which all points return
  bool Generator = false; ///< whether it is one of those of which all others are products
  /// The points that a reflection keeps: segments between two positions on the surface. Empty for
  /// other elements.
  std::vector<std::array<Eigen::RowVector3d, 2>> Fixed;
};

struct SymmetryResult
{
  std::vector<Symmetry> Elements; ///< of the group; the identity first
  Eigen::MatrixXi Composition;    ///< (i, j): the element that is i after j
  /// For each point, the element that takes the fundamental domain to the part that it is in. The
  /// domain is the part of element 0: the points nearest to one generic point of all its images.
  Eigen::VectorXi Copies;
  Eigen::VectorXi Orbits; ///< for each point, the point of the domain that stands for its orbit
  /// The largest distortion of a symmetry: Tolerance, and 3 divided by the number of triangles of
  /// the coarse surface. Products of symmetries may exceed it by half.
  double Bound = 0.0;
  /// The smallest distortion of a map that was tried and is no symmetry; infinite if there is none.
  double Rejected = 0.0;
};

/**
 * Finds the intrinsic symmetries of a surface: the isometries to itself, in any pose (Raviv,
 * Bronstein, Bronstein and Kimmel, "Symmetries of non-rigid shapes", 2007; Ovsjanikov, Sun and
 * Guibas, "Global intrinsic symmetries of shapes", 2008). They are a group; symmetries of order 2
 * that reverse orientation are reflections of the surface.
 *
 * The group is found by distances on a coarse surface of SearchPoints; a surface with fewer than
 * twice as many points is bisected first. Elements that move points by less than 0.15 of the root
 * of the area on average count as one. Each element is then fitted to 40 eigenfunctions of
 * the surface itself, or of a coarse one of CoarsePoints. The quotient by the group is a
 * fundamental domain (Ovsjanikov, Merigot, Patraucean and Guibas, "Shape matching via quotient
 * spaces", 2013).
 *
 * surface: a 2-manifold of one component, open or closed. Points without triangles stay where their
 * nearest triangle is. Throws InvalidInput if it is not as required, or an option is out of range;
 * SolveFailure if there are more symmetries than MaximumOrder, as of a sphere; Aborted.
 */
SymmetryResult FindSymmetries(
  const Surface& surface, const SymmetryOptions& options = {}, const Progress& progress = {});

/// Returns the mean of functions (n x d) over the group: each point gets the mean over its orbit.
Eigen::MatrixXd Symmetrize(const SymmetryResult& symmetries, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& values);

} // namespace shape
