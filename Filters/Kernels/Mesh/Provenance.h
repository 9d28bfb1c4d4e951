#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace shape
{

/// Where the points and cells of a mesh come from that was derived from another one: cut, filled,
/// split or joined. Data are carried from the old mesh to the new one by it.
struct Provenance
{
  /// New points x old points: a value at a new point is the weighted mean of the values at the old
  /// ones. Rows sum to 1; an empty row belongs to a point without a source. In a mesh made from
  /// two, the rows of both provenances sum to 1 together.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  /// Of each new point: the old point that it is, or is a copy of; -1 if it is none.
  Eigen::VectorXi Points;
  /// Of each new cell: the old cell that it is, is a part of, or takes its data from; -1: none.
  Eigen::VectorXi Cells;
};

/// Of each entry of `second`: the entry of `first` at that index; -1 stays -1.
Eigen::VectorXi ComposeIndices(const Eigen::VectorXi& first, const Eigen::VectorXi& second);

/// The provenance of a mesh that was derived in two steps; the points and cells of the mesh between
/// them are the new ones of `first` and the old ones of `second`.
Provenance Compose(const Provenance& first, const Provenance& second);

/// The provenance of a mesh that is the old one.
Provenance TraceIdentity(Eigen::Index points, Eigen::Index cells);

/// The provenance of a mesh whose points are all copies. points: of each, the old point, less than
/// oldPoints; cells: as Provenance::Cells.
Provenance TraceCopies(
  const std::vector<int>& points, Eigen::Index oldPoints, const Eigen::VectorXi& cells);

/// Writes a provenance, one new point after the other.
class ProvenanceWriter
{
public:
  explicit ProvenanceWriter(Eigen::Index oldPoints);
  void Reserve(Eigen::Index newPoints); ///< room for this number of points

  /// A point that is the old one.
  void AddCopy(int oldPoint);
  /// The first `count` old points, in order.
  void AddCopies(Eigen::Index count);
  /// A new point that has the values of an old one.
  void AddNearest(int oldPoint);
  /// A new point on a triangle of the old mesh. corners: its points.
  void AddOnTriangle(const Eigen::RowVector3i& corners, const Eigen::RowVector3d& barycentric);
  /// A new point that has the mean of the values at points that were written before.
  void AddMean(const std::vector<int>& newPoints);
  /// A point with these old points and their weights, in any order. copied: as Provenance::Points.
  void AddRow(std::vector<std::pair<int, double>>& entries, int copied);
  /// Points without a source.
  void AddNone(Eigen::Index count);

  /// The provenance of all points written. cells: as Provenance::Cells.
  Provenance Finish(const Eigen::VectorXi& cells) const;

private:
  Eigen::Index OldPoints;
  std::vector<int> First = { 0 }; ///< of each row: its first entry; then the number of entries
  std::vector<int> Columns;       ///< ascending in each row
  std::vector<double> Values;
  std::vector<int> Copied; ///< as Provenance::Points
  std::vector<std::pair<int, double>> Entries;
};

} // namespace shape
