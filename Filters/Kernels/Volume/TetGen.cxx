#include "Volume/TetGen.h"

#include "Core/Errors.h"

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

// The header defines terminatetetgen, which frees twice: ours, below, takes its place.
#define TETLIBRARY
#define terminatetetgen terminatetetgenOfTheHeader
#include <tetgen.h>
#undef terminatetetgen

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <poll.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace
{

/// In the child, where its messages go; else -1.
int ChildPipe = -1;

/// Writes all of it, or ends the child: nobody listens any more.
void Send(const void* data, std::size_t size)
{
  const char* at = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t sent = write(ChildPipe, at, size);
    if (sent < 0 && errno != EINTR)
    {
      _exit(1);
    }
    at += std::max<ssize_t>(sent, 0);
    size -= std::max<ssize_t>(sent, 0);
  }
}

/// The first thing that a child sends: TetGen's exit code, 0 where it succeeded, and then how much
/// follows.
struct Header
{
  int Code;
  int Points;
  int Tetrahedra;
  int Faces;
};

} // namespace

/// What TetGen calls when it gives up; the library's own is a weak symbol. In a process that uses
/// TetGen beside ShapeMap it does what TetGen's does, without freeing anything.
__attribute__((visibility("default"))) void terminatetetgen(tetgenmesh*, int code)
{
  if (ChildPipe == -1)
  {
    throw code;
  }
  const Header header{ code, 0, 0, 0 };
  Send(&header, sizeof(header));
  _exit(0);
}

