#include "Materials/ImageValues.h"

#include "Base/Errors.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace
{

using namespace shape::cell_kind;
using Field = std::function<double(const Eigen::RowVector3d& position)>;

/// An image with any spacings and directions; `isLeftHanded`: its directions are a mirror image.
shape::VoxelImage MakeImage(const std::array<int, 3>& size, bool isLeftHanded = false)
{
  shape::VoxelImage image;
  image.Size = size;
  image.Origin << -3.0, 2.0, 0.7;
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(0.8, -0.3, 0.5, 0.2).normalized();
  image.Axes =
    rotation.toRotationMatrix() * Eigen::Vector3d(0.5, 0.8, isLeftHanded ? -1.3 : 1.3).asDiagonal();
  return image;
}

Eigen::RowVector3d PositionOf(const shape::VoxelImage& image, double i, double j, double k)
{
  return image.Origin + Eigen::RowVector3d(i, j, k) * image.Axes.transpose();
}

void AddChannel(shape::VoxelImage& image, const Field& field)
{
  std::vector<double> values;
  for (int k = 0; k < image.Size[2]; ++k)
  {
    for (int j = 0; j < image.Size[1]; ++j)
    {
      for (int i = 0; i < image.Size[0]; ++i)
      {
        values.push_back(field(PositionOf(image, i, j, k)));
      }
    }
  }
  image.Channels.push_back(values);
}

double Linear(const Eigen::RowVector3d& position)
{
  return 7.0 + position.dot(Eigen::RowVector3d(1.3, -0.4, 2.2));
}

/// One cell whose corners have these indices in the image.
shape::Cells OneCell(const shape::VoxelImage& image, int kind, const Eigen::MatrixXd& indices)
{
  shape::Cells cells;
  cells.Points.resize(indices.rows(), 3);
  for (Eigen::Index i = 0; i < indices.rows(); ++i)
  {
    cells.Points.row(i) = PositionOf(image, indices(i, 0), indices(i, 1), indices(i, 2));
  }
  const int corners = static_cast<int>(indices.rows());
  cells.Kinds.setConstant(1, kind);
  cells.Offsets = Eigen::Vector2i(0, corners);
  cells.Corners = Eigen::VectorXi::LinSpaced(corners, 0, corners - 1);
  return cells;
}

Eigen::MatrixXd BoxCorners(const Eigen::RowVector3d& low, const Eigen::RowVector3d& high)
{
  Eigen::MatrixXd corners(8, 3);
  const int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      corners(i, axis) = (order[i] >> axis & 1) != 0 ? high(axis) : low(axis);
    }
  }
  return corners;
}

/// A box of n^3 hexahedra, or of six tetrahedra for each, with all inner points displaced.
shape::Cells MakeMesh(
  const shape::VoxelImage& image, double low, double high, int n, bool areTetrahedra)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> range(-0.2, 0.2);
  shape::Cells cells;
  const auto id = [&](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
  cells.Points.resize((n + 1) * (n + 1) * (n + 1), 3);
  std::vector<int> corners;
  const double size = (high - low) / n;
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const Eigen::Array3d index(i, j, k);
        Eigen::Array3d at = low + size * index;
        if ((index > 0).all() && (index < n).all())
        {
          at += size * Eigen::Array3d(range(random), range(random), range(random));
        }
        cells.Points.row(id(i, j, k)) = PositionOf(image, at(0), at(1), at(2));
        if ((index < n).all())
        {
          const int c[8] = { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
            id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) };
          const int six[6][2] = { { 1, 2 }, { 2, 3 }, { 3, 7 }, { 7, 4 }, { 4, 5 }, { 5, 1 } };
          for (const auto& pair : six)
          {
            if (areTetrahedra)
            {
              corners.insert(corners.end(), { c[0], c[pair[0]], c[pair[1]], c[6] });
            }
          }
          if (!areTetrahedra)
          {
            corners.insert(corners.end(), c, c + 8);
          }
        }
      }
    }
  }
  const int each = areTetrahedra ? 4 : 8, count = static_cast<int>(corners.size()) / each;
  cells.Kinds.setConstant(count, areTetrahedra ? Tetrahedron : Hexahedron);
  cells.Offsets = Eigen::VectorXi::LinSpaced(count + 1, 0, each * count);
  cells.Corners = Eigen::Map<const Eigen::VectorXi>(corners.data(), each * count);
  return cells;
}

/// A value at each sample that has nothing to do with its neighbours.
Field Noise(unsigned int seed)
{
  auto random = std::make_shared<std::mt19937>(seed);
  return [random](const Eigen::RowVector3d&)
  { return std::uniform_real_distribution<double>(0.0, 1.0)(*random); };
}

