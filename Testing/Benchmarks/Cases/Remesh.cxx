// A model remeshed.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Remesh/IsotropicRemesh.h"

#include <fstream>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* Usage = R"(MODEL EDGE ROUNDS ANGLE FILE

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

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string model = arguments.NextWord();
  shape::IsotropicRemeshOptions options;
  options.EdgeLength = arguments.NextNumber();
  options.Rounds = arguments.NextInteger();
  options.CreaseAngle = arguments.NextNumber();
  const std::string path = arguments.NextWord();
  arguments.RequireAllRead();

  const shape::Mesh surface = benchmark::ReadOff(model, false);
  shape::Mesh remeshed;
  const benchmark::Cost cost =
    benchmark::Measure([&] { remeshed = shape::RemeshIsotropically(surface, options); });
  Write(path, remeshed);
  figures.Print(benchmark::Row()
                  .Add("points", remeshed.Points.rows())
                  .Add("triangles", remeshed.Triangles.rows())
                  .Add(cost));
}

const benchmark::Entry Remesh("remesh", { Usage, Run });

} // namespace
