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
  double CellSize = 0.0; ///< size of a unit cell, in the surface's units; 0: about 12,000 cells
  int Triangles = 3000;  ///< approximate number of triangles of the coarse surface
  /// Whether to reject a polycube if more than a tenth of one of its charts faces away from the
  /// axis of the chart's label. A chart may fold over itself without any negative tetrahedron, for
  /// example around a thin hole. Hexahedra tolerate such a fold, but the boundary of a polycube has
  /// none.
  bool Facing = false;
};

/// Marks the triangles of a polycube that face away from the axis of their label or have no area.
std::vector<char> FindInvertedTriangles(const Mesh& polycube, const Eigen::VectorXi& labels);

/// A solid and the polycube it is mapped to.
struct PolycubeMap
{
  WorkingSolid Solid;        ///< a coarse solid with almost the same surface, undeformed
  Eigen::MatrixXd Positions; ///< n x 3: on the polycube, in units of cells; charts lie at integers
  Eigen::VectorXi Labels;    ///< for each triangle of the solid: 0..5 = +x, -x, +y, -y, +z, -z
  shape::Charts Charts;
  double CellSize = 0.0;
  double Distortion = 0.0; ///< mean elliptic energy of the map; its minimum is 1
};

/**
 * Finds a polycube of the solid inside a closed surface. Also finds a map onto the polycube from a
 * coarse solid with almost the same surface. The map is positive on every tetrahedron of the coarse
 * solid.
 *
 * The coarse solid is deformed until its normals are close to the axes (AlignWithAxes). Its
 * triangles are labelled (FindAxisLabels). The solid is then deformed further, so that each chart
 * becomes flat (MinimizeConstrainedEnergy). If tetrahedra stay negative, the labels around them and
 * the labels of small faulty charts (FindChartFaults) get higher costs, and the labels are computed
 * again. If that fails, other values of the compactness are tried. Finally, the coordinates of the
 * charts are rounded to integers (RoundCharts). Smaller cells are used if there is no such
 * rounding.
 *
 * compactness: see PolycubeOptions. Throws whatever Tetrahedralize throws. Throws InvalidInput if
 * an option is out of range. Throws SolveFailure, which names the faults of the best attempt, if no
 * polycube is found; Aborted.
 */
PolycubeMap FindPolycubeMap(const Surface& surface, double compactness,
  const PolycubeMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
