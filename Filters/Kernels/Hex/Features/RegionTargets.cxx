#include "Hex/Features/RegionTargets.h"

#include "Mesh/UsedPoints.h"

namespace shape
{

RegionTargets::RegionTargets(const Mesh& surfaces, const Eigen::MatrixXi& labels)
  : Surfaces(surfaces)
  , Labels(labels)
  , Network(FindRegionNetwork(surfaces.Triangles, labels))
{
  std::map<std::pair<int, int>, std::vector<int>> trianglesOf;
  for (int t = 0; t < static_cast<int>(labels.rows()); ++t)
  {
    trianglesOf[{ labels.row(t).minCoeff(), labels.row(t).maxCoeff() }].push_back(t);
  }
  for (const auto& [pair, triangles] : trianglesOf)
  {
    this->PatchOf[pair] = static_cast<int>(this->Patches.size());
    Mesh patch{ {}, surfaces.Triangles(triangles, Eigen::all) };
    const std::vector<int> used = FindUsedPoints(patch.Triangles, surfaces.Points.rows());
    patch.Triangles = RenumberPoints(patch.Triangles, used, surfaces.Points.rows());
    patch.Points = surfaces.Points(used, Eigen::all);
    this->Patches.emplace_back(std::move(patch));
  }
  for (const RegionNetwork::Curve& curve : this->Network.Curves)
  {
    this->CurvePoints.emplace_back(surfaces.Points(curve.Points, Eigen::all));
  }
}

} // namespace shape
