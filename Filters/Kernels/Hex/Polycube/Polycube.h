#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct PolycubeOptions
{
  /// Larger values give fewer charts. Smaller values give charts whose normals are closer to the
  /// axes. > 0.
  double Compactness = 3.0;
  /// The edge length of a unit cell of the polycube, in the surface's units. 0: a length that gives
  /// about 12,000 cells.
  double TargetEdgeLength = 0.0;
};

struct PolycubeResult
{
  Eigen::MatrixXd Positions; ///< n x 3: the points on the polycube, in the surface's units
  Eigen::VectorXi Labels;    ///< m: 0..5 = +x, -x, +y, -y, +z, -z
  double EdgeLength = 0.0;   ///< edge length of a unit cell, in the surface's units
  int Charts = 0;            ///< number of charts
  int Corners = 0;           ///< number of points that touch three or more charts
  double Distortion = 0.0;   ///< mean elliptic energy of the map of the solid; its minimum is 1
};

/**
 * Builds a polycube of a closed surface, and a map of the surface onto it that inverts no triangle
 * (Tarini, Hormann, Cignoni and Montani, "PolyCube-Maps", 2004). The faces of a polycube are
 * perpendicular to the axes, at coordinates that are integer multiples of one length. The polycube
 * is found for a coarse solid close to the surface (FindPolycubeMap). Its labels and positions are
 * then transferred to the triangles and points of the surface.
 *
 * Each triangle lies exactly in the plane of its chart. If moving it there inverts a triangle, the
 * points of this triangle and of the triangles around it are moved within their planes
 * (MinimizeEnergy).
 *
 * Throws whatever FindPolycubeMap throws. Throws SolveFailure if triangles stay inverted, for
 * example because they are larger than the polycube's faces.
 */
PolycubeResult BuildPolycube(
  const Surface& surface, const PolycubeOptions& options = {}, const Progress& progress = {});

/// Returns the label (0..5) of a polygon that is perpendicular to an axis. It is the label of the
/// axis closest to the polygon's area vector, or -1 if the area is 0. corners: k x 3.
int FindPolygonLabel(const Eigen::MatrixXd& corners);

} // namespace shape
