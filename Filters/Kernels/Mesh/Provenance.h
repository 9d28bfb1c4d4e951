#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace shape
{

/// The origin of the points and cells of a new mesh that was made from an old mesh by cutting,
/// filling, splitting or joining. It determines how data are carried from the old mesh to the new
/// one.
struct Provenance
{
  /// New points x old points: the value at a new point is the weighted mean of the values at old
  /// points. Each row sums to 1, or is empty if the point has no source. If a mesh is made from
  /// two, it has two provenances, and each row sums to 1 over both.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  /// For each new point, the old point of which it is a copy; -1 if it is no copy.
  Eigen::VectorXi Points;
  /// For each new cell, the old cell that it equals, is a part of, or takes its data from; -1 if
  /// there is none.
  Eigen::VectorXi Cells;
};

/// Returns, for each index in `second`, the entry of `first` at this index, or -1 if the index is
/// -1.
Eigen::VectorXi ComposeIndices(const Eigen::VectorXi& first, const Eigen::VectorXi& second);

/// Returns the provenance of a mesh that was made in two steps. first: the provenance of the mesh
/// between the steps. second: the provenance of the final mesh from that mesh.
Provenance Compose(const Provenance& first, const Provenance& second);

/// Returns the provenance of an unchanged mesh.
Provenance TraceIdentity(Eigen::Index points, Eigen::Index cells);

/// Returns the provenance of a mesh whose points are all copies. points: for each new point, its
/// old point. oldPoints: the number of old points. cells: see Provenance::Cells.
Provenance TraceCopies(
  const std::vector<int>& points, Eigen::Index oldPoints, const Eigen::VectorXi& cells);

/// Builds a provenance. The new points are added one after the other.
class ProvenanceWriter
{
public:
  explicit ProvenanceWriter(Eigen::Index oldPoints);
  void Reserve(Eigen::Index newPoints); ///< allocates memory for this number of points

  /// Adds a copy of an old point.
  void AddCopy(int oldPoint);
  /// Adds copies of the first `count` old points, in order.
  void AddCopies(Eigen::Index count);
  /// Adds a point that takes the values of an old point but is no copy of it.
  void AddNearest(int oldPoint);
  /// Adds a point on a triangle of the old mesh. corners: the points of the triangle.
  void AddOnTriangle(const Eigen::RowVector3i& corners, const Eigen::RowVector3d& barycentric);
  /// Adds a point whose values are the mean of the values at new points that were added before.
  void AddMean(const std::vector<int>& newPoints);
  /// Adds a point. entries: old points and their weights, in any order; they are sorted. copied:
  /// see Provenance::Points.
  void AddRow(std::vector<std::pair<int, double>>& entries, int copied);
  /// Adds `count` points without a source.
  void AddNone(Eigen::Index count);

  /// Returns the provenance of all points that were added. cells: see Provenance::Cells.
  Provenance Finish(const Eigen::VectorXi& cells) const;

private:
  Eigen::Index OldPoints;
  std::vector<int> First = { 0 }; ///< the first entry of each row, then the total number of entries
  std::vector<int> Columns;       ///< ascending in each row
  std::vector<double> Values;
  std::vector<int> Copied; ///< see Provenance::Points
  std::vector<std::pair<int, double>> Entries;
};

} // namespace shape
