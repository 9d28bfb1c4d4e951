// One measurement of hexahedra in a solid, in a process of its own: see Usage.
#include "BenchmarkData.h"
#include "CornerBound.h"
#include "Cost.h"

#include "Base/Errors.h"
#include "Hex/HexRemesh.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* Usage = R"(hex_case MODEL METHOD [CellSize=...] [MaximumHexahedra=...]

MODEL   an OFF file: a closed surface; points at the same position are joined
METHOD  Automatic, Polycube or Grid
CellSize: in hundredths of the diagonal of the surface's box

Prints one line. distance is the larger one-sided Hausdorff distance to the surface in percent of the
diagonal of its box, crease that between creases, share that of the creases' length that was looked
for, bound what the worst scaled Jacobian can be at the convex corners that are kept (CornerBound.h);
released counts points that need not be on the surface; euler and components are those of the
hexahedra's boundary, wanted those of the surface; MiB is the peak of memory above the start. Exits
with 2 where the surface cannot be read or is not closed, with 1 where no hexahedra are found.)";

shape::Mesh Read(const std::string& path)
{
  try
  {
    return benchmark::ReadOff(path, true);
  }
  catch (const std::runtime_error& problem)
  {
    throw shape::InvalidInput(problem.what());
  }
}

void Run(
  const std::string& path, const std::string& method, const shape::HexRemeshOptions& settings)
{
  using Method = shape::HexRemeshOptions::MethodType;
  const std::map<std::string, Method> methods = { { "Automatic", Method::Automatic },
    { "Polycube", Method::Polycube }, { "Grid", Method::Grid } };
  const shape::Mesh surface = Read(path);
  const shape::Topology wanted = shape::RequireClosedSurface(surface, path);
  const double diagonal = shape::ComputeBoxDiagonal(surface.Points);
  shape::HexRemeshOptions options = settings;
  options.Method = methods.at(method);
  options.CellSize *= 0.01 * diagonal;
  shape::HexRemeshResult result;
  const benchmark::Cost cost =
    benchmark::Measure([&] { result = shape::RemeshHexahedra(surface, options); });
  const shape::HexFit& fit = result.Fit;
  const shape::Topology found =
    shape::ComputeTopology({ fit.Solid.Points, shape::SplitQuads(fit.Quads) });
  std::printf(
    "vertices=%d method=%s hexes=%d min=%.4f mean=%.4f inverted=%d distance=%.4f "
    "patches=%d corners=%d cornerskept=%d creases=%d crease=%.4f share=%.3f bound=%.4f released=%d "
    "crossings=%d "
    "euler=%d wantedeuler=%d "
    "components=%d wantedcomponents=%d cpu=%.1f wall=%.1f mib=%.0f reason=%s\n",
    static_cast<int>(surface.Points.rows()), result.Method == Method::Grid ? "Grid" : "Polycube",
    static_cast<int>(fit.Solid.Hexahedra.rows()), fit.MinimumScaledJacobian, fit.MeanScaledJacobian,
    fit.Inverted, 100.0 * fit.Distance / diagonal, fit.PatchOf.maxCoeff() + 1,
    static_cast<int>(result.Features.Corners.size()),
    static_cast<int>(fit.Creases.CornerPoints.size()), fit.CreasesKept ? 1 : 0,
    100.0 * fit.Creases.Distance / diagonal, result.Features.CurveShare(),
    fit.CreasesKept ? benchmark::CornerBound(shape::OrientOutwards(surface), result.Features) : 1.0,
    fit.Released, result.Crossings, found.EulerNumber, wanted.EulerNumber, found.Components,
    wanted.Components, cost.Cpu, cost.Wall, cost.MiB, result.Reason.c_str());
}

} // namespace

int main(int count, char** words)
{
  try
  {
    if (count < 3)
    {
      throw std::runtime_error(Usage);
    }
    shape::HexRemeshOptions options;
    for (int i = 3; i < count; ++i)
    {
      const std::string word = words[i], key = word.substr(0, word.find('='));
      const double value = std::stod(word.substr(word.find('=') + 1));
      if (key == "CellSize")
      {
        options.CellSize = value;
      }
      else if (key == "MaximumHexahedra")
      {
        options.MaximumHexahedra = static_cast<int>(value);
      }
      else
      {
        throw std::runtime_error(Usage);
      }
    }
    Run(words[1], words[2], options);
    return 0;
  }
  catch (const shape::InvalidInput& problem)
  {
    std::fprintf(stderr, "%s\n", problem.what());
    return 2;
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
