// A model remeshed, in a process of its own: see Usage.
#include "BenchmarkData.h"

#include "Remesh/IsotropicRemesh.h"

#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* Usage = R"(remesh_case MODEL EDGE ROUNDS ANGLE FILE

MODEL   a closed surface in OFF format; the longest side of its box is made 1, around the origin
EDGE    length of the new edges
ROUNDS  how often edges are split, collapsed and flipped
ANGLE   degrees from which a crease is kept
FILE    is written: the new surface in OFF format)";

void Write(const std::string& path, const shape::Mesh& mesh)
{
  std::ofstream file(path);
  file.precision(17);
  file << "OFF\n" << mesh.Points.rows() << ' ' << mesh.Triangles.rows() << " 0\n";
  for (const auto& point : mesh.Points.rowwise())
  {
    file << point << '\n';
  }
  for (const auto& triangle : mesh.Triangles.rowwise())
  {
    file << "3 " << triangle << '\n';
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
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
    shape::IsotropicRemeshOptions options;
    options.EdgeLength = std::stod(argv[2]);
    options.Rounds = std::stoi(argv[3]);
    options.CreaseAngle = std::stod(argv[4]);
    Write(argv[5], shape::RemeshIsotropically(benchmark::ReadOff(argv[1], false), options));
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s: %s\n", argv[1], problem.what());
    return 1;
  }
  return 0;
}
