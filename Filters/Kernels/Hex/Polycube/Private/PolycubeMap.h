#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/Charts.h"
#include "Hex/Polycube/Private/WorkingSolid.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The approximate number of cells of a polycube if no size is given.
constexpr double AutomaticCells = 12000.0;

struct PolycubeMapOptions
{
  double CellSize = 0.0; ///< the polycube's unit, in the surface's units; 0: about 12,000 cells
  int Triangles = 3000;  ///< approximate number of triangles of the coarse surface
  /// Whether to reject a polycube if more than a tenth of one of its charts faces away from the
  /// chart's label. A chart may fold over itself without any negative tetrahedron, for example
  /// around a thin hole. Hexahedra tolerate that, but it is not the boundary of a polycube.
  bool Facing = false;
};

/// Marks the triangles of a polycube that face away from their label.
std::vector<char> FindInvertedTriangles(const Mesh& polycube, const Eigen::VectorXi& labels);

/// A solid and the polycube it is mapped to.
struct PolycubeMap
{
  WorkingSolid Solid;        ///< a coarse solid close to that of the surface, undeformed
  Eigen::MatrixXd Positions; ///< n x 3: on the polycube, in cells; charts have integer coordinates
  Eigen::VectorXi Labels;    ///< of the solid's triangles: 0..5 = +x, -x, +y, -y, +z, -z
  shape::Charts Charts;
  double CellSize = 0.0;
  double Distortion = 0.0; ///< the mean elliptic energy; its minimum is 1
};

/**
 * Finds a polycube of the solid inside a closed surface, and a map onto it that is positive on
 * every tetrahedron of a coarse solid close to it.
 *
 * The solid is deformed until its normals are close to the axes (AlignWithAxes), labelled
 * (FindAxisLabels), and deformed with one coordinate for each chart (MinimizeConstrainedEnergy).
 * Charts that no polycube can have (FindChartFaults), and labels around tetrahedra that stay
 * negative, get higher costs, and the labels are computed again. If that fails, other values of
 * the compactness are tried. Finally the coordinates of the charts are rounded to integers
 * (RoundCharts), with smaller cells if they leave no room.
 *
 * compactness: see PolycubeOptions. Throws what Tetrahedralize throws; InvalidInput if an option is
 * out of range; SolveFailure with the faults of the best attempt if no polycube is found; Aborted.
 */
PolycubeMap FindPolycubeMap(const Surface& surface, double compactness,
  const PolycubeMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
