#include "Atlas/Synthesize.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace shape
{

Eigen::MatrixXd Synthesize(const ModeValues& values, const Eigen::VectorXd& weights)
{
  const Eigen::Index d = values.Mean.cols();
  const Eigen::Index modes = d > 0 ? values.Modes.cols() / d : 0;
  if (weights.size() > modes)
  {
    throw InvalidInput("there are " + std::to_string(weights.size()) + " weights for " +
      std::to_string(modes) + " modes; give at most one weight for each mode");
  }
  RequireFinite(weights, "the list of weights");
  Eigen::MatrixXd sum = values.Mean;
  for (Eigen::Index k = 0; k < weights.size(); ++k)
  {
    if (weights(k) != 0.0)
    {
      sum += weights(k) * values.Modes.middleCols(d * k, d);
    }
  }
  return sum;
}

void RequireValid(const SynthesizeOptions& options)
{
  RequireOption(options.Tetrahedra >= 1000 && options.Tetrahedra <= 100000000, "Tetrahedra",
    options.Tetrahedra, "between 1000 and 100000000");
  RequireOption(options.WantedScaledJacobian >= 0.0 && options.WantedScaledJacobian <= 1.0,
    "WantedScaledJacobian", options.WantedScaledJacobian, "between 0 and 1");
}

FiniteElements SolveModes(const Surface& surface, const ModeValues& images,
  const SynthesizeOptions& options, const Progress& progress)
{
  RequireValid(options);
  Eigen::MatrixXd values(images.Mean.rows(), images.Mean.cols() + images.Modes.cols());
  values << images.Mean, images.Modes;
  return ComputeFiniteElements(surface, values, options.Tetrahedra, progress);
}

CarriedModes CarryModes(
  const FiniteElementMap& map, const Eigen::MatrixXd& points, const Progress& progress)
{
  const FiniteElements& elements = map.Elements();
  const Eigen::Index columns = elements.Images.cols();
  const double size =
    (elements.Points.colwise().maxCoeff() - elements.Points.colwise().minCoeff()).maxCoeff();
  FiniteElementMap::Values values = map.Evaluate(points, progress.Part(0.0, 0.9));
  CarriedModes carried;
  carried.Distances = values.Distances / size;
  carried.OutsideDomain = (carried.Distances.array() > NearTemplate).cast<int>();
  std::vector<int> near;
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    if (carried.OutsideDomain(i) != 0)
    {
      values.Images.row(i).setZero();
      values.Images.row(i).head<3>() = points.row(i);
    }
    else if (carried.Distances(i) > 0.0)
    {
      near.push_back(i);
    }
  }
  // The image of the first corner, and the derivative from there.
  const Eigen::VectorXi cells = values.Cells(near);
  const Eigen::MatrixXd jacobians = map.Jacobians(cells, progress.Part(0.9, 1.0));
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    const int corner = elements.Tetrahedra(cells(row), 0);
    const Eigen::RowVector3d step = points.row(near[i]) - elements.Points.row(corner);
    for (Eigen::Index c = 0; c < columns; ++c)
    {
      values.Images(near[i], c) =
        elements.Images(corner, c) + jacobians.block<1, 3>(row, 3 * c).dot(step);
    }
  }
  carried.Mean = values.Images.leftCols(3);
  carried.Modes = values.Images.rightCols(columns - 3);
  progress(1.0);
  return carried;
}

Eigen::VectorXi FindInvertedCells(
  const CellSimplices& cells, const Eigen::MatrixXd& rest, const Eigen::MatrixXd& moved)
{
  const auto orientation = [](const Eigen::MatrixXd& points, const std::array<int, 4>& c)
  {
    return EvaluateOrientation(
      points.row(c[0]), points.row(c[1]), points.row(c[2]), points.row(c[3]));
  };
  Eigen::VectorXi inverted = Eigen::VectorXi::Zero(cells.Count());
  ParallelFor(cells.Count(), 4096,
    [&](int begin, int end)
    {
      for (int cell = begin; cell < end; ++cell)
      {
        inverted(cell) = std::any_of(cells.Corners.begin() + cells.Offsets[cell],
          cells.Corners.begin() + cells.Offsets[cell + 1],
          [&](const std::array<int, 4>& corners)
          {
            const int before = corners[3] < 0 ? 0 : orientation(rest, corners);
            return before != 0 && orientation(moved, corners) != before;
          });
      }
    });
  return inverted;
}

} // namespace shape
