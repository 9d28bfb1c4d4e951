// The harmonic volume map, or finite elements for the same boundary data.
#include "Cases/FiniteElements.h"
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Distance/SignedDistance.h"
#include "Harmonic/FiniteElementMap.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/NearSurfaceCharges.h"
#include "Search/CellLocator.h"
#include "Solids/Nesting.h"
#include "Support/ForkedProcesses.h"

#include <cblas.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>

namespace
{

constexpr const char* Usage = R"(MODEL DATA METHOD [Key=value ...]

MODEL   an OFF file: a closed surface; FILE@2 after two steps of sqrt(3)-subdivision (9 times as
        many points)
DATA    A a harmonic field that is known everywhere; B the sphere map of the model, linear in its
        triangles (kept in the folder Cache=, the working folder by default); C a smooth map that is
        not harmonic. Every method is given the values at the points of the surface.
METHOD  Accelerated, MultiLevel, SingleShot (OffsetDistance=, CollocationRatio=, SourceRatio=,
        Tolerance=), FiniteElements (Tetrahedra=, for each point of the surface; 20), or FEM: a peer
        that keeps the surface's triangles (Refine=, RadiusEdgeRatio=, Solver=, Ordering=, Threads=)
Reference=FILE  for data B and C: where the values of refined finite elements at the random points
        inside are kept
Processes=4  share the solution by Accelerated: largest cpu and mib of a process are processcpu, processmib
Evaluations=N  also evaluates a map of charges at N points inside: evaluate (CPU seconds) and evaluatemib
Images=FILE  keeps the images of the random points inside, or says how far they are from those kept
(imagesdiffer, of the size)
Weld=1  joins points at the same position first
Positions=4 in each triangle, Most=60000 of them in all, Interior=4000 points (with Winding=1 only where
the surface winds around once), Seed=1

CPU and wall seconds and the peak of memory are those of the method alone. Errors are root mean squares
divided by the longest side of the target's box: at the points (vertices); at random positions inside
triangles against the linear interpolation of the points' values (inside) and, for data A, against the
field (insidefield); and at random points inside the solid against the field or the reference
(interior). Of a map of charges also: the CPU seconds of each stage, by the first word of its name, and the
peak of memory up to its end.)";

constexpr int ReferenceSplits = 1;
constexpr double ReferenceRefinement = 4.0; // of the split surface's own cells

/// A column-major file of values, made by `make` where there is none.
Eigen::MatrixXd Kept(
  const std::string& path, Eigen::Index rows, const std::function<Eigen::MatrixXd()>& make)
{
  Eigen::MatrixXd values(rows, 3);
  const auto bytes = static_cast<std::streamsize>(sizeof(double) * values.size());
  std::ifstream kept(path, std::ios::binary | std::ios::ate);
  if (kept && kept.tellg() == bytes)
  {
    kept.seekg(0);
    kept.read(reinterpret_cast<char*>(values.data()), bytes);
    return values;
  }
  values = make();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(values.data()), bytes);
  return values;
}

/// The CPU seconds of each stage of a method, and the peak of memory up to its end.
class Stages
{
public:
  shape::Progress Report()
  {
    this->Since = benchmark::CpuSeconds();
    return shape::Progress(shape::Progress::Callback(
      [this](double, const char* stage)
      {
        this->Change(stage);
        return true;
      }));
  }

  /// As the first word of the stage's name, and that with mib.
  void AddTo(benchmark::Row& facts)
  {
    this->Change("");
    for (const auto& [name, cost] : this->Costs)
    {
      const std::string word = name.substr(0, name.find(' '));
      facts.Add(word, cost.Cpu).Add(word + "mib", cost.MiB);
    }
  }

private:
  void Change(const std::string& stage)
  {
    if (stage == this->Name)
    {
      return;
    }
    const double now = benchmark::CpuSeconds();
    if (!this->Name.empty())
    {
      benchmark::Cost& cost = this->Costs[this->Name];
      cost.Cpu += now - this->Since;
      cost.MiB = benchmark::PeakMiB();
    }
    this->Name = stage;
    this->Since = now;
  }

