#include "Mesh/RegionSurfaces.h"

#include "Base/Errors.h"

#include <algorithm>
#include <string>

namespace shape
{

RegionSurfaces::RegionSurfaces(const Mesh& surfaces, const Eigen::MatrixXi& labels)
  : Surfaces(surfaces)
  , Labels(labels)
{
  if (labels.rows() != surfaces.Triangles.rows() || labels.cols() != 2)
  {
    throw InvalidInput("each triangle must have two labels, those of the regions on its sides");
  }
  for (int t = 0; t < static_cast<int>(labels.rows()); ++t)
  {
    if (labels(t, 0) == labels(t, 1))
    {
      throw InvalidInput("triangle " + std::to_string(t) + " has region " +
        std::to_string(labels(t, 0)) +
        " on both sides; remove such triangles, or correct the array Regions");
    }
    for (const int label : { labels(t, 0), labels(t, 1) })
    {
      if (label != Outside)
      {
        this->TrianglesOf[label].push_back(t);
      }
    }
  }
}

Mesh RegionSurfaces::Extract(int label) const
{
  const std::vector<int>& triangles = this->TrianglesOf.at(label);
  Mesh surface;
  surface.Triangles = this->Surfaces.Triangles(triangles, Eigen::all);
  // Sorting costs as much as the region has points; marks at all points would cost as much as the
  // whole.
  std::vector<int> used(surface.Triangles.reshaped().begin(), surface.Triangles.reshaped().end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (int& corner : surface.Triangles.reshaped())
  {
    corner = static_cast<int>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (this->Labels(triangles[i], 0) != label)
    {
      surface.Triangles.row(static_cast<Eigen::Index>(i)).reverseInPlace();
    }
  }
  surface.Points = this->Surfaces.Points(used, Eigen::all);
  return surface;
}

} // namespace shape
