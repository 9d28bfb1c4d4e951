#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct PolycubeOptions
{
  /// More: fewer charts; less: normals closer to the axes; > 0.
  double Compactness = 3.0;
  /// The unit of the polycube's whole coordinates, in the surface's units: the size of a hexahedron
  /// inside it; 0: about 12,000 of them.
  double TargetEdgeLength = 0.0;
};

struct PolycubeResult
{
  Eigen::MatrixXd Positions; ///< n x 3: on the polycube, in the surface's units
  Eigen::VectorXi Labels;    ///< m: 0..5 = +x, -x, +y, -y, +z, -z
  double EdgeLength = 0.0;   ///< the unit: charts are at whole multiples of it
  int Charts = 0;            ///< of the triangles
  int Corners = 0;           ///< points of three charts or more
  double Distortion = 0.0;   ///< the mean elliptic energy of the solid's map; 1 is the minimum
};

/**
 * A polycube of a closed surface: a shape whose faces are across the axes at whole multiples of
 * one length, and a map of the surface onto it that inverts no triangle (Tarini, Hormann,
 * Cignoni and Montani, "PolyCube-Maps", 2004), by the polycube of a coarse solid close to it
 * (FindPolycubeMap), whose labels and positions its triangles and points take.
 *
 * Each triangle lies exactly in the plane of its chart. Where a triangle is inverted by that, it
 * and those around it are moved in their planes (MinimizeEnergy).
 *
 * Throws as FindPolycubeMap; SolveFailure where triangles stay inverted, as where they are
 * larger than the polycube's faces.
 */
PolycubeResult BuildPolycube(
  const Surface& surface, const PolycubeOptions& options = {}, const Progress& progress = {});

/// The label of a polygon that lies across an axis: the axis that its area vector is closest to. -1
/// where it has no area. corners: k x 3.
int FindPolygonLabel(const Eigen::MatrixXd& corners);

} // namespace shape
