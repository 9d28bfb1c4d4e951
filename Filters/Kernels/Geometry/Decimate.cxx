#include "Geometry/Decimate.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Geometry/PolyData.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <vector>

namespace shape
{

namespace
{

struct Watch
{
  const Progress& Report;
  bool Stopped = false;
};

/// No exception may pass through VTK: remember it and tell the filter to stop.
void OnProgress(vtkObject* caller, unsigned long, void* clientData, void* callData)
{
  auto* watch = static_cast<Watch*>(clientData);
  try
  {
    watch->Report(std::clamp(*static_cast<double*>(callData), 0.0, 1.0));
  }
  catch (const Aborted&)
  {
    watch->Stopped = true;
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}

} // namespace

Mesh Decimate(const Mesh& mesh, int points, const Progress& progress)
{
  if (points < 4)
  {
    throw InvalidInput("a surface cannot be simplified to " + std::to_string(points) +
      " points; ask for at least 4");
  }
  const Topology topology = SurfaceTopology(mesh);
  const int used = static_cast<int>((topology.ComponentId.array() >= 0).count());
  if (points >= used)
  {
    return mesh;
  }
  // On a closed surface: triangles = 2 points - 2 Euler number.
  const double triangles = std::max(4.0, 2.0 * points - 2.0 * topology.EulerNumber);
  const auto input = vtk::TakeSmartPointer(NewPolyData(mesh));
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(input);
  decimation->SetTargetReduction(std::max(0.0, 1.0 - triangles / mesh.Triangles.rows()));
  Watch watch{ progress };
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(&watch);
  decimation->AddObserver(vtkCommand::ProgressEvent, command);
  decimation->Update();
  if (watch.Stopped)
  {
    throw Aborted();
  }
  return MeshFromPolyData(decimation->GetOutput());
}

Mesh Subdivide(const Mesh& mesh)
{
  const int n = static_cast<int>(mesh.Points.rows());
  const int m = static_cast<int>(mesh.Triangles.rows());
  std::vector<std::array<int, 3>> edges; // lower point, higher point, 3 triangle + edge
  edges.reserve(3 * m);
  for (int t = 0; t < m; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(mesh.Triangles(t, k), mesh.Triangles(t, (k + 1) % 3));
      edges.push_back({ low, high, 3 * t + k });
    }
  }
  std::sort(edges.begin(), edges.end());
  Mesh finer{ Eigen::MatrixXd(n + 3 * m, 3), Eigen::MatrixXi(4 * m, 3) };
  finer.Points.topRows(n) = mesh.Points;
  Eigen::MatrixXi middles(m, 3);
  int count = n;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const auto [low, high, place] = edges[e];
    if (e == 0 || edges[e - 1][0] != low || edges[e - 1][1] != high)
    {
      finer.Points.row(count++) = 0.5 * (mesh.Points.row(low) + mesh.Points.row(high));
    }
    middles(place / 3, place % 3) = count - 1;
  }
  finer.Points.conservativeResize(count, 3);
  for (int t = 0; t < m; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      finer.Triangles.row(4 * t + k) << mesh.Triangles(t, k), middles(t, k),
        middles(t, (k + 2) % 3);
    }
    finer.Triangles.row(4 * t + 3) = middles.row(t);
  }
  return finer;
}

} // namespace shape
