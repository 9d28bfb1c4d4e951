#include "Labels/LabelSurfaces.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Mesh.h"
#include "Mesh/RegionSurfaces.h"
#include "Mesh/Topology.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace
{

using Rule = std::function<int(const Eigen::RowVector3d& index)>;

shape::LabelImage MakeImage(const std::array<int, 3>& size, const Rule& rule)
{
  shape::LabelImage image;
  image.Size = size;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        image.Labels.push_back(rule(Eigen::RowVector3d(i, j, k)));
      }
    }
  }
  return image;
}

/// A ball that planes half-way between seeds divide.
struct Voronoi
{
  Voronoi(int size, int count, unsigned int seed)
    : Size(size)
    , Seeds(count, 3)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> range(0.1 * size, 0.9 * size);
    std::generate_n(this->Seeds.data(), this->Seeds.size(), [&]() { return range(random); });
  }

  int LabelAt(const Eigen::RowVector3d& index) const
  {
    Eigen::Index nearest = 0;
    (this->Seeds.rowwise() - index).rowwise().squaredNorm().minCoeff(&nearest);
    const bool isInside = (index.array() - 0.5 * this->Size).matrix().norm() < 0.45 * this->Size;
    return isInside ? static_cast<int>(nearest) + 1 : 0;
  }

  shape::LabelImage Image() const
  {
    return MakeImage({ this->Size, this->Size, this->Size },
      [&](const Eigen::RowVector3d& index) { return this->LabelAt(index); });
  }

  int Size;
  Eigen::MatrixXd Seeds;
};

/// The surface of a region, facing outwards.
shape::Mesh SurfaceOf(int label, const shape::LabelSurfacesResult& all)
{
  const shape::Mesh surfaces{ all.Points, all.Triangles };
  return shape::RegionSurfaces(surfaces, all.Regions).Extract(label);
}

/// The angles in degrees between the triangles' normals and the right ones at their centres, in
/// ascending order. Triangles whose right normal is zero are left out.
std::vector<double> NormalErrors(const shape::LabelSurfacesResult& result,
  const std::function<Eigen::RowVector3d(const Eigen::RowVector3d& centre)>& right)
{
  std::vector<double> degrees;
  for (Eigen::Index t = 0; t < result.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners({ result.Points, result.Triangles }, t);
    const Eigen::RowVector3d first = corners.row(1) - corners.row(0);
    const Eigen::RowVector3d second = corners.row(2) - corners.row(0);
    const Eigen::RowVector3d normal = right(corners.colwise().mean());
    if (!normal.isZero())
    {
      const double cosine = first.cross(second).normalized().dot(normal);
      degrees.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / M_PI);
    }
  }
  std::sort(degrees.begin(), degrees.end());
  return degrees;
}

void ExpectClosedManifold(const shape::Mesh& surface)
{
  const shape::Topology topology = shape::ComputeTopology(surface);
  EXPECT_EQ(topology.BoundaryLoops, 0);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.NonManifoldPoints, 0);
  EXPECT_EQ(topology.MisorientedEdges, 0);
}

} // namespace

TEST(LabelSurfaces, OfFlatInterfacesAreFlat)
{
  const Voronoi cells(64, 8, 3);
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(cells.Image());
  double squares = 0.0;
  int count = 0;
  std::vector<double> degrees;
  for (Eigen::Index t = 0; t < result.Triangles.rows(); ++t)
  {
    const int a = result.Regions(t, 0), b = result.Regions(t, 1);
    if (b == 0)
    {
      continue;
    }
    const Eigen::RowVector3d normal =
      (cells.Seeds.row(b - 1) - cells.Seeds.row(a - 1)).normalized();
    const Eigen::RowVector3d middle = 0.5 * (cells.Seeds.row(b - 1) + cells.Seeds.row(a - 1));
    const Eigen::Matrix3d corners =
      shape::GetCorners({ result.Points, result.Triangles }, t).rowwise() - middle;
    squares += (corners * normal.transpose()).squaredNorm();
    count += 3;
    const Eigen::RowVector3d first = corners.row(1) - corners.row(0);
    const Eigen::RowVector3d second = corners.row(2) - corners.row(0);
    degrees.push_back(
      std::acos(std::min(1.0, first.cross(second).normalized().dot(normal))) * 180.0 / M_PI);
  }
  EXPECT_LE(std::sqrt(squares / count), 0.15);
  std::nth_element(degrees.begin(), degrees.begin() + degrees.size() / 2, degrees.end());
  EXPECT_LE(degrees[degrees.size() / 2], 3.0);
}

