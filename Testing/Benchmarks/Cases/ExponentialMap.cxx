// Exponential maps around random seeds of a surface.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "ExponentialMap/ExponentialMap.h"
#include "ExponentialMap/PatchLayout.h"
#include "Parameterize/FlipRepair.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(MODEL SHARE JITTER SEEDS

MODEL   an OFF file; points at the same position are joined, the longest side of its box is made 1
SHARE   of the diagonal of the box: the radius
JITTER  each point is moved by a random vector from a ball of so many mean edges
SEEDS   how many, at random positions

A row for eq. 10 (single), eq. 11 (mean) and eq. 11 with smoothed normals (smoothed): the
percentages of triangles that are flipped and of those that are not torn, of patches without a flip
but torn ones, before and after mending, the mean over patches of the median symmetric Dirichlet
measure and of the 95th percentile of the conformal distortion, and microseconds of a CPU for each
patch, the best of several runs in turn: of the map alone, and with all that the filter does (the
seed's position, distortion, overlaps).)";

shape::Mesh Jittered(shape::Mesh mesh, double jitter)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
    for (int k = 0; k < 3; ++k)
    {
      sum += (corners.row((k + 1) % 3) - corners.row(k)).norm();
    }
  }
  const double radius = jitter * sum / (3.0 * static_cast<double>(mesh.Triangles.rows()));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (auto point : mesh.Points.rowwise())
  {
    Eigen::RowVector3d move(2.0, 0.0, 0.0);
    while (move.squaredNorm() > 1.0)
    {
      for (double& x : move)
      {
        x = uniform(random);
      }
    }
    point += radius * move;
  }
  return mesh;
}

struct Method
{
  const char* Name;
  shape::ExponentialMap Map;
  double Triangles = 0.0, Flipped = 0.0, Untorn = 0.0;
  int Clean = 0, Mended = 0;
  double Dirichlet = 0.0, Conformal = 0.0;
  double Seconds = 0.0, WholeSeconds = 0.0;
};

int UntornFlips(const shape::ExponentialPatch& patch)
{
  return static_cast<int>(std::count_if(patch.Flipped.begin(), patch.Flipped.end(),
    [&](int row) { return !std::binary_search(patch.Torn.begin(), patch.Torn.end(), row); }));
}

void Measure(Method& method, const shape::ExponentialPatch& patch, double radius)
{
  method.Triangles += static_cast<double>(patch.Triangles.size());
  method.Flipped += static_cast<double>(patch.Flipped.size());
  const int untorn = UntornFlips(patch);
  method.Untorn += untorn;
  method.Clean += untorn == 0 ? 1 : 0;
  Eigen::MatrixXd positions = patch.Positions;
  method.Mended += untorn ==
      shape::RepairFlips(
        shape::BuildPatchSurface(method.Map.Surface(), patch), positions, patch.Torn)
    ? 1
    : 0;
  const shape::ExponentialFacts facts =
    shape::ComputeExponentialFacts(method.Map.Surface(), patch, radius);
  method.Dirichlet += facts.SymmetricDirichlet.Median;
  method.Conformal += facts.ConformalDistortion.Percentile95;
}

double Seconds(const std::function<void()>& run)
{
  const double start = benchmark::CpuSeconds();
  run();
  return benchmark::CpuSeconds() - start;
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string model = arguments.NextWord();
  const double share = arguments.NextNumber(), jitter = arguments.NextNumber();
  const int count = arguments.NextInteger();
  arguments.RequireAllRead();
  constexpr int runs = 7;
  const shape::Mesh mesh = Jittered(benchmark::ReadOff(model, true), jitter);
  const double radius = share * shape::ComputeBoxDiagonal(mesh.Points);
  std::array<Method, 3> methods = { Method{ "single", shape::ExponentialMap(mesh, { false, 0 }) },
    Method{ "mean", shape::ExponentialMap(mesh, { true, 0 }) },
    Method{ "smoothed", shape::ExponentialMap(mesh) } };
  const Eigen::MatrixXd positions = shape::SampleRandomly(mesh, count, 7);
  const shape::SurfaceLocator locator(mesh);
  std::vector<shape::ClosestPoint> seeds;
  for (const auto& position : positions.rowwise())
  {
    seeds.push_back(locator.FindOne(position));
  }
  // In turn, so that what else the machine does falls on all; all seeds, so that each is met anew.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 6>> best(seeds.size());
  for (auto& seconds : best)
  {
    seconds.fill(infinity);
  }
  for (int run = 0; run < runs; ++run)
  {
    for (std::size_t m = 0; m < methods.size(); ++m)
    {
      Method& method = methods[m];
      for (std::size_t i = 0; i < seeds.size(); ++i)
      {
        shape::ExponentialPatch patch;
        best[i][m] =
          std::min(best[i][m], Seconds([&] { patch = method.Map.Around(seeds[i], radius); }));
        if (run == 0)
        {
          Measure(method, patch, radius);
        }
      }
      shape::PatchLayoutOptions options;
      options.Radius = radius;
      for (std::size_t i = 0; i < seeds.size(); ++i)
      {
        const Eigen::RowVector3d position = seeds[i].Position;
        best[i][3 + m] = std::min(best[i][3 + m],
          Seconds(
            [&] { FlattenPatch(method.Map, position, Eigen::RowVector3d::Zero(), options); }));
      }
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    Method& method = methods[m];
    for (const auto& seconds : best)
    {
      method.Seconds += seconds[m];
      method.WholeSeconds += seconds[3 + m];
    }
    figures.Print(benchmark::Row()
                    .Add("map", std::string(method.Name))
                    .Add("triangles", method.Triangles / count)
                    .Add("flipped", 100.0 * method.Flipped / method.Triangles)
                    .Add("untorn", 100.0 * method.Untorn / method.Triangles)
                    .Add("clean", 100.0 * method.Clean / count)
                    .Add("mended", 100.0 * method.Mended / count)
                    .Add("dirichlet", method.Dirichlet / count)
                    .Add("conformal", method.Conformal / count)
                    .Add("microseconds", 1e6 * method.Seconds / count)
                    .Add("whole", 1e6 * method.WholeSeconds / count));
  }
}

const benchmark::Entry ExponentialMap("exponential_map", { Usage, Run });

} // namespace
