// One map between two surfaces, in a process of its own: see Usage.
#include "BenchmarkData.h"
#include "Cost.h"

#include "Correspondence/Correspondence.h"
#include "Correspondence/Evaluate/MapErrorCurve.h"
#include "Correspondence/Landmarks/LandmarkCells.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(correspondence_case PAIR LANDMARKS METHOD FILE

PAIR       a folder of CorrespondencePairs.py
LANDMARKS  which of its files of landmarks, such as landmarks5.txt; none: without; mirrored: before it, such
           as mirrored:landmarks12.txt: B is mirrored, so that landmarks are on the wrong sides
METHOD     FunctionalMap, ReversibleHarmonic, ReversibleHarmonicFromCells, GromovWasserstein,
           GromovWasserstein1000 (of so many samples), HeatKernel, BlendedIntrinsic, CommonSphere,
           CommonOrbifold, LandmarkCells; or Given: FILE is read, a position on B for each point of A,
           and measured
FILE       else it is written: where each point of A goes; none: nothing is

Prints one line: the seconds of a CPU and of the clock, the peak of memory above the start,
shape::CorrespondenceResult's facts, and errors along B over the root of its area, times 1000, from
the truth, at all points of A or, of more than 6000, at 400, and the mean of those from its mirror
image, at 400, where it is known, else -1.)";

/// The last three columns of a file of numbers, one row each line.
Eigen::MatrixXd ReadPositions(const std::string& path)
{
  std::ifstream file(path);
  std::vector<Eigen::RowVector3d> rows;
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::vector<double> numbers{ std::istream_iterator<double>(words), {} };
    if (numbers.size() < 3)
    {
      throw std::runtime_error(path + " has a line without a position");
    }
    rows.emplace_back(Eigen::Map<Eigen::RowVector3d>(numbers.data() + numbers.size() - 3));
  }
  Eigen::MatrixXd positions(rows.size(), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    positions.row(static_cast<Eigen::Index>(i)) = rows[i];
  }
  return positions;
}

shape::Landmarks ReadLandmarks(const std::string& path)
{
  std::ifstream file(path);
  shape::Landmarks landmarks;
  for (std::string line; std::getline(file, line);)
  {
    std::array<int, 2> pair{};
    if (std::istringstream(line) >> pair[0] >> pair[1])
    {
      landmarks.push_back(pair);
    }
  }
  return landmarks;
}

void Write(const std::string& path, const Eigen::MatrixXd& positions)
{
  std::ofstream file(path);
  file << positions.format(Eigen::IOFormat(Eigen::FullPrecision, Eigen::DontAlignCols)) << '\n';
  if (!file)
  {
    throw std::runtime_error(path + " cannot be written");
  }
}

/// What a map is, and what the filter would say of it.
shape::CorrespondenceResult Find(const std::string& method, const shape::Mesh& a,
  const shape::Mesh& b, const shape::Landmarks& landmarks)
{
  using Options = shape::CorrespondenceOptions;
  Options manySamples{ Options::MethodType::GromovWasserstein };
  manySamples.Samples = 1000;
  const std::map<std::string, Options> known = {
    { "ReversibleHarmonic", {} },
    { "ReversibleHarmonicFromCells",
      { Options::MethodType::ReversibleHarmonic, Options::StartType::LandmarkCells } },
    { "FunctionalMap", { Options::MethodType::FunctionalMap } },
    { "GromovWasserstein", { Options::MethodType::GromovWasserstein } },
    { "GromovWasserstein1000", manySamples },
    { "HeatKernel", { Options::MethodType::HeatKernel } },
    { "BlendedIntrinsic", { Options::MethodType::BlendedIntrinsic } },
    { "CommonSphere", { Options::MethodType::CommonSphere } },
    { "CommonOrbifold", { Options::MethodType::CommonOrbifold } },
  };
  if (method == "LandmarkCells")
  {
    shape::CorrespondenceResult result;
    result.Maps = shape::MapByLandmarkCells(a, b, landmarks);
    result.Facts = shape::EvaluateMaps(a, b, result.Maps);
    return result;
  }
  return shape::ComputeCorrespondence(a, b, landmarks, known.at(method));
}

