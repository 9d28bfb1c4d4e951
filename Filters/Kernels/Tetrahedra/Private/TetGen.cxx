#include "Tetrahedra/Private/TetGen.h"

#include "Base/Errors.h"

#ifndef SHAPEMAP_TETGEN

namespace shape
{

TetGenOutput RunTetGen(const TetGenInput&, const Progress&)
{
  throw InvalidInput("ShapeMap was built without TetGen (SHAPEMAP_TETGEN=OFF); build it with "
                     "SHAPEMAP_TETGEN=ON");
}

} // namespace shape

#else

// The header defines terminatetetgen, which frees twice; the definition below replaces it.
#define TETLIBRARY
#define terminatetetgen terminatetetgenOfTheHeader
#include <tetgen.h>
#undef terminatetetgen

#include "Base/ChildProcess.h"

#include <algorithm>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstring>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace
{

/// In the child, the file descriptor for its messages; else -1.
int childPipe = -1;

/// The first message from the child: TetGen's exit code, 0 for success, and the size of the data
/// that follow.
struct Header
{
  int Code;
  int Points;
  int Tetrahedra;
  int Faces;
};

} // namespace

/// TetGen calls this when it gives up; the library's own definition is a weak symbol. In a process
/// that also uses TetGen otherwise, it behaves like TetGen's, but frees nothing.
// NOLINTNEXTLINE(readability-identifier-naming)
__attribute__((visibility("default"))) void terminatetetgen(tetgenmesh*, int code)
{
  if (childPipe == -1)
  {
    throw code;
  }
  const Header header{ code, 0, 0, 0 };
  shape::ChildProcess::Send(childPipe, &header, sizeof(header));
  _exit(0);
}

namespace shape
{
namespace
{

/// In the child: fills TetGen's structures, runs it and sends what it made.
void RunInChild(const TetGenInput& input, int pipe)
{
  childPipe = pipe;
  const auto seconds = static_cast<rlim_t>(input.MaximumSeconds);
  const rlimit time{ seconds, seconds + 1 };
  setrlimit(RLIMIT_CPU, &time);
  setlocale(LC_NUMERIC, "C"); // TetGen reads numbers
  const Mesh& mesh = input.Surfaces;
  tetgenio in, out;
  in.numberofpoints = static_cast<int>(mesh.Points.rows());
  in.pointlist = new double[3 * mesh.Points.rows()];
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      in.pointlist[3 * i + k] = mesh.Points(i, k);
    }
  }
  in.numberoffacets = static_cast<int>(mesh.Triangles.rows());
  in.facetlist = new tetgenio::facet[mesh.Triangles.rows()];
  in.facetmarkerlist = new int[mesh.Triangles.rows()];
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    tetgenio::facet& facet = in.facetlist[t];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    facet.polygonlist[0].numberofvertices = 3;
    facet.polygonlist[0].vertexlist =
      new int[3]{ mesh.Triangles(t, 0), mesh.Triangles(t, 1), mesh.Triangles(t, 2) };
    in.facetmarkerlist[t] = t + 1; // all different: else coplanar neighbours become one facet
  }
  in.numberofholes = static_cast<int>(input.Holes.rows());
  in.holelist = new double[std::max<Eigen::Index>(1, 3 * input.Holes.rows())];
  for (Eigen::Index i = 0; i < input.Holes.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      in.holelist[3 * i + k] = input.Holes(i, k);
    }
  }

  tetgenbehavior behavior;
  // p: a constrained tetrahedralisation of a surface; Q: quiet; Y: no new points on the boundary;
  // q: a bound on the ratio of radius to edge; a: one on the volume.
  std::string switches = "pQ";
  switches += input.PreserveBoundary ? "Y" : "";
  switches += input.MaximumRadiusEdgeRatio > 0.0 ? "q" : "";
  switches += input.MaximumVolume > 0.0 ? "a1" : "";
  behavior.parse_commandline(switches.data());
  if (input.MaximumRadiusEdgeRatio > 0.0)
  {
    behavior.minratio = input.MaximumRadiusEdgeRatio;
    behavior.mindihedral = 0.0;
  }
  if (input.MaximumVolume > 0.0)
  {
    behavior.maxvolume = input.MaximumVolume;
  }
  // By default it joins points closer than 1e-8 of the size, and takes that for flat.
  behavior.epsilon = 1e-14;
  behavior.steinerleft = input.MaximumNewPoints;
  try
  {
    tetrahedralize(&behavior, &in, &out);
  }
  catch (...)
  {
    terminatetetgen(nullptr, 1);
  }
  const Header header{ 0, out.numberofpoints, out.numberoftetrahedra, out.numberoftrifaces };
  ChildProcess::Send(pipe, &header, sizeof(header));
  ChildProcess::Send(pipe, out.pointlist, 3 * sizeof(double) * out.numberofpoints);
  ChildProcess::Send(pipe, out.tetrahedronlist, 4 * sizeof(int) * out.numberoftetrahedra);
  ChildProcess::Send(pipe, out.trifacelist, 3 * sizeof(int) * out.numberoftrifaces);
  _exit(0); // its memory goes with the process, not piece by piece
}

