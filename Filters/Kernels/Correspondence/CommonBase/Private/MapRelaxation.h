#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/Private/ConeSurface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Moves the points of one surface on the flat surface with cones, on which another surface is
 * fixed, so that the symmetric Dirichlet energy of the map between them falls (Smith and Schaefer,
 * "Bijective parameterization with free boundaries", 2015): the sum over the triangles of the moved
 * surface, times their areas, of the squared singular values and their inverses, for the plane
 * triangle between the images of the corners. Points of paths move like all others, cones stay.
 *
 * Each point moves along the energy's gradient, one after another, while the energy falls and
 * no triangle around it would be turned over, by exact predicates. So the map remains one to one.
 * Points that divided edges are removed where that turns no triangle over either.
 */
class MapRelaxation
{
public:
  /// from, to: the moved and the fixed surface in space. places: of each point of the moved surface
  /// that is no cone, its place on the fixed one.
  MapRelaxation(const PatchedSurface& from, ConeSurface& moved, const PatchedSurface& to,
    const ConeSurface& fixed, std::vector<ConePlace> places);

  void Run(const Progress& progress);

  /// Returns the energy divided by the surface's area, at least 4. The areas of both surfaces are
  /// scaled to be equal.
  double Energy() const;
  const std::vector<ConePlace>& Places() const { return this->Found; }

private:
  /// Derivatives of the energy by the image of a point: the gradient, and an estimate of the second
  /// derivative: for a length s that should be 1, s^2 + s^-2 has 2 + 6 s^-4.
  struct Terms
  {
    Eigen::Vector3d Slope = Eigen::Vector3d::Zero();
    double Curvature = 0.0;
  };

  /// Returns the energy of a triangle. terms: if given, those of a corner are added.
  double EnergyOf(int triangle, Terms* terms = nullptr, int corner = 0) const;
  void UpdateRest();
  Eigen::RowVector3d ImageAt(int point, const ConePlace& place) const;
  bool Relax(int point);
  void RemoveSplits();

  const PatchedSurface& From;
  ConeSurface& Moved;
  const ConeSurface& Fixed;
  std::vector<ConePlace> Found;
  Eigen::MatrixXd Images;  ///< of the moved surface's points, scaled so that the areas are equal
  Eigen::MatrixXd Targets; ///< the fixed surface's points, scaled likewise
  std::vector<Eigen::Matrix2d> Forms;    ///< first fundamental form of each triangle
  std::vector<Eigen::Matrix2d> Inverses; ///< of the forms
  std::vector<double> Areas;
};

/// Returns the place of each point of one surface on another one, from the places of the other's
/// points on the first one. Cones have none. Throws SolveFailure if a point cannot be located.
std::vector<ConePlace> LocatePoints(
  const ConeSurface& surface, const ConeSurface& other, const std::vector<ConePlace>& places);

/// Returns the images of a surface's first points on the other surface as given. from, to: both
/// surfaces in space.
SurfacePoints GetImages(Eigen::Index points, const PatchedSurface& from, const ConeSurface& surface,
  const std::vector<ConePlace>& places, const PatchedSurface& to, const ConeSurface& other);

} // namespace shape
