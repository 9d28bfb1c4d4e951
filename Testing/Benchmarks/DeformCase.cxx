// Deformation of a patch by its border, beside CGAL's as-rigid-as-possible one: see Usage.
#include "BenchmarkData.h"
#include "Cost.h"

#include "Deform/ShapeDeformation.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Surface.h"
#include "Remesh/Coarsening.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(deform_case MODEL [POINTS]

A closed surface (OFF) is coarsened to about POINTS (12500), what is below a plane across the y axis
is cut off, and the rest is deformed by its boundary: bent over a cylinder, and turned by 60 degrees.
Prints CPU milliseconds on one thread, the median of several runs:
  graph, prepare    once for a shape and its boundary
  deform            the boundary moved again
in full and with multiresolution, and of CGAL 5's Surface_mesh_deformation (ORIGINAL_ARAP, all of the
boundary as control vertices; GPL, which is why it is linked here only): build and preprocess, one
iteration. And how far each is from the rigid motion, over the diagonal, CGAL after 10 iterations.

Ends with 1 unless, in the same run, a pass in full takes at maximum 2 iterations of CGAL's, one with
multiresolution at maximum 1/2, the rigid motion is exact to 1e-12, and both resolutions keep the height
of the bent shape within 1 %. Set VTK_SMP_MAX_THREADS=1 and OPENBLAS_NUM_THREADS=1.)";

using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CgalDeformation =
  CGAL::Surface_mesh_deformation<CgalMesh, CGAL::Default, CGAL::Default, CGAL::ORIGINAL_ARAP>;

/// CPU milliseconds of the median of `count` runs.
double Median(int count, const std::function<void()>& work)
{
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
  {
    const double start = benchmark::CpuSeconds();
    work();
    times.push_back(1e3 * (benchmark::CpuSeconds() - start));
  }
  std::sort(times.begin(), times.end());
  return times[count / 2];
}

/// The largest part of what is above a twelfth of the height.
shape::Mesh Patch(const shape::Mesh& closed)
{
  const double low = closed.Points.col(1).minCoeff(), high = closed.Points.col(1).maxCoeff();
  std::vector<int> kept;
  for (int t = 0; t < closed.Triangles.rows(); ++t)
  {
    if (shape::GetCorners(closed, t).col(1).minCoeff() >= low + (high - low) / 12.0)
    {
      kept.push_back(t);
    }
  }
  const std::vector<shape::Mesh> parts =
    shape::SplitComponents({ closed.Points, closed.Triangles(kept, Eigen::all) });
  return *std::max_element(parts.begin(), parts.end(),
    [](const shape::Mesh& a, const shape::Mesh& b) { return a.Points.rows() < b.Points.rows(); });
}

/// Over a cylinder along x.
Eigen::MatrixXd Bent(Eigen::MatrixXd positions)
{
  const Eigen::RowVector3d middle = positions.colwise().mean();
  const double radius = 0.4 * (positions.col(2).maxCoeff() - positions.col(2).minCoeff());
  for (auto row : positions.rowwise())
  {
    const double angle = (row(2) - middle(2)) / radius, distance = radius + row(1) - middle(1);
    row(2) = middle(2) + distance * std::sin(angle);
    row(1) = middle(1) + distance * std::cos(angle) - radius;
  }
  return positions;
}

double Largest(const Eigen::MatrixXd& difference)
{
  return difference.rowwise().norm().maxCoeff();
}

struct Result
{
  double Prepare, Deform;  ///< milliseconds
  double Residual, Height; ///< over the diagonal; of the bent shape over the border's mean
};

