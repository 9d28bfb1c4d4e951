#include "Surface/StressScaling.h"

#include "Core/Errors.h"
#include "Core/SparseSolve.h"
#include "Core/Topology.h"
#include "Surface/ClassicalScaling.h"
#include "Surface/CotangentWeights.h"
#include "Surface/FarthestPoints.h"
#include "Surface/HeatGeodesics.h"
#include "Surface/IntrinsicDelaunay.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// The distances between the rows of positions.
Eigen::MatrixXd Between(const Eigen::MatrixXd& positions)
{
  const Eigen::VectorXd squares = positions.rowwise().squaredNorm();
  return ((-2.0 * positions * positions.transpose()).colwise() + squares)
    .rowwise()
    .
    operator+(squares.transpose())
    .cwiseMax(0.0)
    .cwiseSqrt();
}

/// Positions of s samples with these distances (s x s).
Eigen::MatrixXd Majorised(
  const Eigen::MatrixXd& distances, const StressScalingOptions& options, const Progress& progress)
{
  const Eigen::MatrixXd squares = distances.array().square();
  const Eigen::RowVectorXd means = squares.colwise().mean();
  Eigen::MatrixXd positions =
    -0.5 * ((squares.rowwise() - means) * ScalingAxes(squares, options.Dimensions));
  const auto count = static_cast<double>(distances.rows());
  double before = 0.0;
  for (int k = 0; k < options.Iterations; ++k)
  {
    progress(static_cast<double>(k) / options.Iterations);
    const Eigen::MatrixXd now = Between(positions);
    const double stress = (distances - now).squaredNorm();
    if (k > 0 && before - stress <= options.Tolerance * stress)
    {
      break;
    }
    before = stress;
    // The Guttman transform; points at the same place pull in no direction.
    const Eigen::MatrixXd ratios =
      (now.array() > 0.0).select(distances.array() / now.array(), 0.0).matrix();
    const Eigen::VectorXd sums = ratios.rowwise().sum();
    positions = (sums.asDiagonal() * positions - ratios * positions).eval() / count;
  }
  return positions;
}

} // namespace

ScaledSamples ScaleSamples(
  const Mesh& mesh, const StressScalingOptions& options, const Progress& progress)
{
  const Topology topology = RequireManifold(mesh, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components, between which there are no distances; give one of them");
  }
  const std::vector<int> points = FarthestPoints(mesh, options.Samples, progress.Part(0.0, 0.2));
  const Eigen::MatrixXd all = HeatDistances(mesh, points, progress.Part(0.2, 0.7));
  const Eigen::MatrixXd between = all(points, Eigen::all);
  return { points,
    Majorised(0.5 * (between + between.transpose()), options, progress.Part(0.7, 1.0)) };
}

Eigen::MatrixXd BiharmonicExtension(const Mesh& mesh, const ScaledSamples& samples)
{
  const Eigen::Index n = mesh.Points.rows();
  const IntrinsicTriangles flat = IntrinsicDelaunay(mesh);
  const TriangleAngles angles = AnglesOfSides(flat.Sides);
  const Eigen::SparseMatrix<double> stiffness =
    CotangentStiffness(flat.Triangles, angles.Cotangents, n);
  const Eigen::VectorXd masses = LumpedMasses(flat.Triangles, angles.Areas, n);
  const Eigen::VectorXd inverse = (masses.array() > 0.0).select(1.0 / masses.array(), 0.0);
  const Eigen::SparseMatrix<double> energy = stiffness * inverse.asDiagonal() * stiffness;

  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, samples.Positions.cols());
  result(samples.Points, Eigen::all) = samples.Positions;
  std::vector<char> free(n, 1);
  for (const int point : samples.Points)
  {
    free[point] = 0;
  }
  std::vector<int> place(n, -1);
  std::vector<int> unknowns;
  for (int i = 0; i < static_cast<int>(n); ++i)
  {
    if (free[i] != 0 && masses(i) > 0.0)
    {
      place[i] = static_cast<int>(unknowns.size());
      unknowns.push_back(i);
    }
  }
  if (unknowns.empty())
  {
    return result;
  }
  const Eigen::MatrixXd load = -(energy * result);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(energy.nonZeros());
  for (Eigen::Index column = 0; column < n; ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(energy, column); entry; ++entry)
    {
      if (place[entry.row()] >= 0 && place[column] >= 0)
      {
        entries.emplace_back(place[entry.row()], place[column], entry.value());
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky factor;
  factor.Factorize(matrix);
  result(unknowns, Eigen::all) = factor.Solve(load(unknowns, Eigen::all));
  return result;
}

Eigen::MatrixXd StressScaling(
  const Mesh& mesh, const StressScalingOptions& options, const Progress& progress)
{
  const ScaledSamples samples = ScaleSamples(mesh, options, progress.Part(0.0, 0.9));
  Eigen::MatrixXd result = BiharmonicExtension(mesh, samples);
  progress(1.0);
  return result;
}

} // namespace shape
