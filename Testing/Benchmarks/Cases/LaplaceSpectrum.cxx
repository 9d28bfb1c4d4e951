// The spectrum of a surface's Laplacian.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace
{

constexpr const char* Usage = R"(MODEL PAIRS FILE

MODEL  an OFF file; points at the same position are joined, the longest side of its box is made 1
PAIRS  how many of the minimum eigenvalues
FILE   is written: the matrices that the pairs are of, as doubles: n, the n masses, the number of
       entries of the stiffness, their rows, columns and values

residual is the worst |L f - lambda M f| / (lambda |M f|) of the pairs after the first; first and last
are the first and the last positive eigenvalue.)";

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

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string model = arguments.NextWord();
  const int pairs = arguments.NextInteger();
  const std::string path = arguments.NextWord();
  arguments.RequireAllRead();

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
  figures.Print(benchmark::Row()
                  .Add("points", mesh.Points.rows())
                  .Add("pairs", pairs)
                  .Add(cost)
                  .Add("residual", worst)
                  .Add("first", spectrum.Eigenvalues(1))
                  .Add("last", spectrum.Eigenvalues(pairs - 1)));
}

const benchmark::Entry LaplaceSpectrum("laplace_spectrum", { Usage, Run });

} // namespace