namespace shape
{
namespace
{

/// The child: fills TetGen's structures, runs it and sends what it made. Never returns.
[[noreturn]] void RunChild(const TetGenInput& input)
{
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
  Send(&header, sizeof(header));
  Send(out.pointlist, 3 * sizeof(double) * out.numberofpoints);
  Send(out.tetrahedronlist, 4 * sizeof(int) * out.numberoftetrahedra);
  Send(out.trifacelist, 3 * sizeof(int) * out.numberoftrifaces);
  _exit(0);
}

/// Makes a fork a process of its own: no handlers, files, output or core dumps of its parent's, and
/// no life after it.
void Detach(pid_t parent, int pipeEnd)
{
  for (int number = 1; number < NSIG; ++number)
  {
    signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent)
  {
    _exit(1);
  }
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  // TetGen prints even when told to be quiet. What this process had not yet printed is its parent's
  // to print.
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int standard : { 0, 1, 2 })
  {
    dup2(nowhere, standard);
  }
  ChildPipe = dup2(pipeEnd, 3);
  rlimit files{ 0, 0 };
  getrlimit(RLIMIT_NOFILE, &files);
  for (int file = 4; file < static_cast<int>(std::min<rlim_t>(files.rlim_cur, 65536)); ++file)
  {
    close(file);
  }
  setlocale(LC_NUMERIC, "C"); // TetGen reads numbers
}

/// The child as its parent sees it; ends it when going out of scope.
class Child
{
public:
  explicit Child(const TetGenInput& input)
  {
    int ends[2];
    if (pipe(ends) != 0)
    {
      throw SolveFailure(std::string("cannot make a pipe to TetGen: ") + std::strerror(errno) +
        "; close some files");
    }
    for (const int end : ends)
    {
      fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    // Signals wait until the child has let go of this process's handlers.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const pid_t parent = getpid();
    this->Id = fork();
    if (this->Id == 0)
    {
      Detach(parent, ends[1]);
      RunChild(input);
    }
    const int error = errno;
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    close(ends[1]);
    this->Pipe = ends[0];
    fcntl(this->Pipe, F_SETFL, O_NONBLOCK);
    if (this->Id < 0)
    {
      close(this->Pipe);
      throw SolveFailure(std::string("cannot start a process for TetGen: ") + std::strerror(error) +
        "; free some memory");
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child()
  {
    close(this->Pipe);
    if (!this->Ended)
    {
      kill(this->Id, SIGKILL);
      int status = 0;
      while (waitpid(this->Id, &status, 0) < 0 && errno == EINTR)
      {
      }
    }
  }

  /// Reads `size` bytes. Returns false where the child ended before it sent them.
  bool Receive(void* data, std::size_t size, const std::function<void()>& waiting)
  {
    char* at = static_cast<char*>(data);
    while (size > 0)
    {
      const ssize_t got = read(this->Pipe, at, size);
      if (got > 0)
      {
        at += got;
        size -= got;
      }
      else if (got < 0 && errno == EINTR)
      {
        continue;
      }
      else if (this->Ended || (got < 0 && errno != EAGAIN))
      {
        return false;
      }
      else
      {
        waiting();
        // Whether it has ended is asked first and the pipe read once more: another process may hold
        // the pipe's other end open.
        this->Wait(got == 0);
        pollfd waitFor{ this->Pipe, POLLIN, 0 };
        poll(&waitFor, 1, this->Ended ? 0 : 100);
      }
    }
    return true;
  }

  /// The signal that ended the child, or 0.
  int Signal() const { return WIFSIGNALED(this->Status) ? WTERMSIG(this->Status) : 0; }

private:
  void Wait(bool block)
  {
    const pid_t ended = waitpid(this->Id, &this->Status, block ? 0 : WNOHANG);
    // Where somebody else took the child's status, it has ended, too.
    this->Ended = ended == this->Id || (ended < 0 && errno == ECHILD);
  }

  pid_t Id = -1;
  int Pipe = -1;
  int Status = 0;
  bool Ended = false;
};

[[noreturn]] void ReportCode(int code)
{
  switch (code)
  {
    case 1:
      throw SolveFailure("TetGen ran out of memory; use a coarser input, a larger MaximumVolume or "
                         "a larger MaximumRadiusEdgeRatio");
    case 3:
      throw SolveFailure("TetGen takes parts of the surface for crossing, although they only come "
                         "close; move them apart, or remesh where triangles are thin");
    case 4:
      throw SolveFailure("TetGen found a feature too small for it; merge close points with Clean "
                         "(a tolerance above 0), or switch PreserveBoundary on");
    case 5:
      throw SolveFailure("TetGen found two facets too close to each other to put points on them; "
                         "switch PreserveBoundary on");
    case 10:
      throw InvalidInput("TetGen refuses the surface as an input error; look for thin triangles "
                         "and points that nearly coincide");
    default:
      throw SolveFailure("TetGen met an internal error (code " + std::to_string(code) +
        "); remesh where triangles are thin, or change PreserveBoundary");
  }
}

[[noreturn]] void ReportEnd(int number)
{
  if (number == SIGKILL)
  {
    throw SolveFailure("TetGen's process was killed, as the system does where memory runs out; use "
                       "a coarser input or a larger MaximumVolume");
  }
  if (number == SIGABRT)
  {
    throw SolveFailure(
      "TetGen stopped at an assertion of its own; remesh where triangles are thin, "
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
  Child child(input);
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
    ReportEnd(child.Signal());
  }
  if (header.Code != 0)
  {
    ReportCode(header.Code);
  }
  constexpr int RowMajor = Eigen::RowMajor;
  Eigen::Matrix<double, Eigen::Dynamic, 3, RowMajor> points(header.Points, 3);
  Eigen::Matrix<int, Eigen::Dynamic, 4, RowMajor> tetrahedra(header.Tetrahedra, 4);
  Eigen::Matrix<int, Eigen::Dynamic, 3, RowMajor> faces(header.Faces, 3);
  if (!child.Receive(points.data(), sizeof(double) * points.size(), waiting) ||
    !child.Receive(tetrahedra.data(), sizeof(int) * tetrahedra.size(), waiting) ||
    !child.Receive(faces.data(), sizeof(int) * faces.size(), waiting))
  {
    ReportEnd(child.Signal());
  }
  progress(1.0);
  return { points, tetrahedra, faces };
}

} // namespace shape

#endif
