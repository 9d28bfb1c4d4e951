#include "Hex/StructuredBlocks.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

using Eigen::MatrixXd;
using Eigen::RowVector3i;
using Eigen::VectorXd;

/// Clamped knots with equal distances, for a number of control points.
VectorXd MakeKnots(int controls, int degree)
{
  const int spans = controls - degree;
  VectorXd knots(controls + degree + 1);
  for (int i = 0; i < static_cast<int>(knots.size()); ++i)
  {
    knots(i) = static_cast<double>(std::clamp(i - degree, 0, spans)) / spans;
  }
  return knots;
}

/// The values at t of the degree + 1 basis functions that are not 0 there, and the first of them
/// (The NURBS Book, A2.1 and A2.2).
struct BasisValues
{
  BasisValues(const VectorXd& knots, int degree, double t)
    : Values(VectorXd::Zero(degree + 1))
  {
    const auto count = static_cast<int>(knots.size()) - degree - 1;
    int span = degree;
    while (span + 1 < count && knots(span + 1) <= t)
    {
      ++span;
    }
    this->First = span - degree;
    this->Values(0) = 1.0;
    for (int order = 1; order <= degree; ++order)
    {
      double saved = 0.0;
      for (int k = 0; k < order; ++k)
      {
        const double right = knots(span + k + 1), left = knots(span + 1 - order + k);
        const double share = this->Values(k) / (right - left);
        this->Values(k) = saved + (right - t) * share;
        saved = (t - left) * share;
      }
      this->Values(order) = saved;
    }
  }

  VectorXd Values;
  int First = 0;
};

int GetDegree(const VectorXd& knots)
{
  int repeated = 0;
  while (repeated < static_cast<int>(knots.size()) && knots(repeated) == knots(0))
  {
    ++repeated;
  }
  return repeated - 1;
}

/// The values of the basis functions (columns) at nodes with equal distances (rows).
MatrixXd NodeBasis(int nodes, const VectorXd& knots)
{
  const int degree = GetDegree(knots), controls = static_cast<int>(knots.size()) - degree - 1;
  MatrixXd basis = MatrixXd::Zero(nodes, controls);
  for (int i = 0; i < nodes; ++i)
  {
    const BasisValues values(knots, degree, static_cast<double>(i) / (nodes - 1));
    basis.row(i).segment(values.First, degree + 1) = values.Values;
  }
  return basis;
}

/// The knots of a spline over a number of nodes.
VectorXd ChooseKnots(int nodes, const BlockSplineOptions& options)
{
  const int controls = std::max(2, static_cast<int>(std::ceil(nodes / options.NodesPerControl)));
  return MakeKnots(controls, std::min(options.Degree, controls - 1));
}

void RequireSplineOptions(const BlockSplineOptions& options)
{
  RequireOption(options.Degree >= 1 && options.Degree <= 9, "Degree", options.Degree, "1 to 9");
  RequireOption(options.NodesPerControl >= 1.0 && std::isfinite(options.NodesPerControl),
    "NodesPerControl", options.NodesPerControl, "a finite number of at least 1");
}

/// The matrix that takes values at nodes with equal distances to control points. Its first and last
/// row select the ends.
MatrixXd FitMatrix(int nodes, const VectorXd& knots)
{
  const MatrixXd basis = NodeBasis(nodes, knots);
  const auto controls = static_cast<int>(basis.cols());
  MatrixXd fit = MatrixXd::Zero(controls, nodes);
  fit(0, 0) = fit(controls - 1, nodes - 1) = 1.0;
  if (controls > 2)
  {
    // The inner control points are fitted to what the ends leave.
    MatrixXd left = MatrixXd::Identity(nodes, nodes);
    left.col(0) -= basis.col(0);
    left.col(nodes - 1) -= basis.col(controls - 1);
    fit.middleRows(1, controls - 2) =
      basis.middleCols(1, controls - 2).colPivHouseholderQr().solve(left);
  }
  return fit;
}

/// Applies a matrix to values along an axis. counts: of the values, updated.
MatrixXd ApplyAlong(int axis, const MatrixXd& matrix, const MatrixXd& values, RowVector3i& counts)
{
  RowVector3i after = counts;
  after(axis) = static_cast<int>(matrix.rows());
  MatrixXd result = MatrixXd::Zero(after.prod(), values.cols());
  const int step = axis == 0 ? 1 : counts.head(axis).prod();
  const int outer = counts.prod() / (step * counts(axis));
  for (int o = 0; o < outer; ++o)
  {
    for (int s = 0; s < step; ++s)
    {
      const auto from = Eigen::seqN(o * step * counts(axis) + s, counts(axis), step);
      const auto to = Eigen::seqN(o * step * after(axis) + s, after(axis), step);
      result(to, Eigen::all) = matrix * MatrixXd(values(from, Eigen::all));
    }
  }
  counts = after;
  return result;
}

} // namespace

