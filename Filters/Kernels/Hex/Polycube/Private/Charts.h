#pragma once

#include "Hex/Polycube/Private/ConstrainedEnergy.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace shape
{

/// The charts of a labelled surface: its largest parts of one label that are connected by edges.
struct Charts
{
  Eigen::VectorXi Of;                       ///< m: the chart of each triangle
  std::vector<int> Labels;                  ///< of the charts
  Eigen::VectorXd Areas;                    ///< of the charts
  std::vector<std::vector<int>> Neighbours; ///< across edges, in order, each once
  std::vector<std::vector<int>> AtPoint;    ///< n: the charts around each point, in order

  /// Edges between two charts in a row, from corner to corner (a point of three charts or more) or
  /// round; `First` is on the left.
  struct Border
  {
    int First, Second;
    std::vector<int> Points; ///< the first one again at the end where it is closed
  };
  std::vector<Border> Borders;

  int Count() const { return static_cast<int>(this->Labels.size()); }
};

/// labels: 0..5 = +x, -x, +y, -y, +z, -z of the triangles of a closed surface.
Charts FindCharts(const Mesh& surface, const Eigen::VectorXi& labels);

/// What keeps charts from being the faces of a polycube.
struct ChartFault
{
  enum class Kind
  {
    FewNeighbours, ///< a chart has fewer than four charts around it
    Opposite,      ///< two charts of opposite labels share an edge
    Corner,        ///< a point has four charts or more, or three that are not of three axes
    Turn           ///< the border of two charts runs to and fro along the third axis
  };
  Kind What;
  int Chart;      ///< one that it is about
  int Other = -1; ///< the other one, of a border
  int Point = -1; ///< where, for a corner and a turn
};

/**
 * The conditions of Eppstein and Mumford ("Steinitz theorems for orthogonal polyhedra", 2010) as
 * Livesu, Vining, Sheffer, Gregson and Scateni ("PolyCut", 2013) use them. None: the charts are
 * likely to be those of a polycube.
 *
 * positions (n x 3): where along the axes turns are looked for; going back by up to `slack` is
 * none.
 */
std::vector<ChartFault> FindChartFaults(
  const Charts& charts, const Eigen::MatrixXd& positions, double slack);

/// "chart 3 (+x, 0.2 % of the area) has 2 neighbours, 4 are needed; ..." for the first few.
std::string DescribeFaults(const std::vector<ChartFault>& faults, const Charts& charts);

/// As "chart 3 (+x, 5.8 % of the area)".
std::string DescribeChart(const Charts& charts, int chart);

/// The unknowns of points whose surface has these charts: one for each chart, along its axis, and
/// one for every other coordinate. Charts of one axis that share a point share the unknown.
ConstrainedCoordinates ConstrainCharts(const Charts& charts, Eigen::Index points);

/// Edges inside a chart between points that share an unknown of another axis: with a third such
/// point they would be a triangle that the ties make flat.
std::vector<std::pair<int, int>> FindConstrainedEdges(
  const Eigen::MatrixXi& triangles, const Charts& charts, const ConstrainedCoordinates& tied);

} // namespace shape
