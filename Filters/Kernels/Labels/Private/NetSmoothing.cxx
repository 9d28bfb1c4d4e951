#include "Labels/Private/NetSmoothing.h"

#include "Base/Parallel.h"
#include "Labels/Private/JunctionFit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

constexpr int Grain = 8192;
/// The solver ends when the residual is at most this fraction of the first one.
constexpr double SolverTolerance = 1e-3;
constexpr int MaximumIterations = 400;
/// Number of times that points at the border of their cells are fixed and the others smoothed.
constexpr int Rounds = 3;
/// The wavelength of the first solution, in voxels, whose normals the others use.
constexpr double FirstWavelength = 8.0;
/// Weight of a curve's rows of L, because a curve has fewer positions to average than an interface:
/// its wavelength is 1.4 times that of the interfaces.
constexpr double CurveStiffness = 4.0;
/// Weight of |x - x0|^2 on a curve, between its ends. The mean of the crossings in a cube with
/// three labels lies beside the curve, unless all angles there are equal. The interfaces know
/// better.
constexpr double CurveData = 0.5;
/// Number of times that curves and their ends move to where the interfaces meet (FitJunctions).
constexpr int Fits = 2;
/// Weight of |x - x0|^2 there, where x0 is what FitJunctions returns.
constexpr double FittedData = 2.0;

using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The matrix L and its transpose.
class NetLaplacian
{
public:
  explicit NetLaplacian(const SurfaceNet& net)
    : First(net.Points.rows() + 1, 0)
    , Uses(net.Points.rows(), 0)
  {
    const auto size = static_cast<std::size_t>(net.Points.rows());
    std::vector<int> junctionEdges(size, 0);
    for (const NetEdge& edge : net.Edges)
    {
      junctionEdges[edge.First] += edge.IsOnJunction;
      junctionEdges[edge.Second] += edge.IsOnJunction;
    }
    this->IsOnCurve.resize(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->IsOnCurve[i] = junctionEdges[i] > 0;
      this->Uses[i] = junctionEdges[i] == 0 || junctionEdges[i] == 2;
    }
    for (const NetEdge& edge : net.Edges)
    {
      ++this->First[edge.First + 1];
      ++this->First[edge.Second + 1];
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      this->First[i + 1] += this->First[i];
    }
    this->Neighbours.resize(this->First[size]);
    std::vector<int> next(this->First.begin(), this->First.end() - 1);
    for (const NetEdge& edge : net.Edges)
    {
      this->Neighbours[next[edge.First]++] = edge.Second;
      this->Neighbours[next[edge.Second]++] = edge.First;
    }
    // On a curve, the neighbours on the curve come first.
    this->Last.resize(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Last[i] = this->First[i + 1];
    }
    std::vector<std::vector<int>> onCurve(size);
    for (const NetEdge& edge : net.Edges)
    {
      if (edge.IsOnJunction)
      {
        onCurve[edge.First].push_back(edge.Second);
        onCurve[edge.Second].push_back(edge.First);
      }
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      if (!this->IsOnCurve[i])
      {
        continue;
      }
      const auto begin = this->Neighbours.begin() + this->First[i];
      const auto end = this->Neighbours.begin() + this->First[i + 1];
      const auto middle = std::stable_partition(begin, end,
        [&](int j)
        { return std::find(onCurve[i].begin(), onCurve[i].end(), j) != onCurve[i].end(); });
      this->Last[i] =
        this->Uses[i] ? static_cast<int>(middle - this->Neighbours.begin()) : this->First[i];
    }
  }

