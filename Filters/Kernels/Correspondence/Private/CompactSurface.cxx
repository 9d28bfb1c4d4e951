#include "Correspondence/Private/CompactSurface.h"

#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <cstddef>

namespace shape
{

CompactSurface::CompactSurface(const shape::Surface& given, const std::string& name)
  : Surface(given)
  , Given(given)
{
  const Topology topology = RequireManifold(given, name);
  const Eigen::Index points = given.Points().rows();
  this->PositionOf = Eigen::VectorXi::Constant(points, -1);
  for (int i = 0; i < static_cast<int>(points); ++i)
  {
    if (topology.ComponentId(i) >= 0)
    {
      this->PositionOf(i) = static_cast<int>(this->Points.size());
      this->Points.push_back(i);
    }
  }
  if (this->Points.size() < static_cast<std::size_t>(points))
  {
    this->Surface = { given.Points()(this->Points, Eigen::all),
      given.Triangles().unaryExpr([&](int point) { return this->PositionOf(point); }) };
  }
}

std::vector<int> CompactSurface::Representatives() const
{
  std::vector<int> representatives(this->PositionOf.begin(), this->PositionOf.end());
  if (this->Points.size() == representatives.size())
  {
    return representatives;
  }
  const SurfaceLocator locator(this->Surface);
  for (std::size_t i = 0; i < representatives.size(); ++i)
  {
    if (representatives[i] < 0)
    {
      const ClosestPoint closest =
        locator.FindOne(this->Given.Points().row(static_cast<Eigen::Index>(i)));
      Eigen::Index corner = 0;
      closest.Barycentric.maxCoeff(&corner);
      representatives[i] = this->Surface.Triangles()(closest.Triangle, corner);
    }
  }
  return representatives;
}

Eigen::MatrixXd CompactSurface::Expand(const Eigen::MatrixXd& values) const
{
  if (values.rows() == 0)
  {
    return values;
  }
  return values(this->Representatives(), Eigen::all);
}

SurfacePoints CompactSurface::Expand(const SurfacePoints& map) const
{
  const std::vector<int> representatives = this->Representatives();
  return { map.Triangles(representatives), map.Barycentrics(representatives, Eigen::all) };
}

} // namespace shape
