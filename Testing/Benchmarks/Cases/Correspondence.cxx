// A map between two surfaces, beside the true one.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Correspondence/Correspondence.h"
#include "Correspondence/Evaluate/MapErrorCurve.h"
#include "Correspondence/Landmarks/LandmarkCells.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(PAIR LANDMARKS METHOD FILE

PAIR       a folder of CorrespondencePairs.py
LANDMARKS  which of its files of landmarks, such as landmarks5.txt; none: without; mirrored: before it, such
           as mirrored:landmarks12.txt: B is mirrored, so that landmarks are on the wrong sides
METHOD     FunctionalMap, ReversibleHarmonic, ReversibleHarmonicFromCells, GromovWasserstein,
           GromovWasserstein1000 (of so many samples), HeatKernel, BlendedIntrinsic, CommonSphere,
           CommonOrbifold, WeightedAverages, LandmarkCells; FunctionalMap or BlendedIntrinsic with
           ByVotes behind: landmarks found by MoebiusVotes; BlendedIntrinsicOfTriplets; or Given:
           FILE is read, a position on B for each point of A, and measured
FILE       else it is written: where each point of A goes; none: nothing is

One row: shape::CorrespondenceResult's facts, and errors along B over the root of its area, times
1000, from the truth, at all points of A or, of more than 6000, at 400, and the mean of those from its
mirror image, at 400, if it is known, else -1.)";

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
  const auto byVotes = [](Options::MethodType name)
  {
    Options options{ name };
    options.FindLandmarksBy = Options::FinderType::MoebiusVotes;
    return options;
  };
  Options triplets{ Options::MethodType::BlendedIntrinsic };
  triplets.Blended.CandidatesFrom = shape::BlendedIntrinsicOptions::CandidatesType::Triplets;
  const std::map<std::string, Options> known = {
    { "ReversibleHarmonic", {} },
    { "ReversibleHarmonicFromCells",
      { Options::MethodType::ReversibleHarmonic, Options::StartType::LandmarkCells } },
    { "FunctionalMap", { Options::MethodType::FunctionalMap } },
    { "GromovWasserstein", { Options::MethodType::GromovWasserstein } },
    { "GromovWasserstein1000", manySamples },
    { "HeatKernel", { Options::MethodType::HeatKernel } },
    { "BlendedIntrinsic", { Options::MethodType::BlendedIntrinsic } },
    { "BlendedIntrinsicOfTriplets", triplets },
    { "BlendedIntrinsicByVotes", byVotes(Options::MethodType::BlendedIntrinsic) },
    { "FunctionalMapByVotes", byVotes(Options::MethodType::FunctionalMap) },
    { "CommonSphere", { Options::MethodType::CommonSphere } },
    { "CommonOrbifold", { Options::MethodType::CommonOrbifold } },
    { "WeightedAverages", { Options::MethodType::WeightedAverages } },
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

benchmark::Row EvaluateErrors(const std::string& pair, const shape::Mesh& a, const shape::Mesh& b,
  const Eigen::MatrixXd& positions)
{
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
  return benchmark::Row()
    .Add("mean", thousand * errors.Mean)
    .Add("median", thousand * errors.Median)
    .Add("p95", thousand * errors.Percentile95)
    .Add("max", thousand * errors.Maximum)
    .Add("mirroredmean", mirrored);
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string pair = arguments.NextWord();
  std::string marks = arguments.NextWord();
  const std::string method = arguments.NextWord(), path = arguments.NextWord();
  arguments.RequireAllRead();

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
    figures.Print(EvaluateErrors(pair, a, b, ReadPositions(path)));
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
  figures.Print(benchmark::Row()
                  .Add("points", a.Points.rows())
                  .Add("pointsofb", b.Points.rows())
                  .Add(cost)
                  .Add("dirichlet", result.Facts.DirichletEnergy)
                  .Add("trip", result.Facts.RoundTrip)
                  .Add("reversed", result.Facts.ReversedArea)
                  .Add("found", result.Found)
                  .Add("distortion", result.Start.Distortion)
                  .Add("mirrored", result.Start.MirroredDistortion)
                  .Add("confidence", result.Start.Confidence)
                  .Add("iterations", result.Iterations)
                  .Add("part", static_cast<int>(result.Part.Which))
                  .Add("scale", result.Part.Scale)
                  .Add("share", result.Part.Share)
                  .Add("covered", result.Facts.CoverageOfB)
                  .Add("turned", result.Facts.Mirrored)
                  .Add("image", result.Start.MirrorImage)
                  .Append(EvaluateErrors(pair, a, b, positions)));
}

const benchmark::Entry Correspondence("correspondence", { Usage, Run });

} // namespace