/// The volume and the centroid of a hexahedron, by four Gauss points along each axis.
Eigen::RowVector4d Integrate(const Eigen::MatrixXd& corners)
{
  const double nodes[4] = { -0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
    0.8611363115940526 };
  const double weights[4] = { 0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
    0.3478548451374538 };
  const Eigen::MatrixXd signs = BoxCorners({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  Eigen::RowVector4d sums = Eigen::RowVector4d::Zero();
  for (int point = 0; point < 64; ++point)
  {
    const int at[3] = { point % 4, point / 4 % 4, point / 16 };
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int corner = 0; corner < 8; ++corner)
    {
      Eigen::Vector3d factors;
      for (int axis = 0; axis < 3; ++axis)
      {
        factors(axis) = 0.5 * (1.0 + signs(corner, axis) * nodes[at[axis]]);
      }
      position += factors.prod() * corners.row(corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        jacobian.row(axis) += 0.5 * signs(corner, axis) * factors((axis + 1) % 3) *
          factors((axis + 2) % 3) * corners.row(corner);
      }
    }
    const double volume =
      weights[at[0]] * weights[at[1]] * weights[at[2]] * std::abs(jacobian.determinant());
    sums += volume * Eigen::RowVector4d(1.0, position(0), position(1), position(2));
  }
  sums.tail(3) /= sums(0);
  return sums;
}

} // namespace

TEST(ImageValues, LinearFieldsAreExactInCellsOfEveryKind)
{
  for (const bool isLeftHanded : { false, true })
  {
    shape::VoxelImage image = MakeImage({ 12, 11, 10 }, isLeftHanded);
    AddChannel(image, Linear);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> range(1.0, 8.0), small(-0.8, 0.8);
    for (int i = 0; i < 20; ++i)
    {
      Eigen::MatrixXd tetrahedron(4, 3);
      std::generate_n(tetrahedron.data(), 12, [&] { return range(random); });
      Eigen::MatrixXd hexahedron = BoxCorners({ 2.0, 2.0, 2.0 }, { 7.0, 6.0, 5.0 });
      std::for_each(
        hexahedron.data(), hexahedron.data() + 24, [&](double& value) { value += small(random); });
      Eigen::MatrixXd wedge(6, 3), pyramid(5, 3);
      wedge << tetrahedron.topRows(3), tetrahedron.topRows(3);
      wedge.bottomRows(3).rowwise() += 0.2 * tetrahedron.row(3);
      const Eigen::RowVector3d a = tetrahedron.row(0), b = tetrahedron.row(1),
                               c = tetrahedron.row(2), apex = tetrahedron.row(3);
      pyramid << a, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (a + c), apex;
      const Eigen::RowVector4d exact = Integrate(hexahedron);
      const double voxel = std::abs(image.Axes.determinant());
      struct Case
      {
        int Kind;
        Eigen::MatrixXd Corners;
        Eigen::RowVector3d Centroid;
      };
      for (const Case& each : { Case{ Tetrahedron, tetrahedron, tetrahedron.colwise().mean() },
             Case{ Hexahedron, hexahedron, exact.tail(3) },
             Case{ Wedge, wedge, wedge.colwise().mean() },
             Case{ Pyramid, pyramid, 0.75 * pyramid.topRows(4).colwise().mean() + 0.25 * apex } })
      {
        const shape::ImageValuesResult found =
          shape::ComputeImageValues(OneCell(image, each.Kind, each.Corners), image);
        const Eigen::RowVector3d& x = each.Centroid;
        const double expected = Linear(PositionOf(image, x(0), x(1), x(2)));
        EXPECT_NEAR(found.Means(0, 0), expected, 1e-12 * std::abs(expected) + 1e-12) << each.Kind;
        EXPECT_NEAR(found.Coverage(0), 1.0, 1e-12);
        if (each.Kind == Hexahedron)
        {
          EXPECT_NEAR(found.Volumes(0), exact(0) * voxel, 1e-11 * exact(0));
        }
      }
    }
  }
}

TEST(ImageValues, AConstantImageHasOneMean)
{
  shape::VoxelImage image = MakeImage({ 9, 9, 9 });
  AddChannel(image, [](const auto&) { return 4.25; });
  const shape::ImageValuesResult found =
    shape::ComputeImageValues(MakeMesh(image, 0.0, 8.0, 3, true), image,
      { image.Channels[0], [](double v) { return 2.0 * v; }, [](double d) { return d * d; } });
  EXPECT_LT((found.Means.array() - 4.25).abs().maxCoeff(), 1e-13);
  EXPECT_LT((found.Density.array() - 8.5).abs().maxCoeff(), 1e-13);
  EXPECT_LT((found.Modulus.array() - 72.25).abs().maxCoeff(), 1e-12);
}