TEST(LabelSurfaces, OfARotatedBoxHaveItsNormals)
{
  const Eigen::Matrix3d axes =
    Eigen::AngleAxisd(0.6, Eigen::Vector3d(2.0, 1.0, 3.0).normalized()).toRotationMatrix();
  const Eigen::RowVector3d centre(24.3, 23.8, 24.1), half(14.0, 11.0, 9.0);
  const auto excess = [&](const Eigen::RowVector3d& p) -> Eigen::RowVector3d
  { return ((p - centre) * axes).cwiseAbs() - half; };
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(MakeImage({ 48, 48, 48 },
    [&](const Eigen::RowVector3d& p) { return static_cast<int>(excess(p).maxCoeff() < 0.0); }));
  // On the faces, away from the edges, which are rounded.
  const std::vector<double> degrees = NormalErrors(result,
    [&](const Eigen::RowVector3d& p) -> Eigen::RowVector3d
    {
      Eigen::Index face = 0;
      const Eigen::RowVector3d over = excess(p);
      over.maxCoeff(&face);
      if ((over.array() > -4.0).count() > 1)
      {
        return Eigen::RowVector3d::Zero();
      }
      const double side = (p - centre).dot(axes.col(face).transpose()) > 0.0 ? 1.0 : -1.0;
      return side * axes.col(face).transpose();
    });
  ASSERT_FALSE(degrees.empty());
  EXPECT_LE(degrees[degrees.size() / 2], 3.0);
}

TEST(LabelSurfaces, OfABallHaveItsNormals)
{
  const Eigen::RowVector3d centre(20.3, 19.8, 20.1);
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(MakeImage({ 41, 41, 41 },
    [&](const Eigen::RowVector3d& p) { return static_cast<int>((p - centre).norm() < 17.2); }));
  const std::vector<double> degrees = NormalErrors(result,
    [&](const Eigen::RowVector3d& p) -> Eigen::RowVector3d { return (p - centre).normalized(); });
  EXPECT_LE(degrees[degrees.size() / 2], 3.0);
}

TEST(LabelSurfaces, OfManyRegionsFillTheImage)
{
  const Voronoi cells(40, 200, 8);
  shape::LabelImage image = cells.Image();
  const auto inside =
    std::count_if(image.Labels.begin(), image.Labels.end(), [](int label) { return label != 0; });
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(std::move(image));
  EXPECT_GE(result.RegionsByLabel.size(), 150U);
  double volume = 0.0;
  for (const shape::LabelRegion& region : result.RegionsByLabel)
  {
    volume += region.SurfaceVolume;
    ExpectClosedManifold(SurfaceOf(region.Label, result));
  }
  // The surfaces between two regions cancel; what is left encloses all voxels.
  EXPECT_NEAR(volume / static_cast<double>(inside), 1.0, 1e-3);
}