  /// Sets row i of the result to finish(i, row i of L x).
  template <typename Finish>
  void Apply(const Positions& x, Positions& result, const Finish& finish) const
  {
    const auto apply = [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (int k = this->First[i]; k < this->Last[i]; ++k)
        {
          sum += x.row(i) - x.row(this->Neighbours[k]);
        }
        result.row(i) = finish(i, sum);
      }
    };
    ParallelFor(static_cast<int>(x.rows()), Grain, apply);
  }

  /// The same with L^T y. Row j of L contains i if i is a neighbour that row j counts.
  template <typename Finish>
  void ApplyTransposed(const Positions& y, Positions& result, const Finish& finish) const
  {
    const auto apply = [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        Eigen::RowVector3d sum = (this->Last[i] - this->First[i]) * y.row(i);
        for (int k = this->First[i]; k < this->First[i + 1]; ++k)
        {
          const int j = this->Neighbours[k];
          // A curve's row counts only the neighbours on the curve, which come first.
          if (!this->IsOnCurve[j] || (this->Uses[j] && this->Counts(j, i)))
          {
            sum -= y.row(j);
          }
        }
        result.row(i) = finish(i, sum);
      }
    };
    ParallelFor(static_cast<int>(y.rows()), Grain, apply);
  }

  /// The weight of |x - x0|^2 at a point. areFitted: whether x0 is fitted on curves.
  double DataWeight(int i, bool areFitted) const
  {
    return !this->IsOnCurve[i] ? 1.0 : areFitted ? FittedData : this->Uses[i] ? CurveData : 1.0;
  }
  /// The weight of a row.
  double RowWeight(int i) const { return this->IsOnCurve[i] ? CurveStiffness : 1.0; }

  bool IsJunction(int i) const { return this->IsOnCurve[i] != 0; }
  /// A vector along the curve; zero at the end of a curve or where curves meet.
  Eigen::RowVector3d Tangent(int i, const Positions& x) const
  {
    if (this->Last[i] - this->First[i] != 2)
    {
      return Eigen::RowVector3d::Zero();
    }
    return x.row(this->Neighbours[this->First[i]]) - x.row(this->Neighbours[this->First[i] + 1]);
  }

  double MeanSquaredLength(int i, const Positions& x) const
  {
    double sum = 0.0;
    for (int k = this->First[i]; k < this->Last[i]; ++k)
    {
      sum += (x.row(i) - x.row(this->Neighbours[k])).squaredNorm();
    }
    return std::max(sum / (this->IsJunction(i) ? 2.0 : 4.0), 1e-3);
  }

private:
  bool Counts(int row, int neighbour) const
  {
    return std::find(this->Neighbours.begin() + this->First[row],
             this->Neighbours.begin() + this->Last[row],
             neighbour) != this->Neighbours.begin() + this->Last[row];
  }

  std::vector<int> First, Last, Neighbours;
  std::vector<char> Uses, IsOnCurve;
};

/// The normal of the surface at a point, or the tangent of a curve.
struct Direction
{
  Eigen::RowVector3d Axis = Eigen::RowVector3d::Zero();
  bool IsNormal = true;
  /// The mean of the squared lengths of the edges. With it, the energy is the same at all points of
  /// a sphere, whatever their distances: its gradient vanishes nearly.
  double Mass = 1.0;

  /// The part of a vector that is normal to the surface or the curve.
  Eigen::RowVector3d Across(const Eigen::RowVector3d& vector) const
  {
    const Eigen::RowVector3d along = vector.dot(this->Axis) * this->Axis;
    return this->IsNormal ? along : Eigen::RowVector3d(vector - along);
  }
};

std::vector<Direction> FindDirections(
  const SurfaceNet& net, const NetLaplacian& laplacian, const Positions& x)
{
  std::vector<Direction> directions(x.rows());
  for (Eigen::Index t = 0; t < net.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = net.Triangles.row(t);
    const Eigen::RowVector3d area =
      (x.row(corners(1)) - x.row(corners(0))).cross(x.row(corners(2)) - x.row(corners(0)));
    for (const int corner : corners)
    {
      directions[corner].Axis += area;
    }
  }
  for (int i = 0; i < static_cast<int>(x.rows()); ++i)
  {
    if (laplacian.IsJunction(i))
    {
      directions[i].Axis = laplacian.Tangent(i, x);
      directions[i].IsNormal = false;
    }
    directions[i].Axis.normalize();
    directions[i].Mass = laplacian.MeanSquaredLength(i, x);
  }
  return directions;
}

/// The positions x0 of an energy.
struct Data
{
  Positions Given;
  bool AreJunctionsFitted = false; ///< whether those on curves come from FitJunctions
};

