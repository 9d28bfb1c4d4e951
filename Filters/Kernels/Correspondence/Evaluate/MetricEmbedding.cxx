#include "Correspondence/Evaluate/MetricEmbedding.h"

#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"
#include "Linear/SparseSolve.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// A pair of points whose distance is given.
struct GivenLength
{
  int A, B;
  double Length;
  double Weight; ///< of the squared error
};

double SumSquaredErrors(const std::vector<GivenLength>& lengths, const Eigen::MatrixXd& points)
{
  double sum = 0.0;
  for (const GivenLength& each : lengths)
  {
    const double error = (points.row(each.A) - points.row(each.B)).norm() - each.Length;
    sum += each.Weight * error * error;
  }
  return sum;
}

/// Adds a symmetric 3 x 3 block to the rows and columns of a pair of points.
void AddPairBlock(
  const GivenLength& pair, const Eigen::Matrix3d& block, std::vector<Eigen::Triplet<double>>& into)
{
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      const int a = 3 * pair.A, b = 3 * pair.B;
      into.emplace_back(a + r, a + c, block(r, c));
      into.emplace_back(b + r, b + c, block(r, c));
      into.emplace_back(a + r, b + c, -block(r, c));
      into.emplace_back(b + r, a + c, -block(r, c));
    }
  }
}

/// Levenberg and Marquardt: Gauss-Newton steps with the matrix J'J + damping * Laplacian.
void FitLengths(const std::vector<GivenLength>& lengths, int iterations, Eigen::MatrixXd& points,
  const Progress& progress)
{
  constexpr double minimumDamping = 1e-9, maximumDamping = 1e6, smallestGain = 1e-7;
  const auto unknowns = 3 * points.rows();
  double error = SumSquaredErrors(lengths, points), damping = 1e-2;
  const double count = static_cast<double>(lengths.size());
  SparseCholesky solver;
  for (int step = 0; step < iterations && error > 1e-20 * count; ++step)
  {
    const Progress part = progress.Part(
      static_cast<double>(step) / iterations, static_cast<double>(step + 1) / iterations);
    part(0.0);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * lengths.size() + unknowns);
    for (const GivenLength& each : lengths)
    {
      const Eigen::RowVector3d edge = points.row(each.A) - points.row(each.B);
      const double length = std::max(edge.norm(), std::numeric_limits<double>::min());
      const Eigen::Vector3d direction = edge.transpose() / length;
      const Eigen::Vector3d force = each.Weight * (length - each.Length) * direction;
      gradient.segment<3>(3 * each.A) += force;
      gradient.segment<3>(3 * each.B) -= force;
      AddPairBlock(each,
        each.Weight * (direction * direction.transpose() + damping * Eigen::Matrix3d::Identity()),
        entries);
    }
    // The Laplacian leaves translations free.
    const double mean = 1e-9 * count / static_cast<double>(unknowns);
    for (Eigen::Index i = 0; i < unknowns; ++i)
    {
      entries.emplace_back(i, i, mean * lengths.front().Weight);
    }
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver.Factorize(matrix, part.Part(0.0, 0.9));
    const Eigen::MatrixXd move = solver.Solve(-gradient, part.Part(0.9, 1.0));
    const Eigen::MatrixXd moved =
      points + Eigen::Map<const Eigen::MatrixXd>(move.data(), 3, points.rows()).transpose();
    const double reached = SumSquaredErrors(lengths, moved);
    if (!(reached < error))
    {
      damping *= 8.0;
      if (damping > maximumDamping)
      {
        return;
      }
      continue;
    }
    const bool done = error - reached < smallestGain * error;
    points = moved;
    error = reached;
    if (done)
    {
      return;
    }
    damping = std::max(minimumDamping, damping / 4.0);
  }
}

void RequireLengths(const Eigen::MatrixXd& sides, Eigen::Index triangles)
{
  if (sides.rows() != triangles || sides.cols() != 3)
  {
    throw InvalidInput("there are lengths for " + std::to_string(sides.rows()) +
      " triangles, but the surface has " + std::to_string(triangles));
  }
  if (!sides.allFinite() || !(sides.minCoeff() > 0.0))
  {
    throw InvalidInput("a length is not positive and finite; raise Smoothness, or compute the "
                       "operators with more eigenpairs");
  }
}

} // namespace

