#include "Spectrum/Private/ClassicalMds.h"

#include "Base/Errors.h"
#include "Geodesics/FarthestPoints.h"
#include "Geodesics/HeatGeodesics.h"
#include "Linear/SymmetricEigen.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{

Eigen::MatrixXd ComputeScalingAxes(
  const Eigen::MatrixXd& squares, int dimensions, const Progress& progress)
{
  // Double centring turns squared distances into inner products of centred positions; their largest
  // eigenpairs give the positions.
  const Eigen::VectorXd means = squares.rowwise().mean();
  const Eigen::MatrixXd products =
    -0.5 * ((squares.colwise() - means).rowwise() - means.transpose()).array() - 0.5 * means.mean();
  const Eigenpairs largest = FindLargestEigenpairs(
    products, std::min<int>(dimensions, static_cast<int>(products.rows())), progress);
  Eigen::MatrixXd axes = Eigen::MatrixXd::Zero(squares.rows(), dimensions);
  for (Eigen::Index k = 0; k < largest.Values.size(); ++k)
  {
    // relative to the largest eigenvalue; smaller ones are rounding error
    constexpr double minimum = 1e-9;
    const double value = largest.Values(k);
    if (value > minimum * largest.Values(0))
    {
      axes.col(k) = largest.Vectors.col(k) / std::sqrt(value);
    }
  }
  return axes;
}

Eigen::MatrixXd EmbedByClassicalMds(
  const Surface& surface, int dimensions, int samples, const Progress& progress)
{
  const Topology topology = RequireManifold(surface, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components, but distances between components are undefined; give a single component, or "
      "use "
      "the spectral embedding");
  }
  const std::vector<int> points = SampleFarthestPoints(surface, samples, progress.Part(0.0, 0.2));
  // Outline (de Silva and Tenenbaum 2004, section 2):
  // 1. Distances of all points from the samples.
  // 2. Classical scaling of the samples.
  // 3. The positions of all points follow from their squared distances to the samples.
  // 4. The sign of each column is made independent of the solver; unused points are set to 0.
  Eigen::MatrixXd squares =
    ComputeHeatDistances(surface, points, progress.Part(0.2, 0.9, "computing geodesic distances"))
      .array()
      .square();
  squares = squares.array().isFinite().select(squares, 0.0);
  // Step 2. Computed distances are not exactly symmetric.
  Eigen::MatrixXd between = squares(points, Eigen::all);
  between = 0.5 * (between + between.transpose()).eval();
  const Eigen::RowVectorXd means = between.colwise().mean();
  // Step 3: positions of all points.
  Eigen::MatrixXd result = -0.5 *
    ((squares.rowwise() - means) *
      ComputeScalingAxes(between, dimensions, progress.Part(0.9, 1.0)));
  // Step 4: signs and unused points.
  FixSigns(result);
  for (Eigen::Index i = 0; i < result.rows(); ++i)
  {
    if (topology.ComponentId(i) < 0)
    {
      result.row(i).setZero();
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
