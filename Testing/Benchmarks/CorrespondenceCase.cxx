// One map between two surfaces, in a process of its own: see Usage.
#include "BenchmarkData.h"
#include "Cost.h"

#include "Correspondence/FunctionalMap.h"
#include "Correspondence/LandmarkCells.h"
#include "Correspondence/ReversibleHarmonic.h"

#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* Usage = R"(correspondence_case A B LANDMARKS METHOD FOLDER

A, B       OFF files of the two surfaces
LANDMARKS  a file of lines that start with a point of A and one of B, from 0; may be empty
METHOD     FunctionalMap, LandmarkCells, ReversibleHarmonic (from LandmarkCells), ReversibleHarmonicFromFunctionalMap
FOLDER     is written: AToB.txt and BToA.txt, a line for each point: the corners of the triangle
           that it goes to, and their weights

Prints one line: the seconds of a CPU and of the clock and the peak of memory above the start.)";

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

void Write(
  const std::string& path, const shape::PreciseMap& map, const Eigen::MatrixXi& triangles)
{
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr)
  {
    throw std::runtime_error(path + " cannot be written");
  }
  for (Eigen::Index i = 0; i < map.Triangles.size(); ++i)
  {
    const Eigen::RowVector3i corners = triangles.row(map.Triangles(i));
    const Eigen::RowVector3d weights = map.Barycentrics.row(i);
    std::fprintf(file, "%d %d %d %.17g %.17g %.17g\n", corners(0), corners(1), corners(2),
      weights(0), weights(1), weights(2));
  }
  std::fclose(file);
}

shape::SurfaceMaps Find(const std::string& method, const shape::Mesh& a, const shape::Mesh& b,
  const shape::Landmarks& landmarks)
{
  if (method == "FunctionalMap")
  {
    return shape::FunctionalMap(a, b, landmarks);
  }
  if (method == "LandmarkCells")
  {
    return shape::LandmarkCells(a, b, landmarks);
  }
  if (method == "ReversibleHarmonic")
  {
    return shape::ReversibleHarmonic(a, b, shape::LandmarkCells(a, b, landmarks), landmarks).Maps;
  }
  if (method == "ReversibleHarmonicFromFunctionalMap")
  {
    return shape::ReversibleHarmonic(a, b, shape::FunctionalMap(a, b, landmarks), landmarks).Maps;
  }
  throw std::invalid_argument("there is no method " + method);
}

void Run(char** arguments)
{
  const shape::Mesh a = benchmark::ReadOff(arguments[1], false),
                    b = benchmark::ReadOff(arguments[2], false);
  const shape::Landmarks landmarks = ReadLandmarks(arguments[3]);
  const std::string method = arguments[4], folder = arguments[5];
  shape::SurfaceMaps maps;
  const benchmark::Cost cost = benchmark::Measure([&] { maps = Find(method, a, b, landmarks); });
  Write(folder + "/AToB.txt", maps.AToB, b.Triangles);
  Write(folder + "/BToA.txt", maps.BToA, a.Triangles);
  std::printf("points=%td,%td cpu=%.2f wall=%.2f mib=%.0f\n", a.Points.rows(), b.Points.rows(),
    cost.Cpu, cost.Wall, cost.MiB);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 6)
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
    std::fprintf(stderr, "%s, %s: %s\n", argv[1], argv[2], problem.what());
    return 1;
  }
  return 0;
}
