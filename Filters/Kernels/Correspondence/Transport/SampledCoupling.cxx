#include "Correspondence/Transport/SampledCoupling.h"

#include "Base/Errors.h"
#include "Mesh/Graph.h"

#include <limits>
#include <string>

namespace shape
{
namespace
{

/// For each point of the surface, the index of the sample that is nearest along edges; -1 if no
/// path leads to a sample.
Eigen::VectorXi FindCells(
  const Surface& surface, const std::vector<int>& samples, const Progress& progress)
{
  const Eigen::Index points = surface.Points().rows();
  const auto graph = GetEdgeGraph(surface);
  Eigen::VectorXi cells = Eigen::VectorXi::Constant(points, -1);
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    cells(samples[k]) = static_cast<int>(k);
  }
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(points, std::numeric_limits<double>::infinity());
  Eigen::Index settled = 0;
  RunDijkstra(
    *graph, { samples, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(samples.size())) },
    distances, [&](double distance, int k) { return distance + graph->Lengths[k]; },
    [&](int node, int before)
    {
      if (before >= 0)
      {
        cells(node) = cells(before);
      }
    },
    [&](int)
    {
      constexpr Eigen::Index often = 1000; // points between two reports
      if (++settled % often == 0)
      {
        progress(static_cast<double>(settled) / static_cast<double>(points));
      }
      return false;
    });
  progress(1.0);
  return cells;
}

} // namespace

CouplingEntries ListEntries(const Eigen::MatrixXd& masses, double smallest)
{
  CouplingEntries entries;
  std::vector<double> kept;
  for (Eigen::Index i = 0; i < masses.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < masses.cols(); ++j)
    {
      if (masses(i, j) > smallest)
      {
        entries.OfA.push_back(static_cast<int>(i));
        entries.OfB.push_back(static_cast<int>(j));
        kept.push_back(masses(i, j));
      }
      else
      {
        entries.Omitted += masses(i, j);
      }
    }
  }
  entries.Masses =
    Eigen::Map<const Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
  return entries;
}

Eigen::VectorXd ComputeImageDistribution(const Surface& a, const Surface& b,
  const SampledCoupling& coupling, int point, const Progress& progress)
{
  const auto count = static_cast<int>(a.Points().rows());
  if (point < 0 || point >= count)
  {
    throw InvalidInput("there is no point " + std::to_string(point) +
      " whose image could be shown; use an index from 0 to " + std::to_string(count - 1));
  }
  const int sample = FindCells(a, coupling.SamplesOfA, progress.Part(0.0, 0.5))(point);
  if (sample < 0)
  {
    throw InvalidInput("point " + std::to_string(point) +
      ", whose image should be shown, is in no triangle; choose a point of the surface");
  }
  const Eigen::VectorXi cells = FindCells(b, coupling.SamplesOfB, progress.Part(0.5, 1.0));
  const Eigen::VectorXd areas = ComputePointAreas(b);
  Eigen::VectorXd cellAreas = Eigen::VectorXd::Zero(coupling.Masses.cols());
  for (Eigen::Index i = 0; i < cells.size(); ++i)
  {
    if (cells(i) >= 0)
    {
      cellAreas(cells(i)) += areas(i);
    }
  }
  const Eigen::VectorXd masses = coupling.Masses.row(sample) / coupling.Masses.row(sample).sum();
  Eigen::VectorXd density = Eigen::VectorXd::Zero(cells.size());
  for (Eigen::Index i = 0; i < cells.size(); ++i)
  {
    // Every sample is in its own cell and has triangles, so no area is 0.
    density(i) = cells(i) < 0 ? 0.0 : masses(cells(i)) / cellAreas(cells(i));
  }
  return density;
}

} // namespace shape
