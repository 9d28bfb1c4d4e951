// Points and an outline in the plane, triangulated by TriangulateInPlane and by vtkDelaunay2D in
// one run.
#include "Cost.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Planar/PlanarDelaunay.h"

#include "vtkCellArray.h"
#include "vtkDelaunay2D.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(planar_delaunay KIND POINTS

KIND  random: in a square; grid: of a square lattice; circle: an outline; clustered: maximum near a
      corner of the square

Prints how many triangles the points' hull, or the outline, has, and of each program how many it
found and its CPU milliseconds. vtkDelaunay2D has tolerance 0.

On one core of a shared machine:
  random 20000       39974 triangles: ours all in 29 ms; VTK all but 93 in 3.9 s
  grid 20000         39458: all in 29 ms; all but 9 in 0.7 s
  circle 2000        1998: all in 14 ms; all in 0.18 s (of 20000: 57 ms and 106 s)
  clustered 1000     1978: all in 1.3 ms; all but 300 in 70 ms
  clustered 20000    39966: all in 29 ms; it ends with a segmentation fault)";

Eigen::MatrixXd Positions(const std::string& kind, int count)
{
  std::mt19937 random(static_cast<unsigned int>(count));
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const int side = static_cast<int>(std::sqrt(static_cast<double>(count)));
  Eigen::MatrixXd points(count, 2);
  for (int i = 0; i < count; ++i)
  {
    const double a = share(), b = share(), angle = 2.0 * M_PI * i / count;
    if (kind == "grid")
    {
      points.row(i) << i % side, i / side;
    }
    else if (kind == "circle")
    {
      points.row(i) << std::cos(angle), std::sin(angle);
    }
    else if (kind == "clustered")
    {
      points.row(i) << std::pow(a, 8.0), std::pow(b, 8.0);
    }
    else if (kind == "random")
    {
      points.row(i) << a, b;
    }
    else
    {
      throw shape::InvalidInput(Usage);
    }
  }
  return points;
}

/// Points on the border of the convex hull (Andrew 1979).
int PointsOfHull(const Eigen::MatrixXd& points)
{
  std::vector<int> order(points.rows()), onHull(points.rows(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      return std::make_pair(points(a, 0), points(a, 1)) <
        std::make_pair(points(b, 0), points(b, 1));
    });
  for (int half = 0; half < 2; ++half)
  {
    std::vector<int> chain;
    for (const int point : order)
    {
      while (chain.size() > 1 &&
        shape::EvaluateOrientation(Eigen::RowVector2d(points.row(chain[chain.size() - 2])),
          Eigen::RowVector2d(points.row(chain.back())), Eigen::RowVector2d(points.row(point))) < 0)
      {
        chain.pop_back();
      }
      chain.push_back(point);
    }
    for (const int point : chain)
    {
      onHull[point] = 1;
    }
    std::reverse(order.begin(), order.end());
  }
  return std::accumulate(onHull.begin(), onHull.end(), 0);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc != 3)
    {
      throw shape::InvalidInput(Usage);
    }
    const Eigen::MatrixXd points = Positions(argv[1], std::atoi(argv[2]));
    const auto count = static_cast<int>(points.rows());
    const bool isOutline = std::string(argv[1]) == "circle";
    std::printf("wanted %d\n",
      isOutline ? count - 2 : 2 * count - 2 - PointsOfHull(points)); // by Euler's formula
    Eigen::MatrixXi segments(isOutline ? count : 0, 2);
    for (int i = 0; i < static_cast<int>(segments.rows()); ++i)
    {
      segments.row(i) << i, (i + 1) % count;
    }
    shape::PlanarTriangulation own;
    const benchmark::Cost cost =
      benchmark::Measure([&] { own = shape::TriangulateInPlane(points, segments); });
    std::printf("ours %td in %.1f ms\n", own.Triangles.rows(), 1e3 * cost.Cpu);
    std::fflush(stdout);

    vtkNew<vtkPoints> positions;
    positions->SetDataTypeToDouble();
    for (const auto& point : points.rowwise())
    {
      positions->InsertNextPoint(point(0), point(1), 0.0);
    }
    vtkNew<vtkPolyData> data, outline;
    data->SetPoints(positions);
    vtkNew<vtkDelaunay2D> peer;
    peer->SetInputData(data);
    peer->SetTolerance(0.0);
    if (isOutline)
    {
      vtkNew<vtkCellArray> polygon;
      polygon->InsertNextCell(count);
      for (int i = 0; i < count; ++i)
      {
        polygon->InsertCellPoint(i);
      }
      outline->SetPoints(positions);
      outline->SetPolys(polygon);
      peer->SetSourceData(outline);
    }
    const benchmark::Cost peerCost = benchmark::Measure([&] { peer->Update(); });
    std::printf("VTK %lld in %.1f ms\n",
      static_cast<long long>(peer->GetOutput()->GetNumberOfCells()), 1e3 * peerCost.Cpu);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