TEST(LabelSurfaces, KeepVolumesAndTopology)
{
  // A ring with a core of another label, in a box.
  const auto rule = [](const Eigen::RowVector3d& index)
  {
    const Eigen::RowVector3d p = index.array() - 20.0;
    const double ring = std::hypot(std::hypot(p(0), p(1)) - 10.0, p(2));
    const bool isInBox = p.cwiseAbs().maxCoeff() < 18.0;
    return ring < 3.0 ? 7 : ring < 6.0 ? 3 : isInBox ? 2 : 0;
  };
  shape::LabelImage image = MakeImage({ 41, 41, 41 }, rule);
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  image.Axes = rotation * Eigen::Vector3d(0.5, 0.6, 1.2).asDiagonal();
  image.Origin << 100.0, -20.0, 3.0;
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(image);
  ASSERT_EQ(result.RegionsByLabel.size(), 3U);
  const int labels[] = { 2, 3, 7 }, components[] = { 2, 2, 1 }, euler[] = { 2, 0, 0 };
  for (int i = 0; i < 3; ++i)
  {
    const shape::LabelRegion& region = result.RegionsByLabel[i];
    EXPECT_EQ(region.Label, labels[i]);
    EXPECT_EQ(region.Components, components[i]);
    EXPECT_EQ(region.EulerNumber, euler[i]);
    EXPECT_NEAR(region.SurfaceVolume / region.ImageVolume, 1.0, 1e-3);
    ExpectClosedManifold(SurfaceOf(labels[i], result));
  }
  EXPECT_TRUE(result.Curves.empty());
}

TEST(LabelSurfaces, FollowTheAxesOfTheImage)
{
  shape::LabelImage image = Voronoi(24, 3, 5).Image();
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(image);
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (const double handedness : { 1.0, -1.0 })
  {
    image.Axes = rotation * Eigen::Vector3d(handedness * 0.5, 0.6, 1.2).asDiagonal();
    image.Origin << 100.0, -20.0, 3.0;
    const shape::LabelSurfacesResult moved = shape::ExtractLabelSurfaces(image);
    const Eigen::MatrixXd expected =
      (result.Points * image.Axes.transpose()).rowwise() + image.Origin;
    EXPECT_LE((moved.Points - expected).cwiseAbs().maxCoeff(), 1e-9);
    ASSERT_EQ(moved.RegionsByLabel.size(), result.RegionsByLabel.size());
    for (std::size_t i = 0; i < result.RegionsByLabel.size(); ++i)
    {
      const double volume = 0.36 * result.RegionsByLabel[i].SurfaceVolume;
      EXPECT_GT(volume, 0.0);
      EXPECT_NEAR(moved.RegionsByLabel[i].SurfaceVolume, volume, 1e-9 * volume);
    }
  }
}

TEST(LabelSurfaces, OfNoiseAreManifold)
{
  std::mt19937 random(11);
  const auto rule = [&](const Eigen::RowVector3d&) { return static_cast<int>(random() % 2); };
  const shape::LabelSurfacesResult result =
    shape::ExtractLabelSurfaces(MakeImage({ 20, 20, 20 }, rule));
  ExpectClosedManifold(SurfaceOf(1, result));
  EXPECT_EQ(result.Intersections, 0);
  EXPECT_TRUE(shape::FindSelfIntersections(shape::Mesh{ result.Points, result.Triangles }).empty());
}

TEST(LabelSurfaces, SplitPointsWhereARegionTouchesItself)
{
  // Label 1 at two opposite corners of a cube between labels 2 and 3.
  const auto rule = [](const Eigen::RowVector3d& index)
  {
    const Eigen::RowVector3i p = index.cast<int>();
    const int ones = p.sum();
    return ones == 0 || ones == 3 ? 1 : p(0) == 1 ? 2 : 3;
  };
  const shape::LabelSurfacesResult result =
    shape::ExtractLabelSurfaces(MakeImage({ 2, 2, 2 }, rule));
  EXPECT_GE(result.SplitPoints, 1);
  ExpectClosedManifold(SurfaceOf(1, result));
}

