#include "Harmonic/Private/NearSources.h"

#include <numeric>
#include <vector>

namespace shape
{

NearSources InsertNearSources(const SignedDistance& boundary, const Eigen::MatrixXd& sites,
  const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets, const Progress& progress)
{
  constexpr double room = 0.6, nearer = 0.7;
  constexpr int steps = 4;
  const Eigen::Index n = sites.rows();
  Eigen::VectorXd reached = offsets;
  std::vector<int> open;
  for (int i = 0; i < n; ++i)
  {
    if (offsets(i) > 0.0 && normals.row(i).squaredNorm() > 0.0)
    {
      open.push_back(i);
    }
    else
    {
      reached(i) = 0.0;
    }
  }
  const auto positions = [&](const std::vector<int>& rows)
  {
    return Eigen::MatrixXd(sites(rows, Eigen::all) +
      Eigen::VectorXd(reached(rows)).asDiagonal() * normals(rows, Eigen::all));
  };
  for (int step = 0; step <= steps && !open.empty(); ++step)
  {
    const Eigen::VectorXd distances =
      boundary
        .Evaluate(positions(open), progress.Part(step / (steps + 1.0), (step + 1) / (steps + 1.0)))
        .Distances;
    std::vector<int> crowded;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      double& offset = reached(open[k]);
      if (!(distances(k) >= room * offset))
      {
        offset *= step < steps ? nearer : 0.0;
        crowded.push_back(open[k]);
      }
    }
    open = std::move(crowded);
  }

  std::vector<int> placed;
  NearSources sources;
  for (int i = 0; i < n; ++i)
  {
    if (reached(i) > 0.0)
    {
      placed.push_back(i);
    }
  }
  sources.Points = positions(placed);
  sources.Offsets = reached(placed);
  sources.Sites = Eigen::Map<const Eigen::VectorXi>(placed.data(), placed.size());
  return sources;
}

} // namespace shape
