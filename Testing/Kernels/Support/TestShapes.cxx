#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace shapetest
{

shape::Mesh Icosphere(int level)
{
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  std::vector<Eigen::RowVector3d> points = { { -1, golden, 0 }, { 1, golden, 0 },
    { -1, -golden, 0 }, { 1, -golden, 0 }, { 0, -1, golden }, { 0, 1, golden }, { 0, -1, -golden },
    { 0, 1, -golden }, { golden, 0, -1 }, { golden, 0, 1 }, { -golden, 0, -1 }, { -golden, 0, 1 } };
  std::vector<Eigen::RowVector3i> triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 },
    { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 },
    { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 },
    { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  for (int round = 0; round < level; ++round)
  {
    std::map<std::pair<int, int>, int> midpoints;
    const auto middle = [&](int a, int b)
    {
      const auto [position, isNew] =
        midpoints.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (isNew)
      {
        points.push_back(points[a] + points[b]);
      }
      return position->second;
    };
    std::vector<Eigen::RowVector3i> finer;
    for (auto& point : points)
    {
      point.normalize();
    }
    for (const auto& t : triangles)
    {
      const int ab = middle(t(0), t(1)), bc = middle(t(1), t(2)), ca = middle(t(2), t(0));
      finer.insert(
        finer.end(), { { t(0), ab, ca }, { t(1), bc, ab }, { t(2), ca, bc }, { ab, bc, ca } });
    }
    triangles = std::move(finer);
  }
  shape::Mesh mesh{ Eigen::MatrixXd(points.size(), 3), Eigen::MatrixXi(triangles.size(), 3) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.Points.row(i) = points[i].normalized();
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.Triangles.row(t) = triangles[t];
  }
  return mesh;
}

shape::Mesh Torus(double majorRadius, double minorRadius, int around, int across)
{
  shape::Mesh mesh{ Eigen::MatrixXd(around * across, 3), Eigen::MatrixXi(2 * around * across, 3) };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * M_PI * i / around, v = 2.0 * M_PI * j / across;
      const double radius = majorRadius + minorRadius * std::cos(v);
      const int here = i * across + j;
      mesh.Points.row(here) << radius * std::cos(u), radius * std::sin(u),
        minorRadius * std::sin(v);
      const int right = (i + 1) % around * across + j;
      const int up = i * across + (j + 1) % across;
      const int diagonal = (i + 1) % around * across + (j + 1) % across;
      mesh.Triangles.row(2 * here) << here, right, diagonal;
      mesh.Triangles.row(2 * here + 1) << here, diagonal, up;
    }
  }
  return mesh;
}

shape::Mesh FlatDisk(int rings)
{
  const int n = 1 + 3 * rings * (rings + 1);
  shape::Mesh mesh{ Eigen::MatrixXd::Zero(n, 3), Eigen::MatrixXi(6 * rings * rings, 3) };
  const auto point = [](int ring, int i)
  { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring); };
  int t = 0;
  for (int ring = 1; ring <= rings; ++ring)
  {
    for (int i = 0; i < 6 * ring; ++i)
    {
      const double angle = 2.0 * M_PI * i / (6 * ring);
      mesh.Points.row(point(ring, i)) << std::cos(angle) * ring / rings,
        std::sin(angle) * ring / rings, 0.0;
    }
    for (int sector = 0; sector < 6; ++sector)
    {
      for (int k = 0; k < ring; ++k)
      {
        const int outer = sector * ring + k, inner = sector * (ring - 1) + k;
        mesh.Triangles.row(t++) << point(ring - 1, inner), point(ring, outer),
          point(ring, outer + 1);
        if (k + 1 < ring)
        {
          mesh.Triangles.row(t++) << point(ring - 1, inner), point(ring, outer + 1),
            point(ring - 1, inner + 1);
        }
      }
    }
  }
  return mesh;
}

shape::Mesh FlatSquare(int cells, double shake)
{
  const int n = (cells + 1) * (cells + 1);
  shape::Mesh mesh{ Eigen::MatrixXd::Zero(n, 3), Eigen::MatrixXi(2 * cells * cells, 3) };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> offset(-shake, shake);
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; j <= cells; ++j)
    {
      const bool inside = i > 0 && i < cells && j > 0 && j < cells;
      const double x = i + (inside ? offset(random) : 0.0), y = j + (inside ? offset(random) : 0.0);
      mesh.Points.row(i * (cells + 1) + j) << 2.0 * x / cells - 1.0, 2.0 * y / cells - 1.0, 0.0;
    }
  }
  int t = 0;
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      const int a = i * (cells + 1) + j, b = a + cells + 1, c = b + 1, d = a + 1;
      const bool rising = (i < cells / 2) == (j < cells / 2);
      mesh.Triangles.row(t++) << a, b, (rising ? c : d);
      mesh.Triangles.row(t++) << (rising ? a : b), c, d;
    }
  }
  return mesh;
}

shape::Mesh Prism(const std::vector<Eigen::RowVector2d>& outline)
{
  const auto n = static_cast<int>(outline.size());
  shape::Mesh prism{ Eigen::MatrixXd(2 * n, 3), Eigen::MatrixXi(4 * n - 4, 3) };
  int t = 0;
  for (int i = 0; i < n; ++i)
  {
    const int next = (i + 1) % n;
    prism.Points.row(i) << outline[i], 0.0;
    prism.Points.row(n + i) << outline[i], 1.0;
    prism.Triangles.row(t++) << i, next, n + next;
    prism.Triangles.row(t++) << i, n + next, n + i;
    if (i > 0 && i + 1 < n)
    {
      prism.Triangles.row(t++) << 0, i + 1, i;
      prism.Triangles.row(t++) << n, n + i, n + i + 1;
    }
  }
  return prism;
}

shape::Mesh ReadOff(const std::string& path)
{
  std::ifstream file(path);
  std::string word;
  int points = 0, triangles = 0, edges = 0;
  if (!(file >> word >> points >> triangles >> edges) || word != "OFF")
  {
    throw std::runtime_error("cannot read " + path);
  }
  shape::Mesh mesh{ Eigen::MatrixXd(points, 3), Eigen::MatrixXi(triangles, 3) };
  for (int i = 0; i < points; ++i)
  {
    file >> mesh.Points(i, 0) >> mesh.Points(i, 1) >> mesh.Points(i, 2);
  }
  for (int t = 0; t < triangles; ++t)
  {
    int corners = 0;
    file >> corners >> mesh.Triangles(t, 0) >> mesh.Triangles(t, 1) >> mesh.Triangles(t, 2);
    if (!file || corners != 3)
    {
      throw std::runtime_error("cannot read triangle " + std::to_string(t) + " of " + path);
    }
  }
  return mesh;
}

shape::Mesh ReadModel(const std::string& name)
{
  return ReadOff(std::string(SHAPEMAP_MODELS) + "/" + name + ".off");
}

} // namespace shapetest
