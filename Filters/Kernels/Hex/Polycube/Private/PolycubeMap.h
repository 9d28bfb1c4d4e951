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

/// How many cells a polycube has if no size is asked for.
constexpr double AutomaticCells = 12000.0;

struct PolycubeMapOptions
{
  double CellSize = 0.0; ///< the polycube's unit, in the surface's units; 0: about 12,000 cells
  int Triangles = 3000;  ///< of the coarse surface that is worked with, about
  /// Whether a polycube with a chart of which more than a tenth does not face its label's way is
  /// none. A chart may fold over itself without any negative tetrahedron, as around a thin hole;
  /// that is good enough for hexahedra, but it is not the boundary of a polycube.
  bool Facing = false;
};

/// Marks the triangles of a polycube that do not face the way of their label.
std::vector<char> FindInvertedTriangles(const Mesh& polycube, const Eigen::VectorXi& labels);

/// A solid and the polycube it is mapped to.
struct PolycubeMap
{
  WorkingSolid Solid;        ///< close to the solid of the surface; its own positions
  Eigen::MatrixXd Positions; ///< n x 3: on the polycube, in cells; charts are at whole numbers
  Eigen::VectorXi Labels;    ///< of the solid's triangles: 0..5 = +x, -x, +y, -y, +z, -z
  shape::Charts Charts;
  double CellSize = 0.0;
  double Distortion = 0.0; ///< the mean elliptic energy; 1 is the minimum
};

/**
 * A polycube of the solid inside a closed surface, and a map onto it that is positive on every
 * tetrahedron of a coarse solid close to it.
 *
 * The solid is bent until its normals come close to the axes (AlignWithAxes), labelled
 * (FindAxisLabels), and deformed with one coordinate for each chart (MinimizeConstrainedEnergy).
 * Charts that no polycube can have (FindChartFaults), and labels around tetrahedra that stay
 * negative, are made dearer and cut again; then other compactnesses are tried. At last the charts
 * go to whole numbers (RoundCharts), in smaller cells where that leaves no room.
 *
 * compactness: see PolycubeOptions. Throws as Tetrahedralize; InvalidInput where options are out of
 * range; SolveFailure where no polycube is found, with the faults of the best try; Aborted.
 */
PolycubeMap FindPolycubeMap(const Surface& surface, double compactness,
  const PolycubeMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