class Case
{
public:
  explicit Case(const shape::Mesh& surface)
    : Surface(surface)
    , Loop(shape::FindManifoldBoundaryLoops(surface).front())
    , Loop(shape::BuildCurveHandle(surface.Points(this->Loop, Eigen::all), true))
    , BentLoop(Bent(this->Loop.Positions))
    , Turn(Eigen::AngleAxisd(M_PI / 3.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix())
  {
  }

  Result Ours(shape::DeformOptions::MultiresolutionType resolution) const
  {
    shape::DeformOptions options;
    options.Multiresolution = resolution;
    const shape::PointGraph graph = shape::BuildPointGraph(this->Surface);
    Result result{};
    std::unique_ptr<shape::ShapeDeformation> prepared;
    result.Prepare =
      Median(5, [&] { prepared = shape::PrepareDeformation(graph, this->Loop, options); });
    const shape::HandlePose bent = shape::PoseHandle(this->Loop, this->BentLoop);
    Eigen::MatrixXd points;
    result.Deform = Median(21, [&] { points = prepared->Deform(bent).Points; });
    result.Height = this->Height(points);
    points =
      prepared->Deform(shape::PoseHandle(this->Loop, this->Turned(this->Loop.Positions))).Points;
    result.Residual = this->Residual(points);
    return result;
  }

  Result Cgals() const
  {
    CgalMesh mesh;
    std::vector<CgalMesh::Vertex_index> corners;
    for (const auto& point : this->Surface.Points.rowwise())
    {
      corners.push_back(mesh.add_vertex({ point(0), point(1), point(2) }));
    }
    for (const auto& triangle : this->Surface.Triangles.rowwise())
    {
      mesh.add_face(corners[triangle(0)], corners[triangle(1)], corners[triangle(2)]);
    }
    Result result{};
    std::unique_ptr<CgalDeformation> arap;
    result.Prepare = Median(5,
      [&]
      {
        arap = std::make_unique<CgalDeformation>(mesh);
        arap->insert_roi_vertices(mesh.vertices().begin(), mesh.vertices().end());
        for (const int point : this->Loop)
        {
          arap->insert_control_vertex(corners[point]);
        }
        arap->preprocess();
      });
    const auto move = [&](const Eigen::MatrixXd& positions)
    {
      for (std::size_t i = 0; i < this->Loop.size(); ++i)
      {
        const auto position = positions.row(static_cast<Eigen::Index>(i));
        arap->set_target_position(
          corners[this->Loop[i]], { position(0), position(1), position(2) });
      }
    };
    const auto points = [&]
    {
      Eigen::MatrixXd positions(this->Surface.Points.rows(), 3);
      for (Eigen::Index i = 0; i < positions.rows(); ++i)
      {
        const auto& point = mesh.point(corners[i]);
        positions.row(i) << point.x(), point.y(), point.z();
      }
      return positions;
    };
    move(this->Turned(this->Loop.Positions));
    arap->deform(10, 0.0);
    result.Residual = this->Residual(points());
    arap->reset();
    move(this->BentLoop);
    result.Deform = Median(21, [&] { arap->deform(1, 0.0); });
    result.Height = this->Height(points());
    return result;
  }

  double RestHeight() const { return this->Height(this->Surface.Points); }

private:
  Eigen::MatrixXd Turned(const Eigen::MatrixXd& positions) const
  {
    return positions * this->Turn.transpose();
  }
  double Residual(const Eigen::MatrixXd& points) const
  {
    return Largest(points - this->Turned(this->Surface.Points)) /
      shape::ComputeBoxDiagonal(this->Surface.Points);
  }
  double Height(const Eigen::MatrixXd& points) const
  {
    return points.col(1).maxCoeff() - points(this->Loop, 1).mean();
  }

  shape::Mesh Surface;
  std::vector<int> Loop;
  shape::BoundaryHandle Loop;
  Eigen::MatrixXd BentLoop;
  Eigen::Matrix3d Turn;
};

bool Compare(const std::string& path, int points)
{
  using Type = shape::DeformOptions::MultiresolutionType;
  const shape::Mesh surface =
    Patch(shape::CoarsenSurface(benchmark::ReadOff(path, true), points).Surface);
  const Case one(surface);
  const double graph = Median(5, [&] { shape::BuildPointGraph(surface); });
  std::printf("%s: %ld points, %ld triangles; graph %.1f ms\n", path.c_str(),
    static_cast<long>(surface.Points.rows()), static_cast<long>(surface.Triangles.rows()), graph);
  const auto report = [](const char* name, const Result& result)
  {
    std::printf("  %-16s prepare=%.1f deform=%.2f rigid=%.1e height=%.4f\n", name, result.Prepare,
      result.Deform, result.Residual, result.Height);
    std::fflush(stdout);
  };
  const Result full = one.Ours(Type::Off);
  report("Full", full);
  const Result coarse = one.Ours(Type::On);
  report("Multiresolution", coarse);
  const Result cgal = one.Cgals();
  report("CGAL ARAP", cgal);
  std::printf(
    "  of an iteration of CGAL's: in full %.2f, multiresolution %.2f; height at rest %.4f\n",
    full.Deform / cgal.Deform, coarse.Deform / cgal.Deform, one.RestHeight());
  const auto isHigh = [&](const Result& result)
  { return std::abs(result.Height - full.Height) < 0.01 * full.Height; };
  return full.Deform < 2.0 * cgal.Deform && coarse.Deform < 0.5 * cgal.Deform &&
    full.Residual < 1e-12 && coarse.Residual < 1e-12 && isHigh(coarse);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2 || std::string(argv[1]) == "--help")
  {
    std::puts(Usage);
    return argc < 2;
  }
  try
  {
    if (!Compare(argv[1], argc > 2 ? std::stoi(argv[2]) : 12500))
    {
      std::puts("not as quick, or not as exact, as it must be");
      return 1;
    }
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
