#include "Hex/Polycube/Private/AxisAlignment.h"

#include "Base/Parallel.h"
#include "Geometry/FitRotation.h"
#include "Geometry/HaltonSequence.h"
#include "Geometry/RotationVector.h"
#include "Linear/SparseSolve.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

/// Samples of the search for the best rotation; the best one is refined.
constexpr int RotationTrials = 400;
/// A rotation that gains less is not worth new axes: the given ones stay.
constexpr double MinimumRotationGain = 0.01;
/// After 13 rounds the reach is at its minimum.
constexpr int AlignmentRounds = 16;
/// Rounds in which the flatness grows from its minimum to its maximum.
constexpr int FlatteningRounds = 6;
/// The distance along the surface, in edges, over which the rotations that triangles ask for are
/// smoothed: from the first round to the last.
constexpr double MaximumReach = 8.0, NearestReach = 1.0;
/// The weight of flatness relative to rigidity, as a multiple of the edge length.
constexpr double MinimumFlatness = 0.2, MaximumFlatness = 100.0;
/// Tetrahedra for each task of a parallel loop.
constexpr int AlignmentGrain = 512;

/// Returns the smallest rotation of a unit vector to the closest axis, as axis times angle.
Eigen::Vector3d ToAxis(const Eigen::Vector3d& normal)
{
  Eigen::Index k;
  normal.cwiseAbs().maxCoeff(&k);
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k) * (normal(k) < 0.0 ? -1.0 : 1.0);
  const Eigen::Vector3d across = normal.cross(axis);
  const double sine = across.norm();
  return sine > 0.0 ? Eigen::Vector3d(across / sine * std::atan2(sine, normal.dot(axis)))
                    : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// Finds the shape whose tetrahedra are rotated as given, by linear finite elements. It minimises
/// the sum of volume |J - R|^2 over the tetrahedra, which is a Poisson equation.
class Shape
{
public:
  explicit Shape(const WorkingSolid& solid)
    : Solid(solid)
  {
    const int tetrahedra = static_cast<int>(solid.Tetrahedra.rows());
    this->Hats.resize(tetrahedra);
    this->Volumes.resize(tetrahedra);
    std::vector<Eigen::Triplet<double>> entries;
    for (int t = 0; t < tetrahedra; ++t)
    {
      const Eigen::Matrix3d edges = this->EdgesOf(t, solid.Points);
      this->Hats[t] = ComputeHatGradients(edges);
      this->Volumes(t) = edges.determinant() / 6.0;
      for (int a = 0; a < 4; ++a)
      {
        for (int b = 0; b < 4; ++b)
        {
          // The stiffness matrix of linear finite elements.
          entries.emplace_back(solid.Tetrahedra(t, a), solid.Tetrahedra(t, b),
            this->Volumes(t) * this->Hats[t].row(a).dot(this->Hats[t].row(b)));
        }
      }
    }
    const Eigen::Index points = solid.Points.rows();
    this->Stiffness.resize(points, points);
    this->Stiffness.setFromTriplets(entries.begin(), entries.end());
    double length = 0.0;
    for (const auto& triangle : solid.Triangles.rowwise())
    {
      length += (solid.Points.row(triangle(0)) - solid.Points.row(triangle(1))).norm();
    }
    this->EdgeLength = length / static_cast<double>(solid.Triangles.rows());
  }

  Eigen::Matrix3d JacobianOf(int t, const Eigen::MatrixXd& positions) const
  {
    return this->EdgesOf(t, positions) * this->Hats[t].bottomRows<3>();
  }

  /// The rotations closest to the Jacobians, times one more each, as the right side of the
  /// equations for the shape that has them.
  Eigen::MatrixXd RightSide(
    const Eigen::MatrixXd& positions, const std::function<Eigen::Matrix3d(int)>& further) const
  {
    const int tetrahedra = static_cast<int>(this->Hats.size());
    std::vector<Eigen::Matrix<double, 4, 3>> parts(tetrahedra);
    ParallelFor(tetrahedra, AlignmentGrain,
      [&](int begin, int end)
      {
        for (int t = begin; t < end; ++t)
        {
          const Eigen::Matrix3d wanted = further(t) * FitRotation(this->JacobianOf(t, positions));
          parts[t] = this->Volumes(t) * this->Hats[t] * wanted.transpose();
        }
      });
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(positions.rows(), 3);
    for (int t = 0; t < tetrahedra; ++t)
    {
      for (int a = 0; a < 4; ++a)
      {
        right.row(this->Solid.Tetrahedra(t, a)) += parts[t].row(a);
      }
    }
    return right;
  }