// The trapezoidal rule integrates the interpolation over the entire image.
TEST(ImageValues, TheCellsTogetherHaveTheIntegralOfTheImage)
{
  shape::VoxelImage image = MakeImage({ 11, 11, 11 });
  AddChannel(image, Noise(7));
  double integral = 0.0;
  for (int k = 0; k < 11; ++k)
  {
    for (int j = 0; j < 11; ++j)
    {
      for (int i = 0; i < 11; ++i)
      {
        const auto half = [](int at) { return at == 0 || at == 10 ? 0.5 : 1.0; };
        integral += half(i) * half(j) * half(k) * image.Channels[0][image.IndexOf(i, j, k)];
      }
    }
  }
  integral *= std::abs(image.Axes.determinant());
  for (const bool areTetrahedra : { false, true })
  {
    // Many voxels in a cell, and many cells in a voxel.
    for (const int n : { 2, 23 })
    {
      const shape::ImageValuesResult found =
        shape::ComputeImageValues(MakeMesh(image, 0.0, 10.0, n, areTetrahedra), image);
      EXPECT_NEAR(found.Volumes.dot(found.Means.col(0)) / integral, 1.0, 2e-3)
        << n << areTetrahedra;
    }
  }
}

TEST(ImageValues, TheErrorDecreasesWithTheSquareOfTheStep)
{
  shape::VoxelImage image = MakeImage({ 11, 11, 11 });
  AddChannel(image, Noise(9));
  for (const bool areTetrahedra : { false, true })
  {
    const shape::Cells mesh = MakeMesh(image, 1.0, 6.0, 2, areTetrahedra);
    const auto means = [&](double step)
    {
      shape::ImageValuesOptions options;
      options.SamplingStep = step;
      return shape::ComputeImageValues(mesh, image, {}, options).Means.col(0).eval();
    };
    const Eigen::VectorXd exact = means(1.0 / 8.0);
    const double coarse = (means(1.0) - exact).norm(), fine = (means(0.25) - exact).norm();
    EXPECT_GT(std::log2(coarse / fine) / 2.0, 1.7) << areTetrahedra;
    EXPECT_LT(coarse / std::sqrt(exact.size()), 5e-3) << areTetrahedra;
  }
}

// In a box that lies within a voxel, the mean of a trilinear function is its value at the centre.
TEST(ImageValues, CellsMuchSmallerThanAVoxelAreExact)
{
  shape::VoxelImage image = MakeImage({ 2, 2, 2 });
  AddChannel(image, Noise(11));
  const std::vector<double>& v = image.Channels[0];
  const Eigen::RowVector3d centre(0.31, 0.62, 0.27);
  double expected = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= (corner >> axis & 1) != 0 ? centre(axis) : 1.0 - centre(axis);
    }
    expected += weight * v[corner];
  }
  const Eigen::RowVector3d half(0.05, 0.01, 0.03);
  const shape::ImageValuesResult found = shape::ComputeImageValues(
    OneCell(image, Hexahedron, BoxCorners(centre - half, centre + half)), image);
  EXPECT_NEAR(found.Means(0, 0), expected, 1e-13);
}

TEST(ImageValues, CoverageIsTheShareInTheImage)
{
  shape::VoxelImage image = MakeImage({ 9, 9, 9 });
  AddChannel(image, Linear);
  // 5 of 8, 4 of 6 and 3 of 4 voxels along the axes.
  const shape::ImageValuesResult part = shape::ComputeImageValues(
    OneCell(image, Hexahedron, BoxCorners({ 3.0, -2.0, 5.0 }, { 11.0, 4.0, 9.0 })), image);
  const double share = 5.0 / 8.0 * 4.0 / 6.0 * 3.0 / 4.0;
  EXPECT_NEAR(part.Coverage(0), share, 0.02 * share);
  EXPECT_NEAR(part.Means(0, 0), Linear(PositionOf(image, 5.5, 2.0, 6.5)), 0.05);
  // Half of a tetrahedron's edge along j: 7/8 of its volume.
  Eigen::MatrixXd corners(4, 3);
  corners << 1.0, 4.0, 1.0, 7.0, 4.0, 1.0, 1.0, 4.0, 7.0, 1.0, 12.0, 1.0;
  const shape::ImageValuesResult most =
    shape::ComputeImageValues(OneCell(image, Tetrahedron, corners), image);
  EXPECT_NEAR(most.Coverage(0), 0.875, 0.01);
  corners.col(1).array() += 10.0;
  const shape::ImageValuesResult none =
    shape::ComputeImageValues(OneCell(image, Tetrahedron, corners), image);
  EXPECT_EQ(none.Coverage(0), 0.0);
  EXPECT_EQ(none.Means(0, 0), 0.0);
  EXPECT_NEAR(none.Volumes(0), 48.0 * std::abs(image.Axes.determinant()), 1e-10);
}

