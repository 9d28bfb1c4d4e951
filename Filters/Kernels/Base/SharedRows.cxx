#include "Base/SharedRows.h"

#include <algorithm>
#include <numeric>

namespace shape
{

namespace
{

/// Number of rows in a chunk.
constexpr Eigen::Index Chunk = 1024;

} // namespace

SharedRows::SharedRows(const shape::Processes& processes, const std::vector<Eigen::Index>& counts)
  : Processes(processes)
{
  for (const Eigen::Index count : counts)
  {
    const Eigen::Index chunks = (count + Chunk - 1) / Chunk;
    const auto share = processes.Own(chunks);
    Group group;
    group.Own = { std::min(Chunk * share.Begin, count), std::min(Chunk * share.End, count) };
    group.FirstRow = this->All;
    group.FirstOwnRow = this->Own;
    group.FirstChunk = this->Chunks + share.Begin;
    this->Groups.push_back(group);
    this->All += count;
    this->Own += group.Own.Size();
    this->Chunks += chunks;
  }
}

std::vector<int> SharedRows::OwnRows() const
{
  std::vector<int> rows(this->Own);
  for (const Group& group : this->Groups)
  {
    const auto first = rows.begin() + group.FirstOwnRow;
    std::iota(first, first + group.Own.Size(), static_cast<int>(group.FirstRow + group.Own.Begin));
  }
  return rows;
}

Eigen::RowVectorXd SharedRows::Sum(
  const Eigen::VectorXd& weights, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v) const
{
  // Each chunk belongs to one process; the others add zeros to its sum.
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(this->Chunks, u.cols());
  for (const Group& group : this->Groups)
  {
    for (Eigen::Index first = 0; first < group.Own.Size(); first += Chunk)
    {
      const Eigen::Index row = group.FirstOwnRow + first;
      const Eigen::Index size = std::min(Chunk, group.Own.Size() - first);
      for (Eigen::Index c = 0; c < u.cols(); ++c)
      {
        sums(group.FirstChunk + first / Chunk, c) = (weights.segment(row, size).array() *
          u.col(c).segment(row, size).array() * v.col(c).segment(row, size).array())
                                                      .sum();
      }
    }
  }
  this->Processes.Sum(sums);
  return sums.colwise().sum();
}

Eigen::VectorXd SharedRows::Gather(const Eigen::VectorXd& own) const
{
  Eigen::VectorXd all = Eigen::VectorXd::Zero(this->All);
  for (const Group& group : this->Groups)
  {
    all.segment(group.FirstRow + group.Own.Begin, group.Own.Size()) =
      own.segment(group.FirstOwnRow, group.Own.Size());
  }
  this->Processes.Sum(all);
  return all;
}

} // namespace shape
