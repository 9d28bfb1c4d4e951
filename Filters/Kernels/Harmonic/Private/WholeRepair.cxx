#include "Harmonic/Private/WholeRepair.h"

#include "Base/Errors.h"
#include "Harmonic/Private/CorePart.h"

#include <numeric>
#include <utility>
#include <vector>

namespace shape
{

MapRepair RepairWhole(const ChargeSet& map, const Surface& domain, const Eigen::MatrixXd& images,
  const Progress& progress)
{
  constexpr double maximumWork = 8e7; // of Newton's method (UntangleOptions)
  CorePart part;
  try
  {
    // One tetrahedron means that their volume has no limit. No point is added on the boundary.
    part.Elements = FillWithElements(domain, images, 1, true,
      10 * static_cast<int>(domain.Points().rows()), progress.Part(0.0, 0.2));
  }
  catch (const SolveFailure&)
  {
    return {};
  }
  FiniteElements& elements = part.Elements;
  std::vector<char> isInside(elements.Points.rows(), 1);
  for (const int point : elements.Boundary.reshaped())
  {
    isInside[point] = 0;
  }
  const Eigen::MatrixXd values = Evaluate(map, elements.Points, progress.Part(0.2, 0.3));
  for (std::size_t i = 0; i < isInside.size(); ++i)
  {
    if (isInside[i] != 0)
    {
      const auto point = static_cast<Eigen::Index>(i);
      elements.Images.row(point) = values.row(point);
    }
  }
  part.Tetrahedra.resize(elements.Tetrahedra.rows());
  std::iota(part.Tetrahedra.begin(), part.Tetrahedra.end(), 0);
  part.Points.resize(elements.Points.rows());
  std::iota(part.Points.begin(), part.Points.end(), 0);
  UntanglePart(part, maximumWork, progress.Part(0.3, 1.0));
  if (!part.IsUntangled)
  {
    return {};
  }
  const Eigen::Index count = elements.Points.rows();
  return { std::move(elements), Eigen::VectorXd::Zero(count) };
}

} // namespace shape
