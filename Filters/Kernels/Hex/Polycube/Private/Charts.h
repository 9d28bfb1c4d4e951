#pragma once

#include "Hex/Polycube/Private/ConstrainedEnergy.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace shape
{

/// The charts of a labelled surface: the maximal sets of triangles that have the same label and are
/// connected by edges.
struct Charts
{
  Eigen::VectorXi Of;                       ///< m: the chart of each triangle
  std::vector<int> Labels;                  ///< the label of each chart
  Eigen::VectorXd Areas;                    ///< the area of each chart
  std::vector<std::vector<int>> Neighbours; ///< for each chart: the adjacent charts, ascending
  std::vector<std::vector<int>> AtPoint;    ///< for each point: the charts around it, ascending

  /// Consecutive edges between two charts, either from corner to corner or in a closed loop.
  /// `First` is the chart on the left. A corner is a point of three or more charts.
  struct Border
  {
    int First, Second;
    std::vector<int> Points; ///< a closed border repeats its first point at the end
  };
  std::vector<Border> Borders;

  int Count() const { return static_cast<int>(this->Labels.size()); }
};

/// Finds the charts of a closed surface. labels: for each triangle, 0..5 = +x, -x, +y, -y, +z, -z.
Charts FindCharts(const Mesh& surface, const Eigen::VectorXi& labels);

/// A reason why charts cannot be the faces of a polycube.
struct ChartFault
{
  enum class Kind
  {
    FewNeighbours, ///< a chart has fewer than four neighbours
    Opposite,      ///< two charts of opposite labels share an edge
    Corner,        ///< a point has more than three charts, or three charts on fewer than three axes
    Turn           ///< a border reverses its direction along the axis that neither chart has
  };
  Kind What;
  int Chart;      ///< the chart concerned
  int Other = -1; ///< the second chart, if the fault concerns a border
  int Point = -1; ///< the point concerned, for a corner and a turn
};

/**
 * Tests the conditions of Eppstein and Mumford ("Steinitz theorems for orthogonal polyhedra", 2010)
 * in the form used by Livesu, Vining, Sheffer, Gregson and Scateni ("PolyCut", 2013). If no fault
 * is returned, the charts are likely to be the faces of a polycube.
 *
 * positions (n x 3): the positions of the points, by which reversals of borders are measured. A
 * reversal of at most `slack` is not a fault.
 */
std::vector<ChartFault> FindChartFaults(
  const Charts& charts, const Eigen::MatrixXd& positions, double slack);

/// Describes the first few faults, for example "chart 3 (+x, 0.2 % of the area) has 2 neighbours; 4
/// are needed".
std::string DescribeFaults(const std::vector<ChartFault>& faults, const Charts& charts);

/// Describes a chart, for example "chart 3 (+x, 5.8 % of the area)".
std::string DescribeChart(const Charts& charts, int chart);

/// Returns the unknown of each coordinate of the points. All points of a chart share one unknown
/// along the chart's axis. Every other coordinate has its own unknown. Charts of the same axis that
/// share a point share their unknown.
ConstrainedCoordinates ConstrainCharts(const Charts& charts, Eigen::Index points);

/// Finds edges inside a chart whose ends share an unknown along an axis other than the chart's. A
/// triangle whose three points share such an unknown would be degenerate.
std::vector<std::pair<int, int>> FindConstrainedEdges(
  const Eigen::MatrixXi& triangles, const Charts& charts, const ConstrainedCoordinates& tied);

} // namespace shape
