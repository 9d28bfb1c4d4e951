#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The times at which a front from sources arrives at the nodes of a graph: the lengths of the
 * shortest paths along its links (Dijkstra 1959). Nodes are ranked: first the sources in the given
 * order, then the others by arrival time, and by index if times are equal.
 */
struct FrontSweep
{
  std::vector<int> Nodes;       ///< node of each rank
  std::vector<int> Ranks;       ///< rank of each node
  std::vector<double> Arrivals; ///< arrival time of each rank, ascending; 0 at sources
  /// For each rank, the rank of the previous node on the path; -1 at sources.
  std::vector<int> Parents;
  /// For each rank, the length of the link from the previous node; 0 at sources.
  std::vector<double> Steps;
  int Sources = 0;
};

/// Sweeps a front over a graph. sources: distinct nodes. Throws InvalidInput if the front does not
/// reach all nodes; call ConnectComponents first. Throws Aborted.
FrontSweep SweepFront(
  const PointGraph& graph, const std::vector<int>& sources, const Progress& progress = {});

/// Returns w of equation 4, 1 / (d^k + epsilon). distance: d, divided by the mean length of links.
/// epsilon is so small that it only keeps the weights of coincident points finite. power: k, from 0
/// to 32.
double EvaluateInverseDistanceWeight(double distance, double power);

/// Returns f of equation 7, which decreases smoothly from 1 at 0 to 0 at `radius` and beyond.
double EvaluateSmoothFalloff(double x, double radius);

/// The distance d of equation 4.
enum class FrontDistance
{
  Euclidean,
  Geodesic ///< along links within the band; the weight is 0 if there is no path
};

struct UpwindFrontOptions
{
  double Radius = 2.1; ///< r_u of equation 6, in mean links of the graph; > 0
  FrontDistance Distance = FrontDistance::Euclidean;
};

/**
 * The points upwind of each point on a sweeping front, and their weights: equations 4 and 6 to 9 of
 * Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010).
 *
 * The band upwind of rank i consists of the nodes that the front reached at most Radius earlier.
 * Since nodes are ranked by arrival time, the band is one contiguous range of ranks [Begin(i),
 * End(i)), and a row of weights is dense. The band is at least a quarter longer than the link along
 * which the front arrived, so that it contains the start of that link.
 */
class UpwindFront
{
public:
  /// graph and sweep must outlive this object. powers: for each node, the power k of equation 4 (n
  /// values, each >= 0).
  UpwindFront(const PointGraph& graph, const FrontSweep& sweep, const Eigen::VectorXd& powers,
    const UpwindFrontOptions& options = {});

  /// The band [Begin, End) of a rank that is not a source; it is never empty.
  int Begin(int rank) const { return this->Begins[rank]; }
  int End(int rank) const { return this->Ends[rank]; }

  /// The number of ranks that have no upwind node within Radius.
  int EmptyBands() const { return this->Empty; }

  /// Computes the End - Begin weights of a rank's band; the largest weight is 1. If all weights
  /// would be 0, gives weight 1 to the point from which the front arrived, and returns false.
  /// Several threads may call it.
  bool Row(int rank, float* weights) const;

private:
  void FindDistances(int rank, double* distances) const;

  const PointGraph& Graph;
  const FrontSweep& Sweep;
  double Radius; ///< in the model's units
  FrontDistance Distance;
  int Empty = 0;
  std::vector<int> Begins, Ends;
  std::vector<double> Powers, Weights; ///< one for each rank
  Eigen::MatrixXd Positions;           ///< a column for each rank
};

} // namespace shape
