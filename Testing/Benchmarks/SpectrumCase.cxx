// One measurement of the spectrum of a surface's Laplacian, in a process of its own: see Usage.
#include "BenchmarkData.h"
#include "Cost.h"

#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

namespace
{

constexpr const char* Usage = R"(spectrum_case MODEL PAIRS FILE

MODEL  an OFF file; points at the same position are joined, the longest side of its box is made 1
PAIRS  how many of the minimum eigenvalues
FILE   is written: the matrices that the pairs are of, as doubles: n, the n masses, the number of
       entries of the stiffness, their rows, columns and values

Prints one line: the seconds of a CPU and of the clock, the peak of memory above the start and the
worst |L f - lambda M f| / (lambda |M f|) of the pairs after the first.)";

void Write(const std::string& path, const Eigen::SparseMatrix<double>& stiffness,
  const Eigen::VectorXd& masses)
{
  std::ofstream file(path, std::ios::binary);
  const auto write = [&](double value)
  { file.write(reinterpret_cast<const char*>(&value), sizeof value); };
  write(static_cast<double>(masses.size()));
  std::for_each(masses.begin(), masses.end(), write);
  write(static_cast<double>(stiffness.nonZeros()));
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  const auto writeEach = [&](double (*part)(const Entry&))
  {
    for (Eigen::Index column = 0; column < stiffness.outerSize(); ++column)
    {
      for (Entry entry(stiffness, column); entry; ++entry)
      {
        write(part(entry));
      }
    }
  };
  writeEach([](const Entry& entry) { return static_cast<double>(entry.row()); });
  writeEach([](const Entry& entry) { return static_cast<double>(entry.col()); });
  writeEach([](const Entry& entry) { return entry.value(); });
}

void Run(const std::string& model, int pairs, const std::string& path)
{
  const shape::Mesh mesh = benchmark::ReadOff(model, true);
  shape::LaplaceEigenpairs spectrum;
  const benchmark::Cost cost =
    benchmark::Measure([&] { spectrum = shape::SolveLaplaceEigenproblem(mesh, pairs); });
  const shape::IntrinsicTriangles flat = shape::BuildIntrinsicDelaunay(mesh);
  const Eigen::SparseMatrix<double> stiffness = shape::BuildCotangentStiffness(
    flat.Triangles, shape::ComputeAnglesFromLengths(flat.Sides).Cotangents, mesh.Points.rows());
  Write(path, stiffness, spectrum.Masses);
  double worst = 0.0;
  for (int k = 1; k < pairs; ++k)
  {
    const Eigen::VectorXd function = spectrum.Eigenfunctions.col(k);
    const Eigen::VectorXd weighted =
      spectrum.Eigenvalues(k) * spectrum.Masses.cwiseProduct(function);
    worst = std::max(worst, (stiffness * function - weighted).norm() / weighted.norm());
  }
  std::printf(
    "points=%td pairs=%d cpu=%.2f wall=%.2f mib=%.0f residual=%.2g first=%.9g last=%.9g\n",
    mesh.Points.rows(), pairs, cost.Cpu, cost.Wall, cost.MiB, worst, spectrum.Eigenvalues(1),
    spectrum.Eigenvalues(pairs - 1));
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 4)
  {
    std::fputs(Usage, stderr);
    return 1;
  }
  try
  {
    Run(argv[1], std::stoi(argv[2]), argv[3]);
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s: %s\n", argv[1], problem.what());
    return 1;
  }
  return 0;
}
