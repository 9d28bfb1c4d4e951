#include "Correspondence/Reversible/ReversibleHarmonic.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"
#include "Search/TriangleTree.h"
#include "Spectrum/Smacof.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace shape
{

namespace
{

double SquaredNorm(const Eigen::MatrixXd& rows, const Eigen::VectorXd& masses)
{
  return masses.dot(rows.rowwise().squaredNorm());
}

/// Weights of the terms in one iteration.
struct Weights
{
  double Alpha, Beta;
};

/// One of the two surfaces, its map onto the other one, and the variable X for its image.
class Side
{
public:
  Side(const EmbeddedSurface& given, SurfacePoints start)
    : Triangles(given.Surface.Triangles())
    , Embedding(given.Embedding)
    , Map(std::move(start))
  {
    const Eigen::Index points = given.Surface.Points().rows();
    const TriangleAngles angles = ComputeTriangleAngles(given.Surface);
    this->Stiffness = BuildPositiveStiffness(
      BuildCotangentStiffness(this->Triangles, angles.Cotangents, points), 0.0);
    this->Masses = ComputeLumpedMasses(this->Triangles, angles.Areas, points);
    this->Masses /= this->Masses.sum();
    this->FindEntries();
  }

  // The start of half-quadratic splitting: X12 = P12 X2, with which the penalty is 0.
  void Begin(const Side& other)
  {
    this->Image = PullBack(this->Map, other.Triangles, other.Embedding);
  }

  /// Pins points to their current images.
  void Pin(const std::vector<int>& points)
  {
    this->Pinned.assign(this->Masses.size(), 0);
    for (const int point : points)
    {
      this->Pinned[point] = 1;
    }
  }

  /// Updates P: the positions on the other surface nearest to this one's points.
  void Project(const Side& other, const Weights& weights, const Progress& progress)
  {
    const double reversibility = std::sqrt(1.0 - weights.Alpha), penalty = std::sqrt(weights.Beta);
    const Eigen::Index d = this->Embedding.cols();
    Eigen::MatrixXd from(this->Embedding.rows(), 2 * d), to(other.Embedding.rows(), 2 * d);
    // The two terms of the energy that contain P12 have one minimum for each point: the position of
    // the other surface nearest to the row [sqrt(1 - alpha) X1, sqrt(beta) X12] among the rows
    // [sqrt(1 - alpha) X21, sqrt(beta) X2].
    from << reversibility * this->Embedding, penalty * this->Image;
    to << reversibility * other.Image, penalty * other.Embedding;
    if (!this->Tree)
    {
      this->Tree.emplace(other.Triangles, to);
    }
    else
    {
      // The rows move only a little in each iteration, so the structure of the tree remains useful.
      this->Tree->Move(to);
    }
    constexpr int grain = 256;
    ParallelFor(
      static_cast<int>(from.rows()), grain,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          if (!this->Pinned.empty() && this->Pinned[i] != 0)
          {
            continue;
          }
          // The distance from the previous triangle is a bound that prunes most of the tree.
          const NearestTriangle nearest = this->Tree->Find(from.row(i), this->Map.Triangles(i));
          this->Map.Triangles(i) = nearest.Triangle;
          this->Map.Barycentrics.row(i) = nearest.Barycentric;
        }
      },
      progress);
    this->Positions = PullBack(this->Map, other.Triangles, other.Embedding);
  }

  /// Updates X: the minimum of the energy, which is quadratic in X.
  /// The system is symmetric and positive definite:
  ///
  ///   [alpha W1 + (1 - alpha) P21' M2 P21 + beta M1] X12
  ///     = (1 - alpha) P21' M2 X2 + beta M1 P12 X2
  void Solve(const Side& other, const Weights& weights, const Progress& progress)
  {
    Eigen::SparseMatrix<double> matrix = weights.Alpha * this->Stiffness;
    double* values = matrix.valuePtr();
    for (Eigen::Index i = 0; i < other.Masses.size(); ++i)
    {
      const int* entries = this->Entries.col(other.Map.Triangles(i)).data();
      const double weight = (1.0 - weights.Alpha) * other.Masses(i);
      for (int j = 0; j < 3; ++j)
      {
        for (int k = 0; k < 3; ++k)
        {
          values[entries[3 * j + k]] +=
            weight * other.Map.Barycentrics(i, j) * other.Map.Barycentrics(i, k);
        }
      }
    }
    // A point that no triangle uses has no mass; any number on the diagonal keeps it at 0.
    Eigen::VectorXd own = weights.Beta * this->Masses;
    for (Eigen::Index i = 0; i < own.size(); ++i)
    {
      if (!this->Pinned.empty() && this->Pinned[i] != 0)
      {
        // A pinned point is held by a strong penalty, which keeps the pattern of the matrix.
        own(i) += PinWeight;
      }
      matrix.coeffRef(i, i) += own(i) > 0.0 ? own(i) : 1.0;
    }
    this->Factor.Factorize(matrix, progress);
    this->Image = this->Factor.Solve((1.0 - weights.Alpha) *
        PushForward(other.Map, this->Triangles, other.Masses.asDiagonal() * other.Embedding,
          this->Masses.size()) +
      own.asDiagonal() * this->Positions);
  }

  /// This map's part of the energy.
  double Energy(const Side& other, const Weights& weights) const
  {
    return weights.Alpha * this->Image.cwiseProduct(this->Stiffness * this->Image).sum() +
      (1.0 - weights.Alpha) *
      SquaredNorm(
        PullBack(this->Map, other.Triangles, other.Image) - this->Embedding, this->Masses) +
      weights.Beta * SquaredNorm(this->Positions - this->Image, this->Masses);
  }

  const Eigen::MatrixXi& Triangles;
  const Eigen::MatrixXd& Embedding;
  Eigen::SparseMatrix<double> Stiffness;
  Eigen::VectorXd Masses;
  SurfacePoints Map;     ///< onto the other surface
  Eigen::MatrixXd Image; ///< n x d: X, near the images of points in the other's embedding

private:
  /// P' M P of the other's map only has entries between corners of triangles, as the stiffness has.
  /// So the pattern is fixed, and each system is assembled by adding to known entries.
  void FindEntries()
  {
    this->Entries.resize(9, this->Triangles.rows());
    const int *first = this->Stiffness.outerIndexPtr(), *inner = this->Stiffness.innerIndexPtr();
    for (Eigen::Index t = 0; t < this->Triangles.rows(); ++t)
    {
      for (int j = 0; j < 3; ++j)
      {
        const int column = this->Triangles(t, j);
        for (int k = 0; k < 3; ++k)
        {
          this->Entries(3 * j + k, t) =
            static_cast<int>(std::lower_bound(inner + first[column], inner + first[column + 1],
                               this->Triangles(t, k)) -
              inner);
        }
      }
    }
  }

  static constexpr double PinWeight = 1.0; ///< as much as the whole surface
  Eigen::MatrixXi Entries; ///< 9 x m: indices in the stiffness of each triangle's pairs of corners
  std::vector<char> Pinned;
  Eigen::MatrixXd Positions; ///< n x d: P12 X2
  SparseCholesky Factor;
  std::optional<TriangleTree> Tree; ///< of the other surface
};

