#include "Network/NetworkDescriptors.h"

#include "Base/Errors.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace
{

std::string RandomFeatures()
{
  std::ifstream file(SHAPEMAP_DATA "/RandomFeatures.onnx", std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

const Eigen::MatrixXd NoArrays(0, 0);

/// A sphere with three different axes.
shape::Surface Ellipsoid()
{
  shape::Mesh mesh = shapetest::Icosphere(3);
  mesh.Points *= Eigen::Vector3d(1.0, 1.3, 1.7).asDiagonal();
  return mesh;
}

} // namespace

TEST(NetworkDescriptors, SignaturesDoNotDependOnPositionAndSize)
{
  const shape::Surface surface = Ellipsoid();
  const Eigen::MatrixXd expected =
    shape::ComputeNetworkDescriptors(surface, RandomFeatures(), NoArrays);
  ASSERT_EQ(expected.rows(), surface.Points().rows());
  ASSERT_EQ(expected.cols(), 12);
  EXPECT_GT((expected.rowwise() - expected.colwise().mean()).norm(), 1.0);

  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  Eigen::MatrixXd moved = 7.0 * surface.Points() * turn.transpose();
  moved.rowwise() += Eigen::RowVector3d(30.0, -20.0, 10.0);
  const Eigen::MatrixXd actual =
    shape::ComputeNetworkDescriptors(surface.WithPoints(moved), RandomFeatures(), NoArrays);
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-4 * expected.cwiseAbs().maxCoeff());
}

TEST(NetworkDescriptors, PointsWithoutATriangleHaveZero)
{
  const shape::Surface surface = Ellipsoid();
  Eigen::MatrixXd points(surface.Points().rows() + 1, 3);
  points << 1.0, 2.0, 3.0, surface.Points();
  const Eigen::MatrixXi triangles = surface.Triangles().array() + 1;
  const Eigen::MatrixXd expected =
    shape::ComputeNetworkDescriptors(surface, RandomFeatures(), NoArrays);
  const Eigen::MatrixXd actual =
    shape::ComputeNetworkDescriptors(shape::Surface(points, triangles), RandomFeatures(), NoArrays);
  EXPECT_EQ(actual.row(0).norm(), 0.0);
  EXPECT_LT((actual.bottomRows(expected.rows()) - expected).cwiseAbs().maxCoeff(),
    1e-5 * expected.cwiseAbs().maxCoeff());
}

// The evaluation runs in a process of its own, so that whatever is in the file, there is an error
// or a finite result.
TEST(NetworkDescriptors, DamagedFilesAreRefused)
{
  const shape::Surface surface = shapetest::Icosphere(1);
  const std::string whole = RandomFeatures();
  ASSERT_GT(whole.size(), 1000U);
  shape::NetworkDescriptorOptions options;
  options.NumberOfEigenpairs = 8;
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 15)
  {
    EXPECT_THROW(
      shape::ComputeNetworkDescriptors(surface, whole.substr(0, size), NoArrays, options),
      shape::InvalidInput)
      << size;
  }
  std::size_t refused = 0;
  for (std::size_t at = 0; at < 600; at += 11) // the names, types and sizes come first
  {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    try
    {
      EXPECT_TRUE(
        shape::ComputeNetworkDescriptors(surface, damaged, NoArrays, options).allFinite());
    }
    catch (const std::runtime_error&) // InvalidInput or SolveFailure
    {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10U);
}

TEST(NetworkDescriptors, CanBeAborted)
{
  int calls = 0;
  const shape::Progress stop([&](double) { return ++calls < 3; });
  EXPECT_THROW(shape::ComputeNetworkDescriptors(Ellipsoid(), RandomFeatures(), NoArrays, {}, stop),
    shape::Aborted);
}
