#include "Hex/Polycube/Private/AxisLabels.h"

#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/GraphCutLabelling.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

constexpr double Fidelity = 0.2, Sharpness = 0.25;
/// Of an edge with a sharp crease: a border is not for nothing.
constexpr double MinimumBoundaryCost = 1e-3;

double Bell(double x, double width)
{
  return std::exp(-0.5 * (x / width) * (x / width));
}

} // namespace

Eigen::VectorXi FindAxisLabels(const WorkingSolid& solid, const Eigen::MatrixXd& positions,
  double compactness, const Eigen::MatrixXd& further)
{
  const Mesh rest = solid.Surface();
  const Eigen::MatrixXd vectors = ComputeAreaVectors(rest);
  const Eigen::VectorXd areas = 0.5 * vectors.rowwise().norm();
  const Eigen::MatrixXd atRest = vectors.rowwise().normalized();
  const Eigen::MatrixXd normals =
    ComputeAreaVectors(solid.Surface(positions)).rowwise().normalized();
  const double area = areas.mean();
  Eigen::MatrixXd costs = further.size() > 0 ? further : Eigen::MatrixXd::Zero(areas.size(), 6);
  for (Eigen::Index f = 0; f < areas.size(); ++f)
  {
    for (int label = 0; label < 6 && normals.row(f).allFinite(); ++label)
    {
      costs(f, label) +=
        areas(f) / area * (1.0 - Bell(normals.row(f).dot(GetLabelAxis(label)) - 1.0, Fidelity));
    }
  }
  const std::vector<HalfEdge> sides = SortHalfEdges(solid.Triangles, solid.SurfacePointCount);
  std::vector<LabelEdge> edges;
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const int t = sides[i].Triangle, s = sides[i + 1].Triangle;
    const double own = (rest.Points.row(sides[i].Begin) - rest.Points.row(sides[i].End)).norm();
    length += own;
    edges.push_back({ t, s,
      own *
        (compactness * Bell(atRest.row(t).dot(atRest.row(s)) - 1.0, Sharpness) +
          MinimumBoundaryCost) });
  }
  length /= static_cast<double>(edges.size());
  std::for_each(edges.begin(), edges.end(), [&](LabelEdge& edge) { edge.Weight /= length; });
  return SolveGraphCutLabelling(costs, edges);
}

} // namespace shape
