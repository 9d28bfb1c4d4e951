#include "Mesh/Provenance.h"

#include <algorithm>
#include <utility>

namespace shape
{

Eigen::VectorXi ComposeIndices(const Eigen::VectorXi& first, const Eigen::VectorXi& second)
{
  return second.unaryExpr([&](int index) { return index < 0 ? -1 : first(index); });
}

Provenance Compose(const Provenance& first, const Provenance& second)
{
  ProvenanceWriter writer(first.Weights.cols());
  writer.Reserve(second.Points.size());
  std::vector<std::pair<int, double>> entries;
  for (Eigen::Index row = 0; row < second.Weights.rows(); ++row)
  {
    entries.clear();
    for (decltype(second.Weights)::InnerIterator outer(second.Weights, row); outer; ++outer)
    {
      for (decltype(first.Weights)::InnerIterator inner(first.Weights, outer.col()); inner; ++inner)
      {
        entries.emplace_back(static_cast<int>(inner.col()), outer.value() * inner.value());
      }
    }
    writer.AddRow(entries, second.Points(row) < 0 ? -1 : first.Points(second.Points(row)));
  }
  return writer.Finish(ComposeIndices(first.Cells, second.Cells));
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
  writer.Reserve(static_cast<Eigen::Index>(points.size()));
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

void ProvenanceWriter::Reserve(Eigen::Index newPoints)
{
  this->First.reserve(newPoints + 1);
  this->Columns.reserve(newPoints);
  this->Values.reserve(newPoints);
  this->Copied.reserve(newPoints);
}

void ProvenanceWriter::AddRow(std::vector<std::pair<int, double>>& entries, int copied)
{
  if (entries.size() > 1)
  {
    std::sort(entries.begin(), entries.end());
  }
  const auto begin = static_cast<std::size_t>(this->First.back());
  for (const auto& [point, weight] : entries)
  {
    if (this->Columns.size() > begin && this->Columns.back() == point)
    {
      this->Values.back() += weight;
    }
    else if (weight != 0.0)
    {
      this->Columns.push_back(point);
      this->Values.push_back(weight);
    }
  }
  this->First.push_back(static_cast<int>(this->Columns.size()));
  this->Copied.push_back(copied);
}

void ProvenanceWriter::AddCopy(int oldPoint)
{
  this->Columns.push_back(oldPoint);
  this->Values.push_back(1.0);
  this->First.push_back(static_cast<int>(this->Columns.size()));
  this->Copied.push_back(oldPoint);
}

void ProvenanceWriter::AddCopies(Eigen::Index count)
{
  this->Reserve(static_cast<Eigen::Index>(this->Copied.size()) + count);
  for (int point = 0; point < static_cast<int>(count); ++point)
  {
    this->AddCopy(point);
  }
}

void ProvenanceWriter::AddNearest(int oldPoint)
{
  this->AddCopy(oldPoint);
  this->Copied.back() = -1;
}

void ProvenanceWriter::AddOnTriangle(
  const Eigen::RowVector3i& corners, const Eigen::RowVector3d& barycentric)
{
  this->Entries.clear();
  for (int k = 0; k < 3; ++k)
  {
    this->Entries.emplace_back(corners(k), barycentric(k));
  }
  this->AddRow(this->Entries, -1);
}

void ProvenanceWriter::AddMean(const std::vector<int>& newPoints)
{
  this->Entries.clear();
  for (const int point : newPoints)
  {
    for (int i = this->First[point]; i < this->First[point + 1]; ++i)
    {
      this->Entries.emplace_back(
        this->Columns[i], this->Values[i] / static_cast<double>(newPoints.size()));
    }
  }
  this->AddRow(this->Entries, -1);
}

void ProvenanceWriter::AddNone(Eigen::Index count)
{
  const auto end = static_cast<int>(this->Columns.size());
  this->First.insert(this->First.end(), count, end);
  this->Copied.insert(this->Copied.end(), count, -1);
}

Provenance ProvenanceWriter::Finish(const Eigen::VectorXi& cells) const
{
  const auto points = static_cast<Eigen::Index>(this->Copied.size());
  Provenance provenance{ { points, this->OldPoints },
    Eigen::Map<const Eigen::VectorXi>(this->Copied.data(), points), cells };
  provenance.Weights.resizeNonZeros(static_cast<Eigen::Index>(this->Values.size()));
  std::copy(this->First.begin(), this->First.end(), provenance.Weights.outerIndexPtr());
  std::copy(this->Columns.begin(), this->Columns.end(), provenance.Weights.innerIndexPtr());
  std::copy(this->Values.begin(), this->Values.end(), provenance.Weights.valuePtr());
  return provenance;
}

} // namespace shape