TEST(ImageValues, ALawIsAveragedNotEvaluatedAtTheMean)
{
  shape::VoxelImage image;
  image.Size = { 9, 3, 3 };
  AddChannel(image, [](const Eigen::RowVector3d& x) { return x(0); });
  const shape::MaterialLaws laws = { image.Channels[0], [](double v) { return 0.5 * v; },
    [](double d) { return d * d; } };
  const shape::ImageValuesResult found = shape::ComputeImageValues(
    OneCell(image, Hexahedron, BoxCorners({ 1.0, 0.5, 0.5 }, { 7.0, 1.5, 1.5 })), image, laws);
  EXPECT_NEAR(found.Density(0), 2.0, 1e-12);
  // The mean of x^2 / 4 over [1, 7].
  EXPECT_NEAR(found.Modulus(0), (343.0 - 1.0) / 3.0 / 6.0 / 4.0, 1e-8);
}

namespace
{

std::string MessageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const shape::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(ImageValues, RefusesWhatHasNoMeaning)
{
  shape::VoxelImage image = MakeImage({ 9, 9, 9 });
  AddChannel(image, [](const auto&) { return -1.0; });
  const shape::Cells cell =
    OneCell(image, Hexahedron, BoxCorners({ 1.0, 1.0, 1.0 }, { 4.0, 4.0, 4.0 }));
  const auto run = [&](const shape::Cells& cells, const shape::VoxelImage& given,
                     const shape::MaterialLaws& laws = {}, double step = 1.0)
  {
    return MessageOf(
      [&]
      {
        shape::ImageValuesOptions options;
        options.SamplingStep = step;
        shape::ComputeImageValues(cells, given, laws, options);
      });
  };
  EXPECT_EQ(run(cell, image), "");
  const auto same = [](double v) { return v; };
  EXPECT_NE(run(cell, image, { image.Channels[0], same, same }).find("modulus is negative"),
    std::string::npos);
  EXPECT_NE(run(cell, image, { image.Channels[0], same, [](double d) { return std::sqrt(d); } })
              .find("not finite in 1 cell (first cell 0)"),
    std::string::npos);
  EXPECT_NE(run(cell, image, { image.Channels[0], same, [](double) { return 0.0; } })
              .find("the modulus is 0"),
    std::string::npos);
  const shape::Cells away =
    OneCell(image, Hexahedron, BoxCorners({ 11.0, 1.0, 1.0 }, { 14.0, 4.0, 4.0 }));
  EXPECT_NE(run(away, image, { image.Channels[0], same, [](double) { return 1.0; } })
              .find("does not contain any part of 1 cell"),
    std::string::npos);
  EXPECT_NE(run(cell, image, {}, 0.0).find("SamplingStep"), std::string::npos);

  const shape::Cells flat =
    OneCell(image, Hexahedron, BoxCorners({ 1.0, 1.0, 2.0 }, { 4.0, 4.0, 2.0 }));
  EXPECT_NE(run(flat, image).find("no volume in 1 cell"), std::string::npos);
  shape::Cells triangle = OneCell(image, Triangle, Eigen::MatrixXd::Identity(3, 3));
  EXPECT_NE(run(triangle, image).find("other types"), std::string::npos);
  shape::Cells broken = cell;
  broken.Points(3, 1) = NAN;
  EXPECT_NE(run(broken, image).find("Input"), std::string::npos);

  shape::VoxelImage bad = image;
  bad.Channels[0][5] = NAN;
  EXPECT_NE(run(cell, bad).find("not finite"), std::string::npos);
  bad = image;
  bad.Axes.col(2) = bad.Axes.col(1);
  EXPECT_NE(run(cell, bad).find("directions"), std::string::npos);
  bad = image;
  bad.Size = { 81, 9, 1 };
  EXPECT_NE(run(cell, bad).find("axis k"), std::string::npos);
}

TEST(ImageValues, ALargeCellIsDividedAmongTasksAndCanBeStopped)
{
  shape::VoxelImage image = MakeImage({ 70, 60, 20 });
  AddChannel(image, Linear);
  const shape::Cells cell =
    OneCell(image, Hexahedron, BoxCorners({ 1.0, 1.0, 1.0 }, { 68.0, 58.0, 18.0 }));
  const shape::ImageValuesResult found = shape::ComputeImageValues(cell, image);
  const double expected = Linear(PositionOf(image, 34.5, 29.5, 9.5));
  EXPECT_NEAR(found.Means(0, 0), expected, 1e-11 * std::abs(expected));
  EXPECT_THROW(
    shape::ComputeImageValues(cell, image, {}, {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}