Surface OffsetSurface(const Surface& surface, double distance, const std::string& name)
{
  Surface offset = surface.WithPoints(surface.Points() + distance * GetVertexNormals(surface));
  int turned = 0;
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    // Beyond one radius of curvature a triangle turns over; beyond both, each edge turns round.
    const Eigen::Matrix3d here = GetCorners(surface, t), there = GetCorners(offset, t);
    bool isTurned = surface.AreaVectors().row(t).dot(offset.AreaVectors().row(t)) < 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      isTurned |= (here.row(next) - here.row(k)).dot(there.row(next) - there.row(k)) < 0.0;
    }
    turned += isTurned;
  }
  if (turned > 0)
  {
    std::ostringstream words;
    words << "OffsetDistance is " << distance << ", which turns " << turned << " triangles of "
          << name << " over; lower it below the radii of curvature";
    throw InvalidInput(words.str());
  }
  return offset;
}

// 1. Lengths of the edges; with an offset surface, also of its edges, of the lines between both
//    and of the diagonals of each edge's quadrilateral.
// 2. Least squares from the positions of `start` and its offset.
EmbeddedMetric EmbedMetric(const Surface& start, const Eigen::MatrixXd& sides,
  const Eigen::MatrixXd& offsetSides, double distance, const MetricEmbeddingOptions& options,
  const Progress& progress)
{
  RequireOption(options.Iterations >= 1, "Iterations", options.Iterations, "at least 1");
  RequireLengths(sides, start.Triangles().rows());
  const bool hasOffset = offsetSides.size() > 0;
  if (hasOffset)
  {
    RequireLengths(offsetSides, start.Triangles().rows());
  }
  const auto points = static_cast<int>(start.Points().rows());
  std::vector<GivenLength> lengths;
  const std::vector<HalfEdge>& halves = start.HalfEdges();
  double squares = 0.0;
  for (std::size_t i = 0; i < halves.size(); ++i)
  {
    squares +=
      (start.Points().row(halves[i].Begin) - start.Points().row(halves[i].End)).squaredNorm();
  }
  // The start gets the size of the result: otherwise early steps would turn parts over.
  const Surface scaled = start.WithPoints(start.Points() * (sides.norm() / std::sqrt(squares)));
  Eigen::MatrixXd positions = scaled.Points();
  if (hasOffset)
  {
    positions.conservativeResize(2 * points, Eigen::NoChange);
    positions.bottomRows(points) = scaled.Points() + distance * GetVertexNormals(scaled);
  }
  for (std::size_t i = 0; i < halves.size(); ++i)
  {
    const HalfEdge& half = halves[i];
    if (i > 0 && half.Low() == halves[i - 1].Low() && half.High() == halves[i - 1].High())
    {
      continue;
    }
    const int corner = (half.Corner + 2) % 3;
    const double length = sides(half.Triangle, corner), weight = 1.0 / (length * length);
    lengths.push_back({ half.Begin, half.End, length, weight });
    if (hasOffset)
    {
      const double beyond = offsetSides(half.Triangle, corner),
                   diagonal = std::sqrt(length * beyond + distance * distance),
                   ofDiagonal = 1.0 / (diagonal * diagonal);
      lengths.push_back(
        { points + half.Begin, points + half.End, beyond, 1.0 / (beyond * beyond) });
      lengths.push_back({ half.Begin, points + half.End, diagonal, ofDiagonal });
      lengths.push_back({ points + half.Begin, half.End, diagonal, ofDiagonal });
    }
  }
  for (int i = 0; hasOffset && i < points; ++i)
  {
    lengths.push_back({ i, points + i, std::abs(distance), 1.0 / (distance * distance) });
  }
  FitLengths(lengths, options.Iterations, positions, progress);

  EmbeddedMetric result{ positions.topRows(points), 0.0 };
  int edges = 0;
  for (const GivenLength& each : lengths)
  {
    if (each.A < points && each.B < points)
    {
      const double error =
        (positions.row(each.A) - positions.row(each.B)).norm() / each.Length - 1.0;
      result.LengthError += error * error;
      ++edges;
    }
  }
  result.LengthError = std::sqrt(result.LengthError / edges);
  progress(1.0);
  return result;
}

} // namespace shape