  std::string Name;
  double Since = 0.0;
  std::map<std::string, benchmark::Cost> Costs;
};

/// Returns `count` points inside: many in the largest ball around each of a few random points.
Eigen::MatrixXd ManyInside(const shape::Mesh& mesh, int count, unsigned int seed)
{
  constexpr int inBall = 100;
  const Eigen::MatrixXd centres =
    benchmark::InteriorPoints(mesh, (count + inBall - 1) / inBall, seed);
  const Eigen::VectorXd distances = shape::SignedDistance(mesh).Evaluate(centres).Distances;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::MatrixXd points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    // A cube in the ball.
    const double half = std::abs(distances(i / inBall)) / std::sqrt(3.0);
    for (int c = 0; c < 3; ++c)
    {
      points(i, c) = centres(i / inBall, c) + half * uniform(generator);
    }
  }
  return points;
}

/// Evaluates a solution at points.
using Solution = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

Solution RunVolumeMap(const shape::Mesh& mesh, const Eigen::MatrixXd& values,
  const shape::HarmonicVolumeMapOptions& options, int processes, benchmark::Cost& cost,
  benchmark::Row& facts)
{
  shape::HarmonicVolumeMapResult result;
  Stages stages;
  Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(processes, 2);
  shapetest::ForkedProcesses::Run(processes,
    [&](const shape::Processes& own)
    {
      shape::AcceleratedSetup setup;
      setup.Processes = own;
      cost = benchmark::Measure(
        [&] {
          result =
            shape::ComputeHarmonicVolumeMap(mesh, values, {}, options, stages.Report(), &setup);
        });
      costs.row(own.Number) << cost.Cpu, cost.MiB;
      own.Sum(costs);
    });
  if (processes > 1)
  {
    facts.Add("processcpu", costs.col(0).maxCoeff()).Add("processmib", costs.col(1).maxCoeff());
  }
  facts.Add("charges", result.Map.Points.rows())
    .Add("offset", result.OffsetDistance)
    .Add("rmseinside", result.Levels.back().RMSEInside)
    .Add("levels", result.Levels.size() - 1)
    .Add("iterations", result.Iterations);
  stages.AddTo(facts);
  return [map = result.Map](const Eigen::MatrixXd& points) { return Evaluate(map, points); };
}

Solution RunFiniteElements(const shape::Mesh& mesh, const Eigen::MatrixXd& values,
  const benchmark::FiniteElementOptions& options, benchmark::Cost& cost, benchmark::Row& facts)
{
  benchmark::FiniteElementResult result;
  cost = benchmark::Measure([&] { result = SolveByFiniteElements(mesh, values, options); });
  facts.Add("nodes", result.Solid.Points.rows())
    .Add("tetrahedra", result.Solid.Kinds.size())
    .Add("mesh", result.SecondsOfMesh)
    .Add("factor", result.SecondsOfFactor);
  return [result](const Eigen::MatrixXd& points)
  {
    const shape::CellPoints positions = shape::CellLocator(result.Solid).Find(points);
    return Eigen::MatrixXd(positions.Weights * result.Values);
  };
}

Solution RunElementsOfKernel(const shape::Mesh& mesh, const Eigen::MatrixXd& values, double each,
  benchmark::Cost& cost, benchmark::Row& facts)
{
  const int tetrahedra = static_cast<int>(each * static_cast<double>(mesh.Points.rows()));
  shape::FiniteElements result;
  cost =
    benchmark::Measure([&] { result = shape::ComputeFiniteElements(mesh, values, tetrahedra); });
  facts.Add("nodes", result.Points.rows()).Add("tetrahedra", result.Tetrahedra.rows());
  const auto map = std::make_shared<const shape::FiniteElementMap>(std::move(result));
  return [map](const Eigen::MatrixXd& points) { return map->Evaluate(points).Images; };
}

