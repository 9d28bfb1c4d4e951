// Deformation of a patch by its boundary, beside CGAL's as-rigid-as-possible one.
#include "Cases/CgalMesh.h"
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Deform/ShapeDeformation.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Topology.h"
#include "Remesh/Coarsening.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(MODEL [Points=12500]

A closed surface (OFF) is coarsened to about Points points, what is below a plane across the y axis is
cut off, and the rest is deformed by its boundary: bent over a cylinder, and turned by 60 degrees. CPU
milliseconds, the median of several runs:
  graph, prepare    once for a shape and its boundary
  deform            the boundary moved again
of method Full, of Multiresolution, and of CGAL 5's Surface_mesh_deformation (ORIGINAL_ARAP, all of the
boundary as control vertices): build and preprocess, one iteration. rigid: how far the turned shape is
from the rigid motion, over the diagonal, CGAL's after 10 iterations. height: of the bent shape over
the boundary's mean; atrest: before. Set VTK_SMP_MAX_THREADS=1 and OPENBLAS_NUM_THREADS=1.)";

using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CgalDeformation =
  CGAL::Surface_mesh_deformation<CgalMesh, CGAL::Default, CGAL::Default, CGAL::ORIGINAL_ARAP>;

/// CPU milliseconds, the median of `count` runs.
double Median(int count, const std::function<void()>& work)
{
  return 1e3 * benchmark::MeasureMedian(count, work);
}

/// The largest part of what is above a twelfth of the height.
shape::Mesh CutPatch(const shape::Mesh& closed)
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

class Patch
{
public:
  explicit Patch(const shape::Mesh& surface)
    : Surface(surface)
    , Loop(shape::FindManifoldBoundaryLoops(surface).front())
    , Handle(shape::BuildCurveHandle(surface.Points(this->Loop, Eigen::all), true))
    , BentLoop(Bent(this->Handle.Positions))
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
      Median(5, [&] { prepared = shape::PrepareDeformation(graph, this->Handle, options); });
    const shape::HandlePose bent = shape::PoseHandle(this->Handle, this->BentLoop);
    Eigen::MatrixXd points;
    result.Deform = Median(21, [&] { points = prepared->Deform(bent).Points; });
    result.Height = this->Height(points);
    points = prepared->Deform(shape::PoseHandle(this->Handle, this->Turned(this->Handle.Positions)))
               .Points;
    result.Residual = this->Residual(points);
    return result;
  }

  Result Cgals() const
  {
    CgalMesh mesh = benchmark::ToCgal<CgalMesh::Point>(this->Surface);
    Result result{};
    std::unique_ptr<CgalDeformation> arap;
    result.Prepare = Median(5,
      [&]
      {
        arap = std::make_unique<CgalDeformation>(mesh);
        arap->insert_roi_vertices(mesh.vertices().begin(), mesh.vertices().end());
        for (const int point : this->Loop)
        {
          arap->insert_control_vertex(CgalMesh::Vertex_index(point));
        }
        arap->preprocess();
      });
    const auto move = [&](const Eigen::MatrixXd& positions)
    {
      for (std::size_t i = 0; i < this->Loop.size(); ++i)
      {
        const auto position = positions.row(static_cast<Eigen::Index>(i));
        arap->set_target_position(
          CgalMesh::Vertex_index(this->Loop[i]), { position(0), position(1), position(2) });
      }
    };
    const auto points = [&]
    {
      Eigen::MatrixXd positions(this->Surface.Points.rows(), 3);
      for (Eigen::Index i = 0; i < positions.rows(); ++i)
      {
        const auto& point = mesh.point(CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(i)));
        positions.row(i) << point.x(), point.y(), point.z();
      }
      return positions;
    };
    move(this->Turned(this->Handle.Positions));
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
  shape::BoundaryHandle Handle;
  Eigen::MatrixXd BentLoop;
  Eigen::Matrix3d Turn;
};

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string path = arguments.NextWord();
  const int points = arguments.Setting("Points", 12500);
  arguments.RequireAllRead();

  using Type = shape::DeformOptions::MultiresolutionType;
  const shape::Mesh surface =
    CutPatch(shape::CoarsenSurface(benchmark::ReadOff(path, true), points).Surface);
  const Patch patch(surface);
  figures.Print(benchmark::Row()
                  .Add("points", surface.Points.rows())
                  .Add("triangles", surface.Triangles.rows())
                  .Add("graph", Median(5, [&] { shape::BuildPointGraph(surface); }))
                  .Add("atrest", patch.RestHeight()));
  const auto report = [&](const std::string& name, const Result& result)
  {
    figures.Print(benchmark::Row()
                    .Add("method", name)
                    .Add("prepare", result.Prepare)
                    .Add("deform", result.Deform)
                    .Add("rigid", result.Residual)
                    .Add("height", result.Height));
  };
  report("Full", patch.Ours(Type::Off));
  report("Multiresolution", patch.Ours(Type::On));
  report("CGAL", patch.Cgals());
}

const benchmark::Entry Deform("deform", { Usage, Run });

} // namespace
