#include "Mesh/Provenance.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace shape
{

Eigen::VectorXi ComposeIndices(const Eigen::VectorXi& first, const Eigen::VectorXi& second)
{
  return second.unaryExpr([&](int index) { return index < 0 ? -1 : first(index); });
}

Provenance Compose(const Provenance& first, const Provenance& second)
{
  return { second.Weights * first.Weights, ComposeIndices(first.Points, second.Points),
    ComposeIndices(first.Cells, second.Cells) };
}

Provenance TraceIdentity(Eigen::Index points, Eigen::Index cells)
{
  ProvenanceWriter writer(points);
  writer.AddCopies(points);
  return writer.Finish(Eigen::VectorXi::LinSpaced(cells, 0, static_cast<int>(cells) - 1));
}

Provenance TraceCopies(
  const std::vector<int>& points, Eigen::Index oldPoints, const Eigen::VectorXi& cells)
{
  ProvenanceWriter writer(oldPoints);
  for (const int point : points)
  {
    writer.AddCopy(point);
  }
  return writer.Finish(cells);
}

ProvenanceWriter::ProvenanceWriter(Eigen::Index oldPoints)
  : OldPoints(oldPoints)
{
}

void ProvenanceWriter::EndRow(int copied)
{
  this->First.push_back(static_cast<int>(this->Columns.size()));
  this->Copied.push_back(copied);
}

void ProvenanceWriter::AddCopy(int oldPoint)
{
  this->Columns.push_back(oldPoint);
  this->Values.push_back(1.0);
  this->EndRow(oldPoint);
}

void ProvenanceWriter::AddCopies(Eigen::Index count)
{
  for (int point = 0; point < static_cast<int>(count); ++point)
  {
    this->AddCopy(point);
  }
}

void ProvenanceWriter::AddNearest(int oldPoint)
{
  this->Columns.push_back(oldPoint);
  this->Values.push_back(1.0);
  this->EndRow(-1);
}

void ProvenanceWriter::AddOnTriangle(
  const Eigen::RowVector3i& corners, const Eigen::RowVector3d& barycentric)
{
  std::pair<int, double> entries[3];
  for (int k = 0; k < 3; ++k)
  {
    entries[k] = { corners(k), barycentric(k) };
  }
  std::sort(std::begin(entries), std::end(entries));
  for (const auto& [point, weight] : entries)
  {
    if (weight != 0.0)
    {
      this->Columns.push_back(point);
      this->Values.push_back(weight);
    }
  }
  this->EndRow(-1);
}

void ProvenanceWriter::AddMean(const std::vector<int>& newPoints)
{
  std::vector<std::pair<int, double>> entries;
  for (const int point : newPoints)
  {
    for (int i = this->First[point]; i < this->First[point + 1]; ++i)
    {
      entries.emplace_back(
        this->Columns[i], this->Values[i] / static_cast<double>(newPoints.size()));
    }
  }
  std::sort(entries.begin(), entries.end());
  const auto begin = static_cast<std::size_t>(this->First.back());
  for (const auto& [point, weight] : entries)
  {
    if (this->Columns.size() > begin && this->Columns.back() == point)
    {
      this->Values.back() += weight;
    }
    else
    {
      this->Columns.push_back(point);
      this->Values.push_back(weight);
    }
  }
  this->EndRow(-1);
}

void ProvenanceWriter::AddNone(Eigen::Index count)
{
  for (Eigen::Index i = 0; i < count; ++i)
  {
    this->EndRow(-1);
  }
}

Provenance ProvenanceWriter::Finish(const Eigen::VectorXi& cells) const
{
  const auto points = static_cast<Eigen::Index>(this->Copied.size());
  return { Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>>(points, this->OldPoints,
             static_cast<Eigen::Index>(this->Values.size()), this->First.data(),
             this->Columns.data(), this->Values.data()),
    Eigen::Map<const Eigen::VectorXi>(this->Copied.data(), points), cells };
}

} // namespace shape