/// Minimises the energy by conjugate gradients, from x, until the squared norm of the residual has
/// decreased by SolverTolerance squared from that at the begin, or from `largest` if that is
/// greater. Returns the squared norm at the begin. directions: the parts of L x across them count,
/// or all of it.
double Solve(const NetLaplacian& laplacian, const std::vector<Direction>* directions,
  const Data& data, double wavelength, const std::vector<char>& isFixed, double largest,
  Positions& x, const Progress& progress)
{
  const double weight = std::pow(wavelength / (2.0 * EIGEN_PI), 4);
  const int size = static_cast<int>(x.rows());
  Positions inner(size, 3), outer(size, 3);
  const auto across = [&](int i, const Eigen::RowVector3d& vector)
  { return directions ? (*directions)[i].Across(vector) : vector; };
  const auto weightOf = [&](int i) { return laplacian.DataWeight(i, data.AreJunctionsFitted); };
  const auto apply = [&](const Positions& v)
  {
    laplacian.Apply(v, inner,
      [&](int i, const Eigen::RowVector3d& sum) -> Eigen::RowVector3d {
        return across(i, laplacian.RowWeight(i) * sum) / (directions ? (*directions)[i].Mass : 1.0);
      });
    laplacian.ApplyTransposed(inner, outer,
      [&](int i, const Eigen::RowVector3d& sum) -> Eigen::RowVector3d
      { return across(i, weightOf(i) * v.row(i) + weight * sum); });
  };
  const auto clear = [&](Positions& v)
  {
    for (std::size_t i = 0; i < isFixed.size(); ++i)
    {
      if (isFixed[i])
      {
        v.row(static_cast<Eigen::Index>(i)).setZero();
      }
    }
  };
  apply(x);
  Positions residual(size, 3);
  for (int i = 0; i < size; ++i)
  {
    residual.row(i) = across(i, weightOf(i) * data.Given.row(i));
  }
  residual -= outer;
  clear(residual);
  Positions direction = residual;
  double square = residual.squaredNorm();
  const double first = square;
  const double limit = std::max(first, largest) * SolverTolerance * SolverTolerance;
  for (int iteration = 0; iteration < MaximumIterations && square > limit; ++iteration)
  {
    apply(direction);
    clear(outer);
    const double step = square / direction.cwiseProduct(outer).sum();
    x += step * direction;
    residual -= step * outer;
    const double before = square;
    square = residual.squaredNorm();
    direction = residual + (square / before) * direction;
    progress(static_cast<double>(iteration) / MaximumIterations);
  }
  return first;
}

/// Moves points back into their cells, and marks them. Returns whether there were any.
bool Confine(const SurfaceNet& net, Positions& x, std::vector<char>* isFixed = nullptr)
{
  bool isAnyOutside = false;
  for (Eigen::Index i = 0; i < x.rows(); ++i)
  {
    const Eigen::RowVector3d centre = net.Centres.row(i);
    const Eigen::RowVector3d offset = x.row(i) - centre;
    const Eigen::RowVector3d within = offset.cwiseMax(-net.Reach(i)).cwiseMin(net.Reach(i));
    if (offset != within)
    {
      x.row(i) = centre + within;
      isAnyOutside = true;
      if (isFixed)
      {
        (*isFixed)[i] = 1;
      }
    }
  }
  return isAnyOutside;
}

} // namespace

void SmoothNet(SurfaceNet& net, double wavelength, const Progress& progress)
{
  const int size = static_cast<int>(net.Points.rows());
  if (wavelength <= 0.0 || size == 0)
  {
    return;
  }
  const NetLaplacian laplacian(net);
  Positions target = net.Points;
  Positions x = target;
  constexpr int solutions = 1 + Rounds * (Fits + 1);
  const auto part = [&](int solution)
  { return progress.Part(double(solution) / solutions, (solution + 1.0) / solutions); };
  Solve(laplacian, nullptr, { target }, std::min(wavelength, FirstWavelength), {}, 0.0, x, part(0));
  Confine(net, x);
  std::vector<char> isFixed(size, 0);
  double largest = 0.0; // squared norm of a residual: later solutions start close to their end
  // The target's positions across the surface, those of the solution before along it.
  const auto solve = [&](bool areJunctionsFitted, const Progress& ofSolution)
  {
    const std::vector<Direction> directions = FindDirections(net, laplacian, x);
    Data data = { x, areJunctionsFitted };
    for (int i = 0; i < size; ++i)
    {
      data.Given.row(i) += directions[i].Across(target.row(i) - x.row(i));
    }
    largest = std::max(
      largest, Solve(laplacian, &directions, data, wavelength, isFixed, largest, x, ofSolution));
    return Confine(net, x, &isFixed);
  };
  const int fits = net.JunctionPoints.empty() ? 0 : Fits;
  for (int fit = 0; fit <= fits; ++fit)
  {
    if (fit > 0)
    {
      const Eigen::MatrixXd fitted = FitJunctions(net, x);
      for (std::size_t i = 0; i < net.JunctionPoints.size(); ++i)
      {
        target.row(net.JunctionPoints[i]) = fitted.row(static_cast<Eigen::Index>(i));
      }
      std::fill(isFixed.begin(), isFixed.end(), 0);
    }
    for (int round = 0; round < Rounds; ++round)
    {
      if (!solve(fit > 0, part(1 + fit * Rounds + round)))
      {
        break;
      }
    }
  }
  net.Points = x;
}

} // namespace shape
