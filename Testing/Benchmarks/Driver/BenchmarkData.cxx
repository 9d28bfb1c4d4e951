#include "Driver/BenchmarkData.h"

#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "IO/OFFReader.h"
#include "Parameterize/Parameterize.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>

namespace benchmark
{

namespace
{

constexpr int LargestDegree = 4;
constexpr int TermsOfDegree = 2;
constexpr int ChargeCount = 8;
constexpr double NearestCharge = 0.2, FarthestCharge = 0.5;
constexpr double Pi = 3.14159265358979323846;

/// Uniform in [0, 1), the same with every standard library.
class Random
{
public:
  explicit Random(unsigned int seed)
    : Engine(seed)
  {
  }
  double operator()() { return this->Engine() / 4294967296.0; }
  int Index(int count) { return static_cast<int>((*this)() * count); }
  Eigen::RowVector3d Direction()
  {
    const double z = 2.0 * (*this)() - 1.0, angle = 2.0 * Pi * (*this)();
    const double radius = std::sqrt(1.0 - z * z);
    return { radius * std::cos(angle), radius * std::sin(angle), z };
  }

private:
  std::mt19937 Engine;
};

shape::Mesh Welded(const shape::Mesh& mesh)
{
  std::map<std::array<double, 3>, int> places;
  std::vector<int> newId(mesh.Points.rows());
  std::vector<int> kept;
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    const auto [found, fresh] = places.try_emplace(
      { mesh.Points(i, 0), mesh.Points(i, 1), mesh.Points(i, 2) }, static_cast<int>(kept.size()));
    newId[i] = found->second;
    if (fresh)
    {
      kept.push_back(i);
    }
  }
  return { mesh.Points(kept, Eigen::all),
    mesh.Triangles.unaryExpr([&](int i) { return newId[i]; }) };
}

/// Twice the area of a triangle in the plane, with its sign.
double Turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// A simple polygon as triangles, by cutting off ears. One without an area, at corners in line, is
/// cut off only where there is no other: vtkPolygon leaves it out, and a gap in the surface.
std::vector<std::array<int, 3>> Triangulated(
  const Eigen::MatrixXd& points, const std::vector<int>& corners)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
  {
    const Eigen::Vector3d first = points.row(corners[k]) - points.row(corners[0]),
                          second = points.row(corners[k + 1]) - points.row(corners[0]);
    normal += first.cross(second);
  }
  const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.normalized().cross(x);
  const auto flat = [&](int corner)
  { return Eigen::Vector2d(points.row(corner).dot(x), points.row(corner).dot(y)); };
  const double tolerance = 1e-9 * normal.norm();
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> left = corners;
  while (left.size() > 2)
  {
    std::size_t best = 0;
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < left.size(); ++k)
    {
      const int before = left[(k + left.size() - 1) % left.size()], own = left[k],
                after = left[(k + 1) % left.size()];
      const Eigen::Vector2d a = flat(before), b = flat(own), c = flat(after);
      const bool isEar = std::none_of(left.begin(), left.end(),
        [&](int other)
        {
          const Eigen::Vector2d p = flat(other);
          return other != before && other != own && other != after && Turn(a, b, p) > -tolerance &&
            Turn(b, c, p) > -tolerance && Turn(c, a, p) > -tolerance;
        });
      if (isEar && Turn(a, b, c) > largest)
      {
        largest = Turn(a, b, c);
        best = k;
      }
    }
    triangles.push_back(
      { left[(best + left.size() - 1) % left.size()], left[best], left[(best + 1) % left.size()] });
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

} // namespace

