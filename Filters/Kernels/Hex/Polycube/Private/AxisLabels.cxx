#include "Hex/Polycube/Private/AxisLabels.h"

#include "Mesh/HalfEdges.h"
#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/LabelCut.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

constexpr double Fidelity = 0.2, Sharpness = 0.25;
/// Of an edge with a sharp crease: a border is not for nothing.
constexpr double LeastBorderCost = 1e-3;

double Bell(double x, double width)
{
  return std::exp(-0.5 * (x / width) * (x / width));
}

} // namespace

Eigen::VectorXi FindAxisLabels(const WorkingSolid& solid, const Eigen::MatrixXd& places,
  double compactness, const Eigen::MatrixXd& further)
{
  const Mesh rest = solid.Surface();
  const Eigen::MatrixXd vectors = AreaVectors(rest);
  const Eigen::VectorXd areas = 0.5 * vectors.rowwise().norm();
  const Eigen::MatrixXd atRest = vectors.rowwise().normalized();
  const Eigen::MatrixXd normals = AreaVectors(solid.Surface(places)).rowwise().normalized();
  const double area = areas.mean();
  Eigen::MatrixXd costs = further.size() > 0 ? further : Eigen::MatrixXd::Zero(areas.size(), 6);
  for (Eigen::Index f = 0; f < areas.size(); ++f)
  {
    for (int label = 0; label < 6 && normals.row(f).allFinite(); ++label)
    {
      costs(f, label) +=
        areas(f) / area * (1.0 - Bell(normals.row(f).dot(LabelAxis(label)) - 1.0, Fidelity));
    }
  }
  const std::vector<HalfEdge> sides = SortedHalfEdges(solid.Triangles, solid.SurfacePoints);
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
          LeastBorderCost) });
  }
  length /= static_cast<double>(edges.size());
  std::for_each(edges.begin(), edges.end(), [&](LabelEdge& edge) { edge.Weight /= length; });
  return CutLabels(costs, edges);
}

} // namespace shape
