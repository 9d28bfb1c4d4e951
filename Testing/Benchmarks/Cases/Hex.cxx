// Hexahedra in a solid.
#include "Cases/CornerBound.h"
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Hex/HexRemesh.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <map>
#include <string>

namespace
{

constexpr const char* Usage = R"(MODEL METHOD [CellSize=...] [MaximumHexahedra=...] [Draft=1]

MODEL   an OFF file: a closed surface; points at the same position are joined
METHOD  Automatic, Polycube or Grid
CellSize: in hundredths of the diagonal of the surface's box

distance is the larger one-sided Hausdorff distance to the surface in percent of the diagonal of its
box, crease that between creases, share that of the creases' length that was looked for, bound what
the worst scaled Jacobian can be at the convex corners that are kept (CornerBound.h); lost counts
creases that are not followed, also of patches too small to ask for, followed the curves that are;
released counts points that need not be on the surface; euler and components are those of the
hexahedra's boundary, wanted those of the surface.)";

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  using Method = shape::HexRemeshOptions::MethodType;
  const std::map<std::string, Method> methods = { { "Automatic", Method::Automatic },
    { "Polycube", Method::Polycube }, { "Grid", Method::Grid } };
  const std::string path = arguments.NextWord();
  shape::HexRemeshOptions options;
  options.Method = arguments.NextChoice(methods);
  const double cellSize = arguments.Setting("CellSize", options.CellSize);
  options.MaximumHexahedra = arguments.Setting("MaximumHexahedra", options.MaximumHexahedra);
  options.Draft = arguments.Setting("Draft", 0) != 0;
  arguments.RequireAllRead();

  const shape::Mesh surface = benchmark::ReadOff(path, true);
  const shape::Topology wanted = shape::RequireClosedSurface(surface, path);
  const double diagonal = shape::ComputeBoxDiagonal(surface.Points);
  options.CellSize = 0.01 * diagonal * cellSize;
  shape::HexRemeshResult result;
  const benchmark::Cost cost =
    benchmark::Measure([&] { result = shape::RemeshHexahedra(surface, options); });
  const shape::HexFit& fit = result.Fit;
  const shape::Topology found =
    shape::ComputeTopology({ fit.Solid.Points, shape::SplitQuads(fit.Quads) });
  const double bound =
    fit.CreasesKept ? benchmark::CornerBound(shape::OrientOutwards(surface), result.Features) : 1.0;
  figures.Print(benchmark::Row()
                  .Add("vertices", surface.Points.rows())
                  .Add("method", std::string(result.Method == Method::Grid ? "Grid" : "Polycube"))
                  .Add("hexes", fit.Solid.Hexahedra.rows())
                  .Add("min", fit.MinimumScaledJacobian)
                  .Add("mean", fit.MeanScaledJacobian)
                  .Add("inverted", fit.Inverted)
                  .Add("distance", 100.0 * fit.Distance / diagonal)
                  .Add("patches", fit.PatchOf.maxCoeff() + 1)
                  .Add("corners", result.Features.Corners.size())
                  .Add("cornerskept", fit.Creases.CornerPoints.size())
                  .Add("creases", fit.CreasesKept)
                  .Add("lost", result.LostCreases.size())
                  .Add("followed", fit.Followed.size())
                  .Add("crease", 100.0 * fit.Creases.Distance / diagonal)
                  .Add("share", result.Features.CurveShare())
                  .Add("bound", bound)
                  .Add("released", fit.Released)
                  .Add("crossings", result.Crossings)
                  .Add("euler", found.EulerNumber)
                  .Add("wantedeuler", wanted.EulerNumber)
                  .Add("components", found.Components)
                  .Add("wantedcomponents", wanted.Components)
                  .Add(cost)
                  .Add("reason", result.Reason));
}

const benchmark::Entry Hex("hex", { Usage, Run });

} // namespace