shape::Mesh ReadOff(const std::string& path, bool weld)
{
  std::ifstream file(path, std::ios::binary);
  const std::string content{ std::istreambuf_iterator<char>(file), {} };
  const shape::Cells faces = shape::ReadOFF(content).Faces;
  shape::Mesh mesh{ faces.Points, {} };
  std::vector<std::array<int, 3>> triangles;
  for (Eigen::Index face = 0; face < faces.Kinds.size(); ++face)
  {
    const auto cut = Triangulated(mesh.Points,
      { faces.Corners.begin() + faces.Offsets(face),
        faces.Corners.begin() + faces.Offsets(face + 1) });
    triangles.insert(triangles.end(), cut.begin(), cut.end());
  }
  if (triangles.empty())
  {
    throw shape::InvalidInput(path + " has no polygons");
  }
  mesh.Triangles.resize(triangles.size(), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.Triangles.row(t) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  ScaleToUnitBox(mesh);
  return weld ? Welded(mesh) : mesh;
}

void ScaleToUnitBox(shape::Mesh& mesh)
{
  const Eigen::RowVector3d middle =
    0.5 * (mesh.Points.colwise().minCoeff() + mesh.Points.colwise().maxCoeff());
  mesh.Points = (mesh.Points.rowwise() - middle) / shape::ComputeLongestBoxEdge(mesh.Points);
}

shape::Mesh Subdivide(const shape::Mesh& mesh)
{
  const int points = static_cast<int>(mesh.Points.rows());
  const int triangles = static_cast<int>(mesh.Triangles.rows());
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(points, 3);
  Eigen::VectorXi valences = Eigen::VectorXi::Zero(points);
  std::map<std::array<int, 2>, int> sides; // directed edge: its triangle
  for (int t = 0; t < triangles; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = mesh.Triangles(t, k), to = mesh.Triangles(t, (k + 1) % 3);
      sums.row(from) += mesh.Points.row(to);
      ++valences(from);
      sides[{ from, to }] = t;
    }
  }
  shape::Mesh fine{ Eigen::MatrixXd(points + triangles, 3), Eigen::MatrixXi(3 * triangles, 3) };
  for (int i = 0; i < points; ++i)
  {
    const double share = (4.0 - 2.0 * std::cos(2.0 * Pi / valences(i))) / 9.0;
    fine.Points.row(i) = (1.0 - share) * mesh.Points.row(i) + share * sums.row(i) / valences(i);
  }
  fine.Points.bottomRows(triangles) = shape::ComputeCentroids(mesh);
  int next = 0;
  for (const auto& [edge, triangle] : sides)
  {
    const int other = sides.at({ edge[1], edge[0] });
    fine.Triangles.row(next++) << edge[0], points + other, points + triangle;
  }
  return fine;
}

Eigen::MatrixXd Split(Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values)
{
  const int points = static_cast<int>(values.rows());
  std::map<std::array<int, 2>, int> midpoints;
  Eigen::MatrixXi fine(4 * triangles.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    std::array<int, 3> corner, middle;
    for (int k = 0; k < 3; ++k)
    {
      corner[k] = triangles(t, k);
      const int next = triangles(t, (k + 1) % 3);
      const std::array<int, 2> edge = { std::min(corner[k], next), std::max(corner[k], next) };
      middle[k] =
        midpoints.try_emplace(edge, points + static_cast<int>(midpoints.size())).first->second;
    }
    fine.row(4 * t) << middle[0], middle[1], middle[2];
    for (int k = 0; k < 3; ++k)
    {
      fine.row(4 * t + 1 + k) << corner[k], middle[k], middle[(k + 2) % 3];
    }
  }
  Eigen::MatrixXd all(points + static_cast<int>(midpoints.size()), values.cols());
  all.topRows(points) = values;
  for (const auto& [edge, middle] : midpoints)
  {
    all.row(middle) = 0.5 * (values.row(edge[0]) + values.row(edge[1]));
  }
  triangles = fine;
  return all;
}

TrianglePositions SampleRandomly(const shape::Mesh& mesh, int each, int maximum, unsigned int seed)
{
  Random random(seed);
  const int triangles = static_cast<int>(mesh.Triangles.rows());
  const bool all = triangles * each <= maximum;
  const int count = all ? triangles * each : maximum;
  TrianglePositions places{ std::vector<int>(count), Eigen::MatrixXd(count, 3),
    Eigen::MatrixXd(count, 3) };
  for (int i = 0; i < count; ++i)
  {
    places.Triangles[i] = all ? i / each : random.Index(triangles);
    double u = random(), v = random();
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    places.Weights.row(i) << 1.0 - u - v, u, v;
  }
  places.Points = Interpolated(mesh, mesh.Points, places);
  return places;
}

Eigen::MatrixXd Interpolated(
  const shape::Mesh& mesh, const Eigen::MatrixXd& values, const TrianglePositions& places)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(places.Weights.rows(), values.cols());
  for (Eigen::Index i = 0; i < result.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.row(i) += places.Weights(i, k) * values.row(mesh.Triangles(places.Triangles[i], k));
    }
  }
  return result;
}