std::vector<GridBlock> FindGridBlocks(const Eigen::MatrixXi& cells, const MatrixXd& positions,
  const Eigen::VectorXi& blockOf, const Eigen::MatrixXi& indices)
{
  const int count = blockOf.size() > 0 ? blockOf.maxCoeff() + 1 : 0;
  std::vector<GridBlock> blocks(count, { RowVector3i::Zero(), {} });
  std::vector<int> sizes(count, 0);
  for (Eigen::Index cell = 0; cell < cells.rows(); ++cell)
  {
    if (blockOf(cell) < 0 || indices.row(cell).minCoeff() < 0)
    {
      throw InvalidInput("cell " + std::to_string(cell) +
        " has a negative Block or BlockIndex; give numbers from 0");
    }
    RowVector3i& counts = blocks[blockOf(cell)].Counts;
    counts = counts.cwiseMax(indices.row(cell) + RowVector3i::Constant(2));
    ++sizes[blockOf(cell)];
  }
  for (int block = 0; block < count; ++block)
  {
    const double expected = (blocks[block].Counts.cast<double>().array() - 1.0).prod();
    if (sizes[block] == 0 || sizes[block] != expected)
    {
      throw InvalidInput("block " + std::to_string(block) + " has " + std::to_string(sizes[block]) +
        " cells, which do not fill a box; give the third output of "
        "Shape Hex Remesh as it is");
    }
    blocks[block].Nodes = Eigen::VectorXi::Constant(blocks[block].Counts.prod(), -1);
  }
  for (Eigen::Index cell = 0; cell < cells.rows(); ++cell)
  {
    GridBlock& block = blocks[blockOf(cell)];
    const MatrixXd corners = positions(cells.row(cell), Eigen::all);
    const Eigen::RowVector3d middle = corners.colwise().mean();
    for (int k = 0; k < 8; ++k)
    {
      const RowVector3i at =
        indices.row(cell) + (corners.row(k).array() > middle.array()).cast<int>().matrix();
      block.Nodes(at(0) + block.Counts(0) * (at(1) + block.Counts(1) * at(2))) = cells(cell, k);
    }
  }
  for (int block = 0; block < count; ++block)
  {
    if (blocks[block].Nodes.minCoeff() < 0)
    {
      throw InvalidInput("two cells of block " + std::to_string(block) +
        " have the same BlockIndex; give the third output of Shape Hex Remesh as it is");
    }
  }
  return blocks;
}

BlockSpline FitBlockSpline(
  const RowVector3i& counts, const MatrixXd& values, const BlockSplineOptions& options)
{
  RequireSplineOptions(options);
  BlockSpline spline;
  RowVector3i now = counts;
  spline.Controls = values;
  for (int axis = 0; axis < 3; ++axis)
  {
    spline.Knots[axis] = ChooseKnots(counts(axis), options);
    spline.Controls =
      ApplyAlong(axis, FitMatrix(counts(axis), spline.Knots[axis]), spline.Controls, now);
  }
  spline.Counts = now;
  return spline;
}

MatrixXd ComputeNodeBasis(int nodes, const BlockSplineOptions& options)
{
  RequireSplineOptions(options);
  return NodeBasis(nodes, ChooseKnots(nodes, options));
}

MatrixXd Evaluate(const BlockSpline& spline, const MatrixXd& parameters, const Progress& progress)
{
  const RowVector3i& counts = spline.Counts;
  const auto evaluate = [&](const Eigen::RowVector3d& at) -> Eigen::RowVectorXd
  {
    const auto along = [&](int axis)
    {
      return BasisValues(
        spline.Knots[axis], GetDegree(spline.Knots[axis]), std::clamp(at(axis), 0.0, 1.0));
    };
    const std::array<BasisValues, 3> basis = { along(0), along(1), along(2) };
    Eigen::RowVectorXd value = Eigen::RowVectorXd::Zero(spline.Controls.cols());
    for (int k = 0; k < static_cast<int>(basis[2].Values.size()); ++k)
    {
      for (int j = 0; j < static_cast<int>(basis[1].Values.size()); ++j)
      {
        const int first =
          basis[0].First + counts(0) * (basis[1].First + j + counts(1) * (basis[2].First + k));
        value += basis[1].Values(j) * basis[2].Values(k) * basis[0].Values.transpose() *
          spline.Controls.middleRows(first, basis[0].Values.size());
      }
    }
    return value;
  };
  MatrixXd values(parameters.rows(), spline.Controls.cols());
  constexpr int grain = 256;
  ParallelFor(
    static_cast<int>(parameters.rows()), grain,
    [&](int begin, int end)
    {
      for (int row = begin; row < end; ++row)
      {
        values.row(row) = evaluate(parameters.row(row));
      }
    },
    progress);
  return values;
}

MatrixXd NodeParameters(const RowVector3i& counts)
{
  MatrixXd parameters(counts.prod(), 3);
  for (int i = 0; i < static_cast<int>(parameters.rows()); ++i)
  {
    const RowVector3i at(i % counts(0), i / counts(0) % counts(1), i / counts(0) / counts(1));
    parameters.row(i) = at.cast<double>().array() / (counts.cast<double>().array() - 1.0);
  }
  return parameters;
}

} // namespace shape