[[noreturn]] void ReportCode(int code)
{
  switch (code)
  {
    case 1:
      throw SolveFailure("TetGen ran out of memory; use a coarser input, a larger MaximumVolume or "
                         "a larger MaximumRadiusEdgeRatio");
    case 3:
      throw SolveFailure("TetGen treats parts of the surface as crossing, although they are only "
                         "close; move them apart, or remesh where triangles are thin");
    case 4:
      throw SolveFailure(
        "TetGen found a feature that is too small; use Clean with a tolerance above 0 to merge "
        "close points, or switch PreserveBoundary on");
    case 5:
      throw SolveFailure("TetGen found two facets too close to each other to put points on them; "
                         "switch PreserveBoundary on");
    case 10:
      throw InvalidInput("TetGen rejects the surface as invalid input; remove thin triangles and "
                         "merge points that nearly coincide");
    default:
      throw SolveFailure("TetGen met an internal error (code " + std::to_string(code) +
        "); remesh where triangles are thin, or change PreserveBoundary");
  }
}

[[noreturn]] void ReportEnd(int number, int seconds)
{
  if (number == SIGXCPU)
  {
    throw SolveFailure("TetGen did not end within " + std::to_string(seconds) +
      " seconds of processor time; remesh where triangles are thin, or change PreserveBoundary");
  }
  if (number == SIGKILL)
  {
    throw SolveFailure("TetGen's process was killed, probably because memory ran out; use "
                       "a coarser input or a larger MaximumVolume");
  }
  if (number == SIGABRT)
  {
    throw SolveFailure("TetGen stopped at an internal assertion; remesh where triangles are thin, "
                       "or change PreserveBoundary");
  }
  throw SolveFailure("TetGen crashed (" +
    (number > 0 ? std::string(strsignal(number)) : std::string("it ended without a result")) +
    "); remesh where triangles are thin, or change PreserveBoundary");
}

} // namespace

TetGenOutput RunTetGen(const TetGenInput& input, const Progress& progress)
{
  progress(0.0);
  ChildProcess child([&](int pipe) { RunInChild(input, pipe); });
  // TetGen does not say how far it is: half of it is done after the time that is usual.
  const double usual = 0.5 + 2e-5 * static_cast<double>(input.Surfaces.Triangles.rows());
  const auto start = std::chrono::steady_clock::now();
  const auto waiting = [&]
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    progress(seconds.count() / (seconds.count() + usual));
  };
  Header header{};
  if (!child.Receive(&header, sizeof(header), waiting))
  {
    ReportEnd(child.Signal(), input.MaximumSeconds);
  }
  if (header.Code != 0)
  {
    ReportCode(header.Code);
  }
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> points(header.Points, 3);
  Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor> tetrahedra(header.Tetrahedra, 4);
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> faces(header.Faces, 3);
  if (!child.Receive(points.data(), sizeof(double) * points.size(), waiting) ||
    !child.Receive(tetrahedra.data(), sizeof(int) * tetrahedra.size(), waiting) ||
    !child.Receive(faces.data(), sizeof(int) * faces.size(), waiting))
  {
    ReportEnd(child.Signal(), input.MaximumSeconds);
  }
  progress(1.0);
  return { points, tetrahedra, faces };
}

} // namespace shape

#endif