/// The map is measured as the files' coordinates are, without ReadOff's change of size.
shape::Mesh ReadSurface(const std::string& path)
{
  shape::Mesh mesh = benchmark::ReadOff(path, false);
  std::ifstream file(path);
  std::string word;
  int points = 0, triangles = 0, edges = 0;
  file >> word >> points >> triangles >> edges;
  for (double& value : mesh.Points.reshaped<Eigen::RowMajor>())
  {
    file >> value;
  }
  return mesh;
}

/// Errors at every stride-th point of A.
shape::MapErrorCurveResult Errors(const shape::Mesh& a, const Eigen::MatrixXd& positions,
  const shape::Mesh& b, const Eigen::MatrixXd& truth, Eigen::Index stride)
{
  const auto chosen = Eigen::seq(0, a.Points.rows() - 1, stride);
  return shape::ComputeMapErrorCurve(
    a, positions, b, { a.Points(chosen, Eigen::all), truth(chosen, Eigen::all), {} });
}

void PrintErrors(const std::string& pair, const shape::Mesh& a, const shape::Mesh& b,
  const Eigen::MatrixXd& positions)
{
  std::fflush(stdout); // they may take longer than the map
  constexpr double thousand = 1000.0;
  // Exact geodesics of fine meshes, or to far places, take long: a few hundred tell the mean.
  constexpr Eigen::Index maximum = 6000, some = 400;
  const Eigen::Index points = a.Points.rows(), few = std::max<Eigen::Index>(1, points / some);
  const shape::MapErrorCurveResult errors =
    Errors(a, positions, b, ReadPositions(pair + "/truth.txt"), points > maximum ? few : 1);
  const bool hasMirrored = static_cast<bool>(std::ifstream(pair + "/mirrored.txt"));
  const double mirrored = hasMirrored
    ? thousand * Errors(a, positions, b, ReadPositions(pair + "/mirrored.txt"), few).Mean
    : -1.0;
  std::printf(" mean=%.3f median=%.3f p95=%.3f max=%.2f mirroredmean=%.3f\n",
    thousand * errors.Mean, thousand * errors.Median, thousand * errors.Percentile95,
    thousand * errors.Maximum, mirrored);
}

void Run(char** arguments)
{
  const std::string pair = arguments[1], method = arguments[3], path = arguments[4];
  std::string marks = arguments[2];
  const std::string prefix = "mirrored:";
  const bool isMirrored = marks.rfind(prefix, 0) == 0;
  const shape::Mesh a = ReadSurface(pair + "/A.off"), b = ReadSurface(pair + "/B.off");
  shape::Mesh other = b;
  if (isMirrored)
  {
    marks.erase(0, prefix.size());
    other.Points.col(0) *= -1.0;
    other.Triangles.col(1).swap(other.Triangles.col(2));
  }
  if (method == "Given")
  {
    PrintErrors(pair, a, b, ReadPositions(path));
    return;
  }
  const shape::Landmarks landmarks =
    marks == "none" ? shape::Landmarks() : ReadLandmarks(pair + "/" + marks);
  shape::CorrespondenceResult result;
  const benchmark::Cost cost =
    benchmark::Measure([&] { result = Find(method, a, other, landmarks); });
  const Eigen::MatrixXd positions =
    shape::PullBack(result.Maps.AToB, other.Triangles, b.Points); // where it is not mirrored
  if (path != "none")
  {
    Write(path, positions);
  }
  std::printf("points=%td,%td cpu=%.2f wall=%.2f mib=%.0f dirichlet=%.4f trip=%.5f reversed=%.3f "
              "found=%d distortion=%.4f mirrored=%.4f confidence=%.3f iterations=%d part=%d "
              "scale=%.4f share=%.4f covered=%.3f turned=%d image=%d",
    a.Points.rows(), b.Points.rows(), cost.Cpu, cost.Wall, cost.MiB, result.Facts.DirichletEnergy,
    result.Facts.RoundTrip, result.Facts.ReversedArea, result.Found ? 1 : 0,
    result.Start.Distortion, result.Start.MirroredDistortion, result.Start.Confidence,
    result.Iterations, static_cast<int>(result.Part.Which), result.Part.Scale, result.Part.Share,
    result.Facts.CoverageOfB, result.Facts.Mirrored ? 1 : 0, result.Start.MirrorImage ? 1 : 0);
  PrintErrors(pair, a, b, positions);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 5)
  {
    std::fputs(Usage, stderr);
    return 1;
  }
  try
  {
    Run(argv);
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s, %s: %s\n", argv[1], argv[3], problem.what());
    return 1;
  }
  return 0;
}
