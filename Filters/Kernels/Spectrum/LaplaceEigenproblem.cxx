#include "Spectrum/LaplaceEigenproblem.h"

#include "Base/Errors.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/BlockLanczos.h"
#include "Linear/SparseSolve.h"
#include "Linear/SymmetricEigen.h"
#include "Mesh/SoundTriangles.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The eigenpairs of a connected surface without unused points.
class ComponentSpectrum
{
public:
  explicit ComponentSpectrum(const Surface& component)
    : Laplacian(GetIntrinsicLaplacian(component))
    , Shares(this->Masses() / this->Masses().sum())
  {
  }

  const Eigen::VectorXd& Masses() const { return this->Laplacian->Masses; } ///< n

  /// pairs: from 1 to the number of points.
  void Find(int pairs, double tolerance, const Progress& progress)
  {
    progress(0.0);
    constexpr int few = 600; // up to this many points, all eigenpairs are found as quickly
    const auto points = static_cast<int>(this->Masses().size());
    // The first pair is known: the constant function.
    this->Values = Eigen::VectorXd::Zero(1);
    this->Vectors = this->Shares.cwiseSqrt();
    if (points <= std::max(few, 3 * pairs))
    {
      this->FindDensely(pairs, progress);
    }
    else if (pairs > 1)
    {
      this->FindByLanczos(pairs, tolerance, progress);
    }
    progress(1.0);
  }

  /// k: >= 0, ascending, in 1 / length^2.
  Eigen::VectorXd Eigenvalues() const { return this->Values.cwiseMax(0.0) / this->Masses().sum(); }

  /// n x k: orthonormal with respect to the masses.
  Eigen::MatrixXd Eigenfunctions() const
  {
    return this->Masses().cwiseSqrt().cwiseInverse().asDiagonal() * this->Vectors;
  }

private:
  void FindDensely(int pairs, const Progress& progress)
  {
    // M^-1/2 L M^-1/2 has the same eigenvalues and is symmetric. Its smallest eigenvalues are the
    // largest of the negative matrix.
    const Eigen::VectorXd inverse = this->Shares.cwiseSqrt().cwiseInverse();
    const Eigenpairs found = FindLargestEigenpairs(
      -(inverse.asDiagonal() * Eigen::MatrixXd(this->Laplacian->Stiffness) * inverse.asDiagonal()),
      pairs, progress);
    this->Append(-found.Values.tail(pairs - 1), found.Vectors.rightCols(pairs - 1));
  }