/// Reads the settings of a method; returns what computes its solution.
using Method = std::function<Solution(
  const shape::Mesh&, const Eigen::MatrixXd&, benchmark::Cost&, benchmark::Row&)>;

Method ReadMethod(const std::string& name, benchmark::Arguments& arguments)
{
  if (name == "FEM")
  {
    benchmark::FiniteElementOptions options;
    options.Refine = arguments.Setting("Refine", options.Refine);
    options.RadiusEdgeRatio = arguments.Setting("RadiusEdgeRatio", options.RadiusEdgeRatio);
    options.Solver = arguments.Setting("Solver", options.Solver);
    options.Ordering = arguments.Setting("Ordering", options.Ordering);
    openblas_set_num_threads(arguments.Setting("Threads", 1));
    return [options](const auto& mesh, const auto& values, auto& cost, auto& facts)
    { return RunFiniteElements(mesh, values, options, cost, facts); };
  }
  if (name == "FiniteElements")
  {
    const double each = arguments.Setting("Tetrahedra", 20.0);
    return [each](const auto& mesh, const auto& values, auto& cost, auto& facts)
    { return RunElementsOfKernel(mesh, values, each, cost, facts); };
  }
  using Type = shape::HarmonicVolumeMapOptions::MethodType;
  const std::map<std::string, Type> methods = { { "Accelerated", Type::Accelerated },
    { "MultiLevel", Type::MultiLevel }, { "SingleShot", Type::SingleShot } };
  const auto found = methods.find(name);
  if (found == methods.end())
  {
    throw benchmark::UsageError("\"" + name + "\" is not known");
  }
  shape::HarmonicVolumeMapOptions options;
  options.Method = found->second;
  options.OffsetDistance = arguments.Setting("OffsetDistance", options.OffsetDistance);
  options.CollocationRatio = arguments.Setting("CollocationRatio", options.CollocationRatio);
  options.SourceRatio = arguments.Setting("SourceRatio", options.SourceRatio);
  options.Tolerance = arguments.Setting("Tolerance", options.Tolerance);
  options.MaximumMemory = arguments.Setting("MaximumMemory", 64.0);
  const int processes = arguments.Setting("Processes", 1);
  return [options, processes](const auto& mesh, const auto& values, auto& cost, auto& facts)
  { return RunVolumeMap(mesh, values, options, processes, cost, facts); };
}

/// Finite elements for the same piecewise linear values on four times as many triangles and about
/// 100 times as many tetrahedra, at points.
Eigen::MatrixXd ReferenceValues(
  const shape::Mesh& mesh, const Eigen::MatrixXd& values, const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd both(mesh.Points.rows(), 6);
  both << mesh.Points, values;
  shape::Mesh fine = mesh;
  for (int i = 0; i < ReferenceSplits; ++i)
  {
    both = benchmark::Split(fine.Triangles, both);
  }
  fine.Points = both.leftCols<3>();
  benchmark::FiniteElementOptions options;
  options.Refine = ReferenceRefinement;
  options.RadiusEdgeRatio = 1.414;
  options.Solver = "CG";
  const auto result = SolveByFiniteElements(fine, both.rightCols<3>(), options);
  return shape::CellLocator(result.Solid).Find(points).Weights * result.Values;
}

double RootMeanSquare(const Eigen::MatrixXd& errors)
{
  return std::sqrt(errors.rowwise().squaredNorm().mean());
}

