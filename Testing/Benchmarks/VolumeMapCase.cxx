// One measurement of the harmonic volume map, in a process of its own: see Usage.
#include "BenchmarkData.h"
#include "Cost.h"
#include "FiniteElements.h"

#include "Harmonic/HarmonicVolumeMap.h"
#include "Search/CellLocator.h"
#include "Solids/Nesting.h"

#include <cblas.h>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* Usage = R"(volume_map_case MODEL DATA METHOD [Key=value ...]

MODEL   an OFF file: a closed surface; FILE@2 after two steps of sqrt(3)-subdivision (9 times as
        many points)
DATA    A a harmonic field that is known everywhere; B the sphere map of the model, linear in its
        triangles (kept in the folder Cache=, the working folder by default); C a smooth map that is
        not harmonic. Every method is given the values at the points of the surface.
METHOD  Accelerated, MultiLevel, SingleShot (OffsetDistance=, CollocationRatio=, SourceRatio=,
        Tolerance=) or FEM (Refine=, RadiusEdgeRatio=, Solver=, Ordering=, Threads=)
Reference=FILE  for data B and C: where the values of refined finite elements at the random points
        inside are kept
Weld=1  joins points at the same position first
Positions=4 in each triangle, Most=60000 of them in all, Interior=4000 points (with Winding=1 only where the surface
winds around once), Seed=1

Prints one line: CPU and wall seconds and the peak of memory above the start (MiB) of the method
alone; root mean square errors divided by the longest side of the target's box: at the points, at
random positions inside triangles against the linear interpolation of the points' values and, for data
A, against the field; and at random points inside the solid against the field or the reference.)";

constexpr int ReferenceSplits = 1;
constexpr double ReferenceRefinement = 4.0; // of the split surface's own cells

using Settings = std::map<std::string, std::string>;

double Number(const Settings& settings, const std::string& key, double usual)
{
  const auto found = settings.find(key);
  return found == settings.end() ? usual : std::stod(found->second);
}

std::string Word(const Settings& settings, const std::string& key, const std::string& usual)
{
  const auto found = settings.find(key);
  return found == settings.end() ? usual : found->second;
}

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

/// Evaluates a solution at points.
using Solution = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

Solution RunVolumeMap(const shape::Mesh& mesh, const Eigen::MatrixXd& values,
  const std::string& method, const Settings& settings, benchmark::Cost& cost, std::string& note)
{
  using Method = shape::HarmonicVolumeMapOptions::MethodType;
  const std::map<std::string, Method> methods = { { "Accelerated", static_cast<Method>(0) },
    { "MultiLevel", Method::MultiLevel }, { "SingleShot", Method::SingleShot } };
  shape::HarmonicVolumeMapOptions options;
  options.Method = methods.at(method);
  options.OffsetDistance = Number(settings, "OffsetDistance", options.OffsetDistance);
  options.CollocationRatio = Number(settings, "CollocationRatio", options.CollocationRatio);
  options.SourceRatio = Number(settings, "SourceRatio", options.SourceRatio);
  options.Tolerance = Number(settings, "Tolerance", options.Tolerance);
  options.MaximumMemory = Number(settings, "MaximumMemory", 64.0);
  shape::HarmonicVolumeMapResult result;
  cost = benchmark::Measure(
    [&] { result = shape::ComputeHarmonicVolumeMap(mesh, values, {}, options); });
  std::ostringstream text;
  text << "charges:" << result.Map.Points.rows() << ",offset:" << result.OffsetDistance
       << ",RMSEInside:" << result.Levels.back().RMSEInside;
  note = text.str();
  return [map = result.Map](const Eigen::MatrixXd& points) { return Evaluate(map, points); };
}