/// Maps the points of landmarks to their partners and pins them there.
void Pin(Side& one, Side& two, const SurfaceMaps& partners, const Landmarks& landmarks)
{
  std::vector<int> ofA, ofB;
  for (std::size_t i = 0; i < landmarks.size(); ++i)
  {
    const auto [pointA, pointB] = landmarks[i];
    const auto row = static_cast<Eigen::Index>(i);
    one.Map.Triangles(pointA) = partners.AToB.Triangles(row);
    one.Map.Barycentrics.row(pointA) = partners.AToB.Barycentrics.row(row);
    two.Map.Triangles(pointB) = partners.BToA.Triangles(row);
    two.Map.Barycentrics.row(pointB) = partners.BToA.Barycentrics.row(row);
    ofA.push_back(pointA);
    ofB.push_back(pointB);
  }
  one.Pin(ofA);
  two.Pin(ofB);
}

SurfaceMaps Partners(const Surface& a, const Surface& b, const Landmarks& landmarks)
{
  Eigen::VectorXi onA(static_cast<Eigen::Index>(landmarks.size())), onB(onA.size());
  for (Eigen::Index i = 0; i < onA.size(); ++i)
  {
    onA(i) = landmarks[i][0];
    onB(i) = landmarks[i][1];
  }
  return { MakeSurfacePointsAtVertices(onB, b), MakeSurfacePointsAtVertices(onA, a) };
}

} // namespace

ReversibleHarmonicResult ComputeReversibleHarmonicMap(const Surface& a, const Surface& b,
  const SurfaceMaps& start, const Landmarks& landmarks, const ReversibleHarmonicOptions& options,
  const Progress& progress)
{
  const auto embedded = [&](const Surface& surface, const Progress& part)
  {
    return EmbeddedSurface{ surface,
      EmbedBySmacof(surface, options.Scaling, part) / std::sqrt(ComputePointAreas(surface).sum()) };
  };
  return ComputeReversibleHarmonicMap(
    embedded(a, progress.Part(0.0, 0.15, "embedding the surfaces")),
    embedded(b, progress.Part(0.15, 0.3)), start, landmarks, options,
    progress.Part(0.3, 1.0, "minimizing the reversible harmonic energy"));
}

