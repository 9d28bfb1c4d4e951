#pragma once

#include "Base/Processes.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Rows that are distributed over processes. The rows form groups, such as points and triangles.
 * Each process has a contiguous range of each group, which consists of whole chunks. Sums are
 * formed chunk by chunk, so they have the same bits for any number of processes.
 */
class SharedRows
{
public:
  /// A range [Begin, End) of the rows of a group.
  struct Range
  {
    Eigen::Index Begin = 0, End = 0;
    Eigen::Index Size() const { return this->End - this->Begin; }
  };

  SharedRows() = default;

  /// counts: the number of rows of each group.
  SharedRows(const shape::Processes& processes, const std::vector<Eigen::Index>& counts);

  /// Number of rows of all processes, and of this process.
  Eigen::Index Count() const { return this->All; }
  Eigen::Index OwnCount() const { return this->Own; }

  /// The range of a group that this process has.
  const Range& OwnRange(int group) const { return this->Groups[group].Own; }

  /// Returns the numbers of this process's rows among all rows, ascending.
  std::vector<int> OwnRows() const;

  /// Returns, for each column, the sum of weights * u * v over all rows of all processes. weights:
  /// one for each of this process's rows. u, v: the columns at these rows. Every process must call
  /// it.
  Eigen::RowVectorXd Sum(
    const Eigen::VectorXd& weights, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v) const;

  /// Returns the values at all rows, given those at this process's rows. Every process must call
  /// it.
  Eigen::VectorXd Gather(const Eigen::VectorXd& own) const;

private:
  struct Group
  {
    Range Own;
    Eigen::Index FirstRow = 0;    ///< number of the group's first row among all rows
    Eigen::Index FirstOwnRow = 0; ///< number of this process's first row among its rows
    Eigen::Index FirstChunk = 0;  ///< number of its first chunk among all chunks
  };
  shape::Processes Processes;
  std::vector<Group> Groups;
  Eigen::Index All = 0, Own = 0, Chunks = 0;
};

} // namespace shape