Solution RunFiniteElements(const shape::Mesh& mesh, const Eigen::MatrixXd& values,
  const Settings& settings, benchmark::Cost& cost, std::string& note)
{
  benchmark::FiniteElementOptions options;
  options.Refine = Number(settings, "Refine", options.Refine);
  options.RadiusEdgeRatio = Number(settings, "RadiusEdgeRatio", options.RadiusEdgeRatio);
  options.Solver = Word(settings, "Solver", options.Solver);
  options.Ordering = Word(settings, "Ordering", options.Ordering);
  openblas_set_num_threads(static_cast<int>(Number(settings, "Threads", 1)));
  benchmark::FiniteElementResult result;
  cost = benchmark::Measure([&] { result = SolveByFiniteElements(mesh, values, options); });
  std::ostringstream text;
  text << "nodes:" << result.Solid.Points.rows() << ",tetrahedra:" << result.Solid.Kinds.size()
       << ",mesh:" << result.SecondsOfMesh << ",factor:" << result.SecondsOfFactor;
  note = text.str();
  return [result](const Eigen::MatrixXd& points)
  {
    const shape::CellPoints positions = shape::CellLocator(result.Solid).Find(points);
    return Eigen::MatrixXd(positions.Weights * result.Values);
  };
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

void Run(const std::string& model, const std::string& data, const std::string& method,
  const Settings& settings)
{
  const std::size_t at = model.rfind('@');
  const std::string path = model.substr(0, at);
  shape::Mesh mesh = benchmark::ReadOff(path, Number(settings, "Weld", 0) != 0);
  const int steps = at == std::string::npos ? 0 : std::stoi(model.substr(at + 1));
  for (int i = 0; i < steps; ++i)
  {
    mesh = benchmark::Subdivide(mesh);
  }
  mesh = shape::OrientByNesting(mesh, "the model");
  const auto seed = static_cast<unsigned int>(Number(settings, "Seed", 1));
  const std::string name =
    std::filesystem::path(path).stem().string() + (steps > 0 ? "@" + std::to_string(steps) : "");

  const benchmark::HarmonicField field(mesh, seed);
  const bool known = data == "A";
  const Eigen::MatrixXd values = known ? field.Evaluate(mesh.Points)
    : data == "B"
    ? benchmark::MapToSphere(mesh, Word(settings, "Cache", ".") + "/" + name + ".sphere")
    : benchmark::Deformed(mesh.Points);
  const double size = shape::ComputeLongestBoxEdge(values);

  benchmark::Cost cost;
  std::string note;
  const Solution solution = method == "FEM"
    ? RunFiniteElements(mesh, values, settings, cost, note)
    : RunVolumeMap(mesh, values, method, settings, cost, note);

  const auto positions =
    benchmark::SampleRandomly(mesh, static_cast<int>(Number(settings, "Places", 4)),
      static_cast<int>(Number(settings, "Most", 60000)), seed + 1);
  const double vertices = RootMeanSquare(solution(mesh.Points) - values) / size;
  const Eigen::MatrixXd inTriangles = solution(positions.Points);
  const double inside =
    RootMeanSquare(inTriangles - benchmark::Interpolated(mesh, values, positions)) / size;
  double insideField = NAN, interior = NAN;
  const std::string reference = Word(settings, "Reference", "");
  if (known || !reference.empty())
  {
    const Eigen::MatrixXd points =
      benchmark::InteriorPoints(mesh, static_cast<int>(Number(settings, "Interior", 4000)),
        seed + 2, Number(settings, "Winding", 0) != 0);
    const Eigen::MatrixXd truth = known
      ? field.Evaluate(points)
      : Kept(reference, points.rows(), [&] { return ReferenceValues(mesh, values, points); });
    interior = RootMeanSquare(solution(points) - truth) / size;
  }
  if (known)
  {
    insideField = RootMeanSquare(inTriangles - field.Evaluate(positions.Points)) / size;
  }
  std::printf("model=%s points=%d data=%s method=%s cpu=%.3f wall=%.3f mib=%.1f vertices=%.3e "
              "inside=%.3e insidefield=%.3e interior=%.3e note=%s\n",
    name.c_str(), static_cast<int>(mesh.Points.rows()), data.c_str(), method.c_str(), cost.Cpu,
    cost.Wall, cost.MiB, vertices, inside, insideField, interior, note.c_str());
}

} // namespace

int main(int count, char** words)
{
  try
  {
    if (count < 4)
    {
      throw std::runtime_error(Usage);
    }
    Settings settings;
    for (int i = 4; i < count; ++i)
    {
      const std::string word = words[i];
      const std::size_t sign = word.find('=');
      if (sign == std::string::npos)
      {
        throw std::runtime_error(Usage);
      }
      settings[word.substr(0, sign)] = word.substr(sign + 1);
    }
    Run(words[1], words[2], words[3], settings);
    return 0;
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