// The alternating minimisation of section 5 of the paper, with weights that change in each
// iteration:
// 1. P21 by projection, then X21 by a linear system.
// 2. P12 by projection, then X12 by a linear system.
// 3. Stop when the energy no longer changes, but not before alpha has reached its final value.
ReversibleHarmonicResult ComputeReversibleHarmonicMap(const EmbeddedSurface& a,
  const EmbeddedSurface& b, const SurfaceMaps& start, const Landmarks& landmarks,
  const ReversibleHarmonicOptions& options, const Progress& progress)
{
  RequireOption(
    options.Alpha > 0.0 && options.Alpha < 1.0, "Alpha", options.Alpha, "between 0 and 1");
  RequireOption(options.FirstAlpha > 0.0 && options.FirstAlpha < 1.0, "FirstAlpha",
    options.FirstAlpha, "between 0 and 1");
  RequireOption(options.AlphaSteps >= 0, "AlphaSteps", options.AlphaSteps, "at least 0");
  RequireOption(options.BetaSteps >= 1, "BetaSteps", options.BetaSteps, "at least 1");
  RequireOption(options.Tolerance >= 0.0, "Tolerance", options.Tolerance, "at least 0");
  RequireOption(options.BetaStep > 0.0, "BetaStep", options.BetaStep, "positive");
  RequireOption(
    options.FirstIteration >= 1, "FirstIteration", options.FirstIteration, "at least 1");
  RequireOption(
    options.MaximumIterations >= 1, "MaximumIterations", options.MaximumIterations, "at least 1");
  Side one(a, start.AToB), two(b, start.BToA);
  if (options.PinLandmarks)
  {
    Pin(one, two, Partners(a.Surface, b.Surface, landmarks), landmarks);
  }
  one.Begin(two);
  two.Begin(one);
  ReversibleHarmonicResult result;
  for (int i = 0; i < options.MaximumIterations; ++i)
  {
    const int k = options.FirstIteration + i;
    const Progress part = progress.Part(
      static_cast<double>(i) / options.MaximumIterations, (i + 1.0) / options.MaximumIterations);
    // Geometric decrease from FirstAlpha to Alpha in AlphaSteps iterations.
    const double rest =
      options.AlphaSteps > 0 ? std::max(0.0, 1.0 - (k - 1.0) / options.AlphaSteps) : 0.0;
    const Weights weights{ options.Alpha * std::pow(options.FirstAlpha / options.Alpha, rest),
      options.BetaStep * std::min(k, options.BetaSteps) };
    // Each step uses the latest values of the others and so lowers the energy of this iteration.
    two.Project(one, weights, part.Part(0.0, 0.3));
    two.Solve(one, weights, part.Part(0.3, 0.5));
    one.Project(two, weights, part.Part(0.5, 0.8));
    one.Solve(two, weights, part.Part(0.8, 1.0));
    const double energy = one.Energy(two, weights) + two.Energy(one, weights);
    const double before = result.Energies.empty() ? 0.0 : result.Energies.back();
    result.Energies.push_back(energy);
    // While alpha changes, energies of two iterations are not comparable.
    if (i > 0 && k > options.AlphaSteps + 1 &&
      std::abs(before - energy) <= options.Tolerance * energy)
    {
      break;
    }
  }
  result.Maps = { std::move(one.Map), std::move(two.Map) };
  progress(1.0);
  return result;
}

namespace
{

EmbeddedSurface Embedded(
  const Surface& surface, const EmbeddedSamples& samples, const Progress& progress)
{
  return { surface,
    ExtendBiharmonically(surface, samples, progress) /
      std::sqrt(ComputePointAreas(surface).sum()) };
}

} // namespace

ReversibleHarmonicResult RefineReversibleHarmonicMap(const CoarsePair& pair,
  const SurfaceMaps& start, const Landmarks& landmarks, const ReversibleHarmonicOptions& options,
  const Progress& progress)
{
  EmbeddedSamples ofA = EmbedSamples(
                    pair.A(), options.Scaling, progress.Part(0.0, 0.1, "embedding the surfaces")),
                  ofB = EmbedSamples(pair.B(), options.Scaling, progress.Part(0.1, 0.2));
  const double share = pair.IsCoarser() ? 0.4 : 1.0;
  ReversibleHarmonicResult result =
    ComputeReversibleHarmonicMap(Embedded(pair.A(), ofA, progress.Part(0.2, 0.2)),
      Embedded(pair.B(), ofB, progress.Part(0.2, 0.2)), start, landmarks, options,
      progress.Part(0.2, share, "minimizing the reversible harmonic energy"));
  if (!pair.IsCoarser())
  {
    return result;
  }
  // Coarse points are points of the fine surface: the embedding of the samples is used again and
  // only extended to more points.
  for (int& point : ofA.Points)
  {
    point = pair.FinePointOfA(point);
  }
  for (int& point : ofB.Points)
  {
    point = pair.FinePointOfB(point);
  }
  // The last quarter of the steps in which alpha decreases: the maps are already smooth, and become
  // inverse to each other.
  ReversibleHarmonicOptions fine = options;
  const int quarter = std::max(1, options.AlphaSteps / 4);
  fine.FirstIteration = std::max(options.FirstIteration, options.AlphaSteps - quarter + 2);
  fine.MaximumIterations = std::min(quarter, options.MaximumIterations);
  const EmbeddedSurface fineA = Embedded(pair.FineA(), ofA, progress.Part(share, 0.45)),
                        fineB = Embedded(pair.FineB(), ofB, progress.Part(0.45, 0.5));
  result.Maps = ComputeReversibleHarmonicMap(fineA, fineB,
    pair.OnFine(result.Maps, progress.Part(0.5, 0.55, "interpolating the maps")),
    pair.OnFine(landmarks), fine,
    progress.Part(0.55, 1.0, "minimizing the energy on the given surfaces"))
                  .Maps;
  return result;
}

} // namespace shape
