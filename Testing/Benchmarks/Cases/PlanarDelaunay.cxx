// Points and an outline in the plane, triangulated by TriangulateInPlane and by vtkDelaunay2D in
// one run.
#include "Driver/Case.h"

#include "Geometry/Orientation.h"
#include "Planar/PlanarDelaunay.h"

#include "vtkCellArray.h"
#include "vtkDelaunay2D.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(KIND POINTS

KIND  random: in a square; grid: of a square lattice; circle: an outline; clustered: most near a corner
      of the square

How many triangles the points' hull, or the outline, has, and of each program how many it found and its
CPU milliseconds. vtkDelaunay2D has tolerance 0; of 20,000 clustered points it ends with a segmentation
fault.)";

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
      throw benchmark::UsageError("\"" + kind + "\" is not known");
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

double TriangulateByVTK(const Eigen::MatrixXd& points, bool isOutline, long& triangles)
{
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
    polygon->InsertNextCell(static_cast<int>(points.rows()));
    for (int i = 0; i < points.rows(); ++i)
    {
      polygon->InsertCellPoint(i);
    }
    outline->SetPoints(positions);
    outline->SetPolys(polygon);
    peer->SetSourceData(outline);
  }
  const benchmark::Cost cost = benchmark::Measure([&] { peer->Update(); });
  triangles = static_cast<long>(peer->GetOutput()->GetNumberOfCells());
  return cost.Cpu;
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string kind = arguments.NextWord();
  const int count = arguments.NextInteger();
  arguments.RequireAllRead();

  const Eigen::MatrixXd points = Positions(kind, count);
  const bool isOutline = kind == "circle";
  Eigen::MatrixXi segments(isOutline ? count : 0, 2);
  for (int i = 0; i < static_cast<int>(segments.rows()); ++i)
  {
    segments.row(i) << i, (i + 1) % count;
  }
  shape::PlanarTriangulation own;
  const benchmark::Cost cost =
    benchmark::Measure([&] { own = shape::TriangulateInPlane(points, segments); });
  // By Euler's formula.
  const int wanted = isOutline ? count - 2 : 2 * count - 2 - PointsOfHull(points);
  const auto report = [&](const std::string& method, long triangles, double seconds)
  {
    figures.Print(benchmark::Row()
                    .Add("method", method)
                    .Add("wanted", wanted)
                    .Add("triangles", triangles)
                    .Add("milliseconds", 1e3 * seconds));
  };
  report("ShapeMap", static_cast<long>(own.Triangles.rows()), cost.Cpu);
  long triangles = 0;
  const double seconds = TriangulateByVTK(points, isOutline, triangles);
  report("VTK", triangles, seconds);
}

const benchmark::Entry PlanarDelaunay("planar_delaunay", { Usage, Run });

} // namespace