Eigen::MatrixXd InteriorPoints(const shape::Mesh& mesh, int count, unsigned int seed, bool winding)
{
  Random random(seed);
  const shape::SignedDistance distance(mesh);
  const Eigen::RowVector3d low = mesh.Points.colwise().minCoeff();
  const Eigen::RowVector3d sides = mesh.Points.colwise().maxCoeff() - low;
  Eigen::MatrixXd inside(count, 3), candidates(count, 3);
  int found = 0;
  while (found < count)
  {
    for (int i = 0; i < count; ++i)
    {
      candidates.row(i) =
        low.array() + sides.array() * Eigen::RowVector3d(random(), random(), random()).array();
    }
    const Eigen::VectorXd depths = distance.Evaluate(candidates).Distances;
    for (int i = 0; i < count && found < count; ++i)
    {
      if (depths(i) < 0.0 &&
        (!winding ||
          std::lround(
            shape::ComputeWindingNumber(mesh.Points, mesh.Triangles, candidates.row(i))) == 1))
      {
        inside.row(found++) = candidates.row(i);
      }
    }
  }
  return inside;
}

HarmonicField::HarmonicField(const shape::Mesh& mesh, unsigned int seed)
  : Polynomials(3 * LargestDegree * TermsOfDegree, 7)
  , ChargePositions(ChargeCount, 3)
  , Charges(ChargeCount, 3)
{
  Random random(seed);
  for (Eigen::Index i = 0; i < this->Polynomials.rows(); ++i)
  {
    const Eigen::RowVector3d real = random.Direction();
    const Eigen::RowVector3d other = random.Direction();
    const Eigen::RowVector3d imaginary = (other - other.dot(real) * real).normalized();
    this->Polynomials.row(i) << real, imaginary, 0.4 * random() - 0.2;
  }
  const shape::SignedDistance distance(mesh);
  for (int i = 0; i < ChargeCount;)
  {
    const Eigen::RowVector3d position(
      2.0 * random() - 1.0, 2.0 * random() - 1.0, 2.0 * random() - 1.0);
    const double away = distance.Evaluate(position).Distances(0);
    if (away > NearestCharge && away < FarthestCharge)
    {
      this->ChargePositions.row(i) = position;
      // At the closest point of the surface its potential is 0.1.
      this->Charges.row(i) = 0.1 * 4.0 * Pi * away * random.Direction();
      ++i;
    }
  }
}

Eigen::MatrixXd HarmonicField::Evaluate(const Eigen::MatrixXd& points) const
{
  Eigen::MatrixXd values = points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d y = points.row(i);
    for (Eigen::Index p = 0; p < this->Polynomials.rows(); ++p)
    {
      const auto term = this->Polynomials.row(p);
      const std::complex<double> a(y.dot(term.head<3>()), y.dot(term.segment<3>(3)));
      const int degree = 1 + static_cast<int>(p / 3) % LargestDegree;
      values(i, p % 3) += term(6) * std::pow(2.0 * a, degree).real();
    }
    for (Eigen::Index j = 0; j < this->Charges.rows(); ++j)
    {
      values.row(i) +=
        this->Charges.row(j) / (4.0 * Pi * (y - this->ChargePositions.row(j)).norm());
    }
  }
  return values;
}

Eigen::MatrixXd Deformed(const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd values(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d p = points.row(i);
    const double twist = p(0);
    const double y = std::cos(twist) * p(1) - std::sin(twist) * p(2);
    const double z = std::sin(twist) * p(1) + std::cos(twist) * p(2);
    const double bend = 0.8 * p(0);
    const double x = std::sin(bend) * (1.25 - y), bent = 1.25 - std::cos(bend) * (1.25 - y);
    const double dent = 0.1 * std::exp(-20.0 * (p.array() - 0.1).matrix().squaredNorm());
    values.row(i) << x, bent - dent, z + dent;
  }
  return values;
}

Eigen::MatrixXd MapToSphere(const shape::Mesh& mesh, const std::string& cache)
{
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  RowMajor positions(mesh.Points.rows(), 3);
  const auto bytes = static_cast<std::streamsize>(sizeof(double) * positions.size());
  std::ifstream kept(cache, std::ios::binary | std::ios::ate);
  if (kept && kept.tellg() == bytes)
  {
    kept.seekg(0);
    kept.read(reinterpret_cast<char*>(positions.data()), bytes);
    return positions;
  }
  positions = shape::Parameterize(mesh).Positions;
  std::ofstream(cache, std::ios::binary)
    .write(reinterpret_cast<const char*>(positions.data()), bytes);
  return positions;
}

} // namespace benchmark