  const WorkingSolid& Solid;
  std::vector<Eigen::Matrix<double, 4, 3>> Hats;
  Eigen::VectorXd Volumes;
  Eigen::SparseMatrix<double> Stiffness;
  double EdgeLength = 0.0;

private:
  Eigen::Matrix3d EdgesOf(int t, const Eigen::MatrixXd& positions) const
  {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
    {
      edges.col(k) = (positions.row(this->Solid.Tetrahedra(t, k + 1)) -
        positions.row(this->Solid.Tetrahedra(t, 0)))
                       .transpose();
    }
    return edges;
  }
};

/// Sums the rotations that the triangles ask for, weighted by area, at the points.
Eigen::MatrixXd Wishes(
  const WorkingSolid& solid, const Eigen::MatrixXd& positions, const Eigen::VectorXd& areas)
{
  const Eigen::MatrixXd normals =
    ComputeAreaVectors(solid.Surface(positions)).rowwise().normalized();
  Eigen::MatrixXd wishes = Eigen::MatrixXd::Zero(positions.rows(), 3);
  for (Eigen::Index f = 0; f < normals.rows(); ++f)
  {
    const Eigen::Vector3d normal = normals.row(f).transpose();
    if (normal.allFinite())
    {
      const Eigen::RowVector3d wish = areas(f) / 3.0 * ToAxis(normal).transpose();
      for (int k = 0; k < 3; ++k)
      {
        wishes.row(solid.Triangles(f, k)) += wish;
      }
    }
  }
  return wishes;
}

Eigen::SparseMatrix<double> Diagonal(const Eigen::VectorXd& values)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < values.size(); ++i)
  {
    entries.emplace_back(i, i, values(i));
  }
  Eigen::SparseMatrix<double> matrix(values.size(), values.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The integral of |nx| + |ny| + |nz| over the area, twice; it is minimal if all normals are along
/// axes.
double Misalignment(const Eigen::MatrixXd& vectors, const Eigen::Matrix3d& rotation)
{
  return (vectors * rotation.transpose()).cwiseAbs().sum();
}

} // namespace

Eigen::RowVector3d GetLabelAxis(int label)
{
  return Eigen::RowVector3d::Unit(label / 2) * (label % 2 == 0 ? 1.0 : -1.0);
}

