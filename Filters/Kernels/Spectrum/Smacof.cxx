#include "Spectrum/Smacof.h"

#include "Base/Errors.h"
#include "Geodesics/FarthestPoints.h"
#include "Geodesics/HeatGeodesics.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Spectrum/Private/ClassicalMds.h"
#include "Spectrum/Private/GuttmanTransform.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Returns positions of s samples that fit the given distances (s x s).
Eigen::MatrixXd Majorised(
  const Eigen::MatrixXd& distances, const SmacofOptions& options, const Progress& progress)
{
  // Classical scaling gives the start.
  const Eigen::MatrixXd squares = distances.array().square();
  const Eigen::RowVectorXd means = squares.colwise().mean();
  Eigen::MatrixXd positions = -0.5 *
    ((squares.rowwise() - means) *
      ComputeScalingAxes(squares, options.Dimensions, progress.Part(0.0, 0.0)));
  Eigen::MatrixXd transformed;
  double before = 0.0;
  for (int k = 0;; ++k)
  {
    progress(static_cast<double>(k) / (options.Iterations + 1));
    const double stress = TransformByGuttman(distances, positions, transformed);
    if (k >= options.Iterations || (k > 0 && before - stress <= options.Tolerance * stress))
    {
      return positions;
    }
    before = stress;
    // A step of twice the length still lowers the stress and halves the number of steps (de Leeuw
    // and Heiser 1980).
    positions = 2.0 * transformed - positions;
  }
}

} // namespace

EmbeddedSamples EmbedSamples(
  const Surface& surface, const SmacofOptions& options, const Progress& progress)
{
  const Topology topology = RequireManifold(surface, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components, but distances between components are undefined; give a single component");
  }
  const std::vector<int> points =
    SampleFarthestPoints(surface, options.Samples, progress.Part(0.0, 0.2));
  const Eigen::MatrixXd all =
    ComputeHeatDistances(surface, points, progress.Part(0.2, 0.7, "computing geodesic distances"));
  // Computed distances are not exactly symmetric, so the mean of both directions is used.
  const Eigen::MatrixXd between = all(points, Eigen::all);
  return { points,
    Majorised(0.5 * (between + between.transpose()), options,
      progress.Part(0.7, 1.0, "embedding the surface")) };
}

Eigen::MatrixXd ExtendBiharmonically(
  const Surface& surface, const EmbeddedSamples& samples, const Progress& progress)
{
  progress(0.0);
  const Eigen::Index n = surface.Points().rows();
  const std::shared_ptr<const IntrinsicLaplacian> laplacian = GetIntrinsicLaplacian(surface);
  const Eigen::SparseMatrix<double>& stiffness = laplacian->Stiffness;
  const Eigen::VectorXd& masses = laplacian->Masses;
  // The smoothness energy X' L M^-1 L X (Rustamov 2011); its minimum with given samples is a linear
  // system for the other points.
  const Eigen::VectorXd inverse = (masses.array() > 0.0).select(1.0 / masses.array(), 0.0);
  const Eigen::SparseMatrix<double> energy = stiffness * inverse.asDiagonal() * stiffness;

  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, samples.Positions.cols());
  result(samples.Points, Eigen::all) = samples.Positions;
  std::vector<char> free(n, 1);
  for (const int point : samples.Points)
  {
    free[point] = 0;
  }
  std::vector<int> position(n, -1);
  std::vector<int> unknowns;
  for (int i = 0; i < static_cast<int>(n); ++i)
  {
    if (free[i] != 0 && masses(i) > 0.0)
    {
      position[i] = static_cast<int>(unknowns.size());
      unknowns.push_back(i);
    }
  }
  if (unknowns.empty())
  {
    return result;
  }
  // The given positions move to the right side.
  const Eigen::MatrixXd load = -(energy * result);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(energy.nonZeros());
  for (Eigen::Index column = 0; column < n; ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(energy, column); entry; ++entry)
    {
      if (position[entry.row()] >= 0 && position[column] >= 0)
      {
        entries.emplace_back(position[entry.row()], position[column], entry.value());
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky factor;
  factor.Factorize(matrix, progress.Part(0.1, 0.9));
  result(unknowns, Eigen::all) = factor.Solve(load(unknowns, Eigen::all), progress.Part(0.9, 1.0));
  return result;
}

Eigen::MatrixXd EmbedBySmacof(
  const Surface& surface, const SmacofOptions& options, const Progress& progress)
{
  const EmbeddedSamples samples = EmbedSamples(surface, options, progress.Part(0.0, 0.9));
  Eigen::MatrixXd result = ExtendBiharmonically(surface, samples, progress.Part(0.9, 1.0));
  progress(1.0);
  return result;
}

} // namespace shape
