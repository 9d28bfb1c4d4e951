#pragma once

#include "Correspondence/CommonBase/Private/ConeSurface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shape
{

/// Returns the place of each point of one surface on another one, from the places of the other's
/// points on the first one. Cones have none. Throws SolveFailure if a point cannot be located.
std::vector<ConePlace> LocatePoints(
  const ConeSurface& surface, const ConeSurface& other, const std::vector<ConePlace>& places);

/// Returns the images of a surface's first points on the other surface as given. from, to: both
/// surfaces in space.
SurfacePoints GetImages(Eigen::Index points, const PatchedSurface& from, const ConeSurface& surface,
  const std::vector<ConePlace>& places, const PatchedSurface& to, const ConeSurface& other);

/// The triangles into which each given triangle of a surface was divided.
class SurfacePieces
{
public:
  explicit SurfacePieces(const PatchedSurface& surface);

  /// Returns the triangle that contains a position on the given surface.
  int Find(const SurfacePoint& position) const;
  /// Returns the position of a point on the given surface.
  SurfacePoint PlaceOf(int point) const;

private:
  const PatchedSurface& Divided;
  std::vector<std::vector<int>> Pieces; ///< for each given triangle
  std::vector<int> CornerOf;            ///< for each point, a half-edge that leaves it
};

/// Maps any position of a surface, as given, to the other surface in space.
class PositionMap
{
public:
  /// places: of the surface's points on the other one. to: the other surface in space.
  PositionMap(const ConeSurface& surface, const std::vector<ConePlace>& places,
    const ConeSurface& other, const PatchedSurface& to);

  /// Returns nothing if the image is not known within double precision, or if all corners of the
  /// triangle are cones.
  std::optional<Eigen::RowVector3d> ImageOf(const SurfacePoint& position) const;

private:
  const ConeSurface& From;
  const std::vector<ConePlace>& Places;
  const ConeSurface& Other;
  const PatchedSurface& To;
  std::vector<std::vector<int>> Pieces; ///< for each given triangle, those on the flat surface
};

} // namespace shape