Eigen::Matrix3d FindAxisRotation(const Mesh& surface)
{
  const Eigen::MatrixXd vectors = ComputeAreaVectors(surface);
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  const double before = Misalignment(vectors, best);
  double minimum = before;
  // Rotations are sampled uniformly (a Halton sequence through Shoemake's uniform quaternions),
  // then in ever smaller neighbourhoods of the best.
  for (int trial = 1; trial <= RotationTrials; ++trial)
  {
    const double u = GetHaltonNumber(trial, 2), v = 2.0 * M_PI * GetHaltonNumber(trial, 3),
                 w = 2.0 * M_PI * GetHaltonNumber(trial, 5);
    const Eigen::Quaterniond q(std::sqrt(1.0 - u) * std::sin(v), std::sqrt(1.0 - u) * std::cos(v),
      std::sqrt(u) * std::sin(w), std::sqrt(u) * std::cos(w));
    const Eigen::Matrix3d rotation = q.toRotationMatrix();
    const double value = Misalignment(vectors, rotation);
    if (value < minimum)
    {
      minimum = value;
      best = rotation;
    }
  }
  for (double angle = 0.2; angle > 1e-4; angle *= 0.7)
  {
    for (int k = 0; k < 6; ++k)
    {
      const Eigen::Matrix3d rotation = ToRotation(angle * GetLabelAxis(k).transpose()) * best;
      const double value = Misalignment(vectors, rotation);
      if (value < minimum)
      {
        minimum = value;
        best = rotation;
      }
    }
  }
  return minimum < (1.0 - MinimumRotationGain) * before
    ? best
    : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

// Gregson et al. 2011, section 4. In each round:
// 1. Each boundary triangle asks for the smallest rotation of its normal to an axis (Wishes).
// 2. The rotations are extended smoothly into the solid, by a screened Laplace equation. Its reach
//    along the surface shrinks, so large parts agree on an axis first.
// 3. The shape whose tetrahedra are rotated so is found by a Poisson equation.
Eigen::MatrixXd AlignWithAxes(const WorkingSolid& solid, const Progress& progress)
{
  const Shape shape(solid);
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(solid.Surface()).rowwise().norm();
  Eigen::VectorXd pointAreas = Eigen::VectorXd::Zero(solid.Points.rows());
  pointAreas.head(solid.SurfacePointCount) = ComputePointAreas(solid.Surface());
  Eigen::VectorXd pin = Eigen::VectorXd::Zero(solid.Points.rows());
  // The stiffness matrix has the translations as null space: a weak pin to the current positions
  // removes it.
  pin.array() += 1e-9 * shape.Stiffness.diagonal().mean();
  SparseCholesky poisson;
  const Eigen::SparseMatrix<double> pinned = shape.Stiffness + Diagonal(pin);
  poisson.Factorize(pinned, progress.Part(0.0, 0.0));
  SparseCholesky smoothing;
  Eigen::MatrixXd positions = solid.Points;
  for (int round = 0; round < AlignmentRounds; ++round)
  {
    const Progress part =
      progress.Part(static_cast<double>(round) / AlignmentRounds, (round + 1.0) / AlignmentRounds);
    const double reach =
      shape.EdgeLength * std::max(NearestReach, MaximumReach * std::pow(0.85, round));
    const Eigen::SparseMatrix<double> smooth = pinned + Diagonal(pointAreas / reach);
    smoothing.Factorize(smooth, part);
    const Eigen::MatrixXd turns = smoothing.Solve(Wishes(solid, positions, areas) / reach);
    const auto further = [&](int t)
    {
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (int k = 0; k < 4; ++k)
      {
        mean += 0.25 * turns.row(solid.Tetrahedra(t, k)).transpose();
      }
      return ToRotation(mean);
    };
    positions = poisson.Solve(shape.RightSide(positions, further) + pin.asDiagonal() * positions);
  }
  return positions;
}

// A local-global iteration: the closest rotations are fitted, and then one linear system for each
// axis, with the flatness of the triangles of that axis, gives the positions. The weight of
// flatness grows from round to round by a constant factor.
Eigen::MatrixXd FlattenAlongAxes(const WorkingSolid& solid, const Eigen::VectorXi& labels,
  const Eigen::MatrixXd& start, const Progress& progress)
{
  const Shape shape(solid);
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(solid.Surface()).rowwise().norm();
  std::array<std::vector<Eigen::Triplet<double>>, 3> flat;
  for (Eigen::Index f = 0; f < solid.Triangles.rows(); ++f)
  {
    // The squared gradient along its axis, for an equilateral triangle.
    for (int k = 0; k < 3; ++k)
    {
      const int a = solid.Triangles(f, k), b = solid.Triangles(f, (k + 1) % 3);
      auto& entries = flat[labels(f) / 2];
      const double weight = 1.0 / std::sqrt(3.0);
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
    }
  }
  Eigen::VectorXd pin = Eigen::VectorXd::Zero(solid.Points.rows());
  pin.array() += 1e-9 * shape.Stiffness.diagonal().mean();
  std::array<SparseCholesky, 3> factors;
  std::array<Eigen::SparseMatrix<double>, 3> penalties;
  for (int axis = 0; axis < 3; ++axis)
  {
    penalties[axis].resize(solid.Points.rows(), solid.Points.rows());
    penalties[axis].setFromTriplets(flat[axis].begin(), flat[axis].end());
  }
  Eigen::MatrixXd positions = start;
  const auto none = [](int) { return Eigen::Matrix3d(Eigen::Matrix3d::Identity()); };
  for (int round = 0; round < FlatteningRounds; ++round)
  {
    const Progress part = progress.Part(
      static_cast<double>(round) / FlatteningRounds, (round + 1.0) / FlatteningRounds);
    const double flatness = shape.EdgeLength * MinimumFlatness *
      std::pow(MaximumFlatness / MinimumFlatness, round / (FlatteningRounds - 1.0));
    const Eigen::MatrixXd right = shape.RightSide(positions, none) + pin.asDiagonal() * positions;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Eigen::SparseMatrix<double> matrix =
        shape.Stiffness + Diagonal(pin) + flatness * penalties[axis];
      factors[axis].Factorize(matrix, part.Part(axis / 3.0, (axis + 1.0) / 3.0));
      positions.col(axis) = factors[axis].Solve(right.col(axis));
    }
  }
  return positions;
}

} // namespace shape
