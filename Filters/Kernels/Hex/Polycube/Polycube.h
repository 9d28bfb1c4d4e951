#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct PolycubeOptions
{
  /// Greater values give fewer charts, smaller ones normals closer to the axes; > 0.
  double Compactness = 3.0;
  /// The unit of the polycube's integer coordinates, in the surface's units: the edge length of a
  /// hexahedron in it. 0: a length that gives about 12,000 hexahedra.
  double TargetEdgeLength = 0.0;
};

struct PolycubeResult
{
  Eigen::MatrixXd Positions; ///< n x 3: the points on the polycube, in the surface's units
  Eigen::VectorXi Labels;    ///< m: 0..5 = +x, -x, +y, -y, +z, -z
  double EdgeLength = 0.0;   ///< the unit; the coordinates of charts are its integer multiples
  int Charts = 0;            ///< the number of charts of the triangles
  int Corners = 0;           ///< the number of points that touch three or more charts
  double Distortion = 0.0;   ///< the mean elliptic energy of the solid's map; its minimum is 1
};

/**
 * Builds a polycube of a closed surface and a map of the surface onto it that inverts no triangle
 * (Tarini, Hormann, Cignoni and Montani, "PolyCube-Maps", 2004). The faces of a polycube are
 * perpendicular to the axes at integer multiples of one length. The polycube is found for a coarse
 * solid close to the surface (FindPolycubeMap), and its labels and positions are transferred to
 * the triangles and points of the surface.
 *
 * Each triangle lies exactly in the plane of its chart. If that inverts a triangle, it and those
 * around it are moved in their planes (MinimizeEnergy).
 *
 * Throws what FindPolycubeMap throws; SolveFailure if triangles stay inverted, for example because
 * they are larger than the polycube's faces.
 */
PolycubeResult BuildPolycube(
  const Surface& surface, const PolycubeOptions& options = {}, const Progress& progress = {});

/// Returns the label of a polygon perpendicular to an axis: the axis that its area vector is
/// closest to, or -1 if its area is 0. corners: k x 3.
int FindPolygonLabel(const Eigen::MatrixXd& corners);

} // namespace shape