  void FindByLanczos(int pairs, double tolerance, const Progress& progress)
  {
    constexpr double shift = 1.0; // less than the first eigenvalue, unless the surface has a neck
    // Shift and invert: the smallest eigenvalues lambda become the largest ones, 1 / (lambda +
    // shift).
    Eigen::SparseMatrix<double> shifted = this->Laplacian->Stiffness;
    shifted.diagonal() += shift * this->Shares;
    SparseCholesky factor;
    factor.Factorize(shifted, progress.Part(0.0, 0.1));
    const Eigen::VectorXd roots = this->Shares.cwiseSqrt();
    const Eigenpairs found =
      FindExtremeEigenpairs([&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd
        { return roots.asDiagonal() * factor.Solve(roots.asDiagonal() * columns); },
        this->Vectors, pairs - 1, progress.Part(0.1, 1.0), tolerance);
    this->Append(found.Values.cwiseInverse().array() - shift, found.Vectors);
  }

  /// Appends eigenpairs after the constant one, which is known.
  void Append(const Eigen::VectorXd& values, const Eigen::MatrixXd& vectors)
  {
    this->Values.conservativeResize(1 + values.size());
    this->Values.tail(values.size()) = values;
    this->Vectors.conservativeResize(Eigen::NoChange, 1 + vectors.cols());
    this->Vectors.rightCols(vectors.cols()) = vectors;
  }

  std::shared_ptr<const IntrinsicLaplacian> Laplacian;
  Eigen::VectorXd Shares;  ///< masses / total mass
  Eigen::VectorXd Values;  ///< k: eigenvalues for a total mass of 1
  Eigen::MatrixXd Vectors; ///< n x k: eigenfunctions times the square roots of Shares
};

/// One eigenpair of one component.
struct Position
{
  double Value;
  std::size_t Component;
  Eigen::Index Column;
};

std::vector<Position> InOrder(const std::vector<ComponentSpectrum>& parts)
{
  std::vector<Position> positions;
  for (std::size_t c = 0; c < parts.size(); ++c)
  {
    const Eigen::VectorXd values = parts[c].Eigenvalues();
    for (Eigen::Index k = 0; k < values.size(); ++k)
    {
      positions.push_back({ values(k), c, k });
    }
  }
  std::stable_sort(positions.begin(), positions.end(),
    [](const Position& a, const Position& b) { return a.Value < b.Value; });
  return positions;
}

/// Computes eigenpairs of each component, enough to include the smallest of all components.
std::vector<ComponentSpectrum> FindEnough(
  const std::vector<Surface>& components, int pairs, double tolerance, const Progress& progress)
{
  std::vector<ComponentSpectrum> parts(components.begin(), components.end());
  double area = 0.0;
  for (const ComponentSpectrum& part : parts)
  {
    area += part.Masses().sum();
  }
  // The number of eigenvalues below a bound is roughly proportional to the area (Weyl's law).
  std::vector<int> wanted, found(parts.size(), 0);
  for (const ComponentSpectrum& part : parts)
  {
    wanted.push_back(1 + static_cast<int>(std::ceil(pairs * part.Masses().sum() / area)));
  }
  double begin = 0.0;
  // A component has enough pairs if its largest eigenvalue is at least the largest one needed.
  // Otherwise the number of its pairs is doubled.
  while (found != wanted)
  {
    // The pairs of a single component are always enough.
    const double step =
      (parts.size() == 1 ? 1.0 : 0.5) * (1.0 - begin) / static_cast<double>(parts.size());
    for (std::size_t c = 0; c < parts.size(); ++c, begin += step)
    {
      wanted[c] = std::min({ wanted[c], pairs, static_cast<int>(parts[c].Masses().size()) });
      if (found[c] < wanted[c])
      {
        parts[c].Find(wanted[c], tolerance, progress.Part(begin, begin + step));
        found[c] = wanted[c];
      }
    }
    const std::vector<Position> positions = InOrder(parts);
    const double largest = static_cast<int>(positions.size()) < pairs
      ? std::numeric_limits<double>::infinity()
      : positions[pairs - 1].Value;
    for (std::size_t c = 0; c < parts.size(); ++c)
    {
      const int maximum = std::min(pairs, static_cast<int>(parts[c].Masses().size()));
      if (found[c] < maximum && parts[c].Eigenvalues().tail(1)(0) < largest)
      {
        wanted[c] = std::min(2 * found[c], maximum);
      }
    }
  }
  return parts;
}

/// Returns the components, each with the points that it uses, in order. A connected surface is
/// returned as it is, with its cached data.
std::vector<Surface> SplitIntoComponents(const Surface& surface, int used)
{
  if (surface.Topology().Components == 1 && used == surface.Points().rows())
  {
    return { surface };
  }
  const std::vector<Mesh> components = SplitComponents(surface);
  return { components.begin(), components.end() };
}

/// Returns the points of each component, in order.
std::vector<std::vector<int>> PointsOfComponents(const Topology& topology)
{
  std::vector<std::vector<int>> points(topology.Components);
  for (int i = 0; i < static_cast<int>(topology.ComponentId.size()); ++i)
  {
    if (topology.ComponentId(i) >= 0)
    {
      points[topology.ComponentId(i)].push_back(i);
    }
  }
  return points;
}

} // namespace

LaplaceEigenpairs SolveLaplaceEigenproblem(
  const Surface& surface, int pairs, const Progress& progress, double tolerance)
{
  progress(0.0);
  // Outline:
  // 1. Each component is solved separately, with enough pairs.
  // 2. The pairs of all components are sorted; the smallest are kept.
  // 3. The sign of each eigenfunction is made independent of the solver.
  const Topology topology = RequireTriangles(surface, "the surface");
  const auto used = static_cast<int>((topology.ComponentId.array() >= 0).count());
  if (pairs < 1 || pairs > used)
  {
    throw InvalidInput("NumberOfEigenpairs is " + std::to_string(pairs) +
      "; it must be at least 1 and at most the number of points that triangles use, " +
      std::to_string(used));
  }
  // Step 1: the pairs of each component.
  const std::vector<ComponentSpectrum> parts =
    FindEnough(SplitIntoComponents(surface, used), pairs, tolerance, progress.Part(0.0, 0.95));
  const std::vector<std::vector<int>> pointsOf = PointsOfComponents(topology);
  LaplaceEigenpairs spectrum;
  spectrum.Eigenvalues.resize(pairs);
  spectrum.Eigenfunctions = Eigen::MatrixXd::Zero(surface.Points().rows(), pairs);
  spectrum.Masses = Eigen::VectorXd::Zero(surface.Points().rows());
  std::vector<Eigen::MatrixXd> functions;
  for (std::size_t c = 0; c < parts.size(); ++c)
  {
    spectrum.Masses(pointsOf[c]) = parts[c].Masses();
    functions.push_back(parts[c].Eigenfunctions());
  }
  // Step 2: the smallest pairs.
  const std::vector<Position> positions = InOrder(parts);
  for (int k = 0; k < pairs; ++k)
  {
    progress(0.95 + 0.05 * k / pairs);
    const Position& position = positions[k];
    spectrum.Eigenvalues(k) = position.Value;
    spectrum.Eigenfunctions(pointsOf[position.Component], k) =
      functions[position.Component].col(position.Column);
  }
  // Step 3: the signs.
  FixSigns(spectrum.Eigenfunctions);
  progress(1.0);
  return spectrum;
}

} // namespace shape
