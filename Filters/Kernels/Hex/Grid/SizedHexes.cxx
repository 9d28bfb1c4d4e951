#include "Hex/Grid/SizedHexes.h"

#include "Base/Parallel.h"
#include "Hex/Grid/SizeField.h"

#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// The sizes to ask for at the surface's points, so that what came out of `asked` becomes `sizes`:
/// less by the mean logarithm of the quads' ratios nearby.
Eigen::VectorXd Corrected(const Surface& surface, const Eigen::VectorXd& sizes,
  const Eigen::VectorXd& asked, const HexFit& fit, const Eigen::VectorXd& ratios)
{
  constexpr double reach = 3.0; // sizes
  Eigen::MatrixXd midpoints(fit.Quads.rows(), 3);
  for (Eigen::Index q = 0; q < fit.Quads.rows(); ++q)
  {
    midpoints.row(q) = fit.Solid.Points(fit.Quads.row(q), Eigen::all).colwise().mean();
  }
  const Eigen::ArrayXd logarithms = ratios.array().log();
  Eigen::VectorXd corrected = asked;
  ParallelFor(static_cast<int>(sizes.size()), 64,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const double width = reach * sizes(i);
        const Eigen::ArrayXd squared =
          (midpoints.rowwise() - surface.Points().row(i)).rowwise().squaredNorm() / (width * width);
        // The nearest quads count even where all are far away.
        const Eigen::ArrayXd weights = (0.5 * (squared.minCoeff() - squared)).exp();
        corrected(i) *= std::exp(-(weights * logarithms).sum() / weights.sum());
      }
    });
  return corrected;
}

} // namespace

SizedHexesResult BuildSizedHexahedra(const Surface& surface, const Eigen::VectorXd& sizes,
  GridHexesOptions options, const Progress& progress, const std::vector<Mesh>& innerSurfaces)
{
  RequireSizes(surface, sizes);
  const int rounds = options.Rounds;
  options.Snap = false; // it changes the sizes
  Eigen::VectorXd asked = sizes;
  SizedHexesResult result;
  for (const bool last : { false, true })
  {
    const Progress part = last ? progress.Part(0.4, 1.0) : progress.Part(0.0, 0.4);
    SizedGrid grid = BuildSizedGrid(surface, asked, part.Part(0.0, 0.2));
    options.CellSize = grid.CellSize;
    options.Seeds = std::move(grid.Seeds);
    options.Rounds = last ? rounds : 1;
    result.Hexes = BuildGridHexahedra(surface, options, part.Part(0.2, 1.0), innerSurfaces);
    const HexFit& fit = result.Hexes.Fit;
    result.Ratios = ComputeSizeRatios(fit.Solid.Points, fit.Quads, surface, sizes);
    if (!last)
    {
      asked = Corrected(surface, sizes, asked, fit, result.Ratios);
    }
  }
  return result;
}

} // namespace shape
