#include "Geometry/Private/QuadricSampling.h"

#include "Mesh/EdgeMidpoints.h"
#include "Mesh/HalfEdges.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Halves all edges: four triangles for each one, in its plane.
Mesh Subdivide(const Mesh& surface)
{
  std::vector<std::array<int, 2>> edges;
  for (const HalfEdge& half : SortHalfEdges(surface.Triangles, surface.Points.rows()))
  {
    const std::array<int, 2> edge{ half.Low(), half.High() };
    if (edges.empty() || edges.back() != edge)
    {
      edges.push_back(edge);
    }
  }
  const auto before = static_cast<int>(surface.Points.rows());
  CutTriangles cut = SplitEdges(surface.Triangles, edges, before);
  Mesh fine{ surface.Points, std::move(cut.Triangles) };
  fine.Points.conservativeResize(before + static_cast<Eigen::Index>(edges.size()), 3);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    fine.Points.row(before + static_cast<Eigen::Index>(e)) =
      0.5 * (surface.Points.row(edges[e][0]) + surface.Points.row(edges[e][1]));
  }
  return fine;
}

/// Lets VTK collapse edges until `triangles` triangles are left.
vtkNew<vtkQuadricDecimation> Decimate(const Mesh& surface, Eigen::Index triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface.Points.rows());
  for (Eigen::Index i = 0; i < surface.Points.rows(); ++i)
  {
    points->SetPoint(i, surface.Points(i, 0), surface.Points(i, 1), surface.Points(i, 2));
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : surface.Triangles.rowwise())
  {
    cells->InsertNextCell({ triangle(0), triangle(1), triangle(2) });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(data);
  const double left =
    static_cast<double>(triangles) / static_cast<double>(surface.Triangles.rows());
  decimation->SetTargetReduction(std::clamp(1.0 - left, 0.0, 1.0));
  decimation->Update();
  return decimation;
}

} // namespace

Eigen::MatrixXd SimplifyByQuadrics(const Mesh& surface, int count, const Progress& progress)
{
  // Steps 1 and 2 of section 4.1.1: a dense mesh of the surface.
  constexpr double density = 4.0; // points / count
  Mesh dense = surface;
  while (static_cast<double>(dense.Points.rows()) < density * count)
  {
    dense = Subdivide(dense);
    progress(0.1);
  }
  // Step 3: simplification. A closed surface has about twice as many triangles as points.
  const auto decimation = Decimate(dense, 2 * static_cast<Eigen::Index>(count));
  progress(0.9);
  // Step 4: the points of its triangles.
  vtkPolyData* simplified = decimation->GetOutput();
  Eigen::MatrixXd points(simplified->GetNumberOfPoints(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    double point[3];
    simplified->GetPoint(i, point);
    points.row(i) << point[0], point[1], point[2];
  }
  return points;
}

} // namespace shape