TEST(LabelSurfaces, CurvesRunWhereThreeRegionsMeet)
{
  // Three sectors of a cylinder that ends at the border of the image.
  const auto rule = [](const Eigen::RowVector3d& index)
  {
    const double x = index(0) - 15.3, y = index(1) - 14.8;
    const double turn = (std::atan2(y, x) + M_PI) / (2.0 * M_PI);
    return std::hypot(x, y) < 12.0 ? 1 + std::min(static_cast<int>(3.0 * turn), 2) : 0;
  };
  const shape::LabelSurfacesResult result =
    shape::ExtractLabelSurfaces(MakeImage({ 31, 31, 21 }, rule));
  // The axis, and between each two sectors and the outside a curve along a radius, the side and
  // another radius. All end where the axis leaves the cylinder.
  EXPECT_EQ(result.Corners.size(), 2U);
  EXPECT_EQ(result.Curves.size(), 4U);
  int axes = 0;
  for (const std::vector<int>& curve : result.Curves)
  {
    const Eigen::RowVector3d middle = result.Points.row(curve[curve.size() / 2]);
    if (std::hypot(middle(0) - 15.3, middle(1) - 14.8) < 1.0 && std::abs(middle(2) - 10.0) < 5.0)
    {
      ++axes;
      for (const int point : curve)
      {
        EXPECT_LE(std::hypot(result.Points(point, 0) - 15.3, result.Points(point, 1) - 14.8), 0.5);
      }
    }
  }
  EXPECT_EQ(axes, 1);
}

TEST(LabelSurfaces, OfGreyValuesLieWhereTheThresholdIsReached)
{
  shape::LabelImage image = MakeImage({ 40, 40, 40 }, [](const auto&) { return 0; });
  for (int n = 0; n < 40 * 40 * 40; ++n)
  {
    const Eigen::RowVector3d p(n % 40, n / 40 % 40, n / 1600);
    image.Values.push_back(static_cast<float>(-(p.array() - 19.6).matrix().norm()));
  }
  shape::MakeLabels(image, { -15.3, -8.2 });
  shape::LabelSurfacesOptions options;
  options.Smoothing = 0.0;
  const shape::LabelSurfacesResult result = shape::ExtractLabelSurfaces(image, options);
  double worst = 0.0;
  for (Eigen::Index i = 0; i < result.Points.rows(); ++i)
  {
    const double radius = (result.Points.row(i).array() - 19.6).matrix().norm();
    worst = std::max(worst, std::min(std::abs(radius - 15.3), std::abs(radius - 8.2)));
  }
  // The mean of points of a sphere of radius r, less than a cube's diagonal apart, is at most
  // 3 / (8 r) away.
  EXPECT_LE(worst, 3.0 / (8.0 * 8.2));
}

TEST(LabelSurfaces, DissolveIslands)
{
  const auto rule = [](const Eigen::RowVector3d& index)
  {
    const Eigen::RowVector3d p = index.array() - 10.0;
    return index.sum() == 6.0 && index.maxCoeff() == 2.0 ? 4
      : p.norm() < 1.5                                   ? 0
      : p.norm() < 7.0                                   ? 5
                                                         : 0;
  };
  shape::LabelSurfacesOptions options;
  options.SmallestIsland = 30;
  const shape::LabelSurfacesResult result =
    shape::ExtractLabelSurfaces(MakeImage({ 21, 21, 21 }, rule), options);
  ASSERT_EQ(result.RegionsByLabel.size(), 1U);
  EXPECT_EQ(result.RegionsByLabel[0].Label, 5);
  EXPECT_EQ(result.RegionsByLabel[0].Components, 1);
  EXPECT_EQ(result.Islands, 2);
  EXPECT_EQ(result.IslandVoxels, 1.0 + 19.0);
}

TEST(LabelSurfaces, NameWhatIsWrong)
{
  shape::LabelImage image;
  EXPECT_THROW(shape::ExtractLabelSurfaces(image), shape::InvalidInput);
  image = MakeImage({ 3, 3, 3 }, [](const auto&) { return 0; });
  EXPECT_THROW(shape::ExtractLabelSurfaces(image), shape::InvalidInput);
  image.Labels[13] = 1;
  shape::LabelSurfacesOptions options;
  options.Smoothing = -1.0;
  EXPECT_THROW(shape::ExtractLabelSurfaces(image, options), shape::InvalidInput);
  image.Axes.col(1) = image.Axes.col(0);
  EXPECT_THROW(shape::ExtractLabelSurfaces(image), shape::InvalidInput);
  EXPECT_THROW(shape::MakeLabels(image, { 2.0, 1.0 }), shape::InvalidInput);
}