shape::Mesh ReadModel(const std::string& path, int steps, bool weld)
{
  shape::Mesh mesh = benchmark::ReadOff(path, weld);
  for (int i = 0; i < steps; ++i)
  {
    mesh = benchmark::Subdivide(mesh);
  }
  return shape::OrientByNesting(mesh, "the model");
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string model = arguments.NextWord(), data = arguments.NextWord(),
                    method = arguments.NextWord();
  if (data != "A" && data != "B" && data != "C")
  {
    throw benchmark::UsageError("\"" + data + "\" is not known");
  }
  const Method solve = ReadMethod(method, arguments);
  const bool weld = arguments.Setting("Weld", false), winding = arguments.Setting("Winding", false);
  const auto seed = static_cast<unsigned int>(arguments.Setting("Seed", 1));
  const std::string cache = arguments.Setting("Cache", "."),
                    reference = arguments.Setting("Reference", ""),
                    kept = arguments.Setting("Images", "");
  const int each = arguments.Setting("Positions", 4), most = arguments.Setting("Most", 60000),
            interiorPoints = arguments.Setting("Interior", 4000),
            evaluations = arguments.Setting("Evaluations", 0);
  arguments.RequireAllRead();

  const std::size_t at = model.rfind('@');
  const std::string path = model.substr(0, at);
  const int steps = at == std::string::npos ? 0 : std::stoi(model.substr(at + 1));
  const shape::Mesh mesh = ReadModel(path, steps, weld);
  const std::string name =
    std::filesystem::path(path).stem().string() + (steps > 0 ? "@" + std::to_string(steps) : "");

  const benchmark::HarmonicField field(mesh, seed);
  const bool known = data == "A";
  const Eigen::MatrixXd values = known ? field.Evaluate(mesh.Points)
    : data == "B" ? benchmark::MapToSphere(mesh, cache + "/" + name + ".sphere")
                  : benchmark::Deformed(mesh.Points);
  const double size = shape::ComputeLongestBoxEdge(values);

  benchmark::Cost cost;
  benchmark::Row facts;
  const Solution solution = solve(mesh, values, cost, facts);
  if (evaluations > 0)
  {
    const Eigen::MatrixXd points = ManyInside(mesh, evaluations, seed + 3);
    Eigen::MatrixXd images;
    const benchmark::Cost evaluation = benchmark::Measure([&] { images = solution(points); });
    facts.Add("evaluate", evaluation.Cpu).Add("evaluatemib", evaluation.MiB);
    if (known)
    {
      facts.Add("evaluated", RootMeanSquare(images - field.Evaluate(points)) / size);
    }
  }

  const auto positions = benchmark::SampleRandomly(mesh, each, most, seed + 1);
  const double vertices = RootMeanSquare(solution(mesh.Points) - values) / size;
  const Eigen::MatrixXd inTriangles = solution(positions.Points);
  const double inside =
    RootMeanSquare(inTriangles - benchmark::Interpolated(mesh, values, positions)) / size;
  double insideField = NAN, interior = NAN;
  if (known || !reference.empty())
  {
    const Eigen::MatrixXd points =
      benchmark::InteriorPoints(mesh, interiorPoints, seed + 2, winding);
    const Eigen::MatrixXd truth = known
      ? field.Evaluate(points)
      : Kept(reference, points.rows(), [&] { return ReferenceValues(mesh, values, points); });
    interior = RootMeanSquare(solution(points) - truth) / size;
  }
  if (!kept.empty())
  {
    const Eigen::MatrixXd images =
      solution(benchmark::InteriorPoints(mesh, interiorPoints, seed + 2, winding));
    const Eigen::MatrixXd before = Kept(kept, images.rows(), [&] { return images; });
    facts.Add("imagesdiffer", (images - before).cwiseAbs().maxCoeff() / size);
  }
  if (known)
  {
    insideField = RootMeanSquare(inTriangles - field.Evaluate(positions.Points)) / size;
  }
  figures.Print(benchmark::Row()
                  .Add("model", name)
                  .Add("points", mesh.Points.rows())
                  .Add("data", data)
                  .Add("method", method)
                  .Add(cost)
                  .Add("vertices", vertices)
                  .Add("inside", inside)
                  .Add("insidefield", insideField)
                  .Add("interior", interior)
                  .Append(facts));
}

const benchmark::Entry VolumeMap("volume_map", { Usage, Run });

} // namespace
