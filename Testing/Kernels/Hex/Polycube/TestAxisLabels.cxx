#include "Base/Errors.h"
#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/AxisLabels.h"
#include "Hex/Polycube/Private/Charts.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Remesh/IsotropicRemesh.h"
#include "Support/TestShapes.h"

#include "Mesh/HexMesh.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

namespace
{

/// The surface of unit cells, each square cut in two.
shape::Mesh CellSurface(const std::vector<std::array<int, 3>>& cells)
{
  shape::HexMesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  mesh.Hexahedra.resize(static_cast<Eigen::Index>(cells.size()), 8);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    for (int k = 0; k < 8; ++k)
    {
      const std::array<int, 3> at = { cells[i][0] + corners[k][0], cells[i][1] + corners[k][1],
        cells[i][2] + corners[k][2] };
      mesh.Hexahedra(static_cast<Eigen::Index>(i), k) =
        numbers.emplace(at, static_cast<int>(numbers.size())).first->second;
    }
  }
  mesh.Points.resize(static_cast<Eigen::Index>(numbers.size()), 3);
  for (const auto& [at, number] : numbers)
  {
    mesh.Points.row(number) << at[0], at[1], at[2];
  }
  return { mesh.Points, shape::SplitQuads(shape::FindBoundaryQuads(mesh)) };
}

Eigen::VectorXi LabelsOf(const shape::Mesh& surface)
{
  const Eigen::MatrixXd vectors = shape::ComputeAreaVectors(surface);
  Eigen::VectorXi labels(vectors.rows());
  for (Eigen::Index f = 0; f < vectors.rows(); ++f)
  {
    for (int label = 0; label < 6; ++label)
    {
      if (vectors.row(f).dot(shape::GetLabelAxis(label)) > 0.5 * vectors.row(f).norm())
      {
        labels(f) = label;
      }
    }
  }
  return labels;
}

} // namespace

TEST(LabelCut, TheCheapestLabellingOfAChainIsFound)
{
  // Two labels and free ends: by trying all of them.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int sites = 10;
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(sites, 6, 100.0);
  std::vector<shape::LabelEdge> edges;
  for (int i = 0; i < sites; ++i)
  {
    costs(i, 0) = uniform(random);
    costs(i, 2) = uniform(random);
    if (i > 0)
    {
      edges.push_back({ i - 1, i, 0.3 * uniform(random) });
    }
  }
  const auto energy = [&](const Eigen::VectorXi& labels)
  {
    double sum = 0.0;
    for (int i = 0; i < sites; ++i)
    {
      sum +=
        costs(i, labels(i)) + (i > 0 && labels(i) != labels(i - 1) ? edges[i - 1].Weight : 0.0);
    }
    return sum;
  };
  double minimum = 1e9;
  for (int bits = 0; bits < 1 << sites; ++bits)
  {
    Eigen::VectorXi labels(sites);
    for (int i = 0; i < sites; ++i)
    {
      labels(i) = (bits >> i) % 2 == 0 ? 0 : 2;
    }
    minimum = std::min(minimum, energy(labels));
  }
  EXPECT_NEAR(energy(shape::SolveGraphCutLabelling(costs, edges)), minimum, 1e-12);
}

TEST(LabelCut, OppositeLabelsAreNeverNeighbours)
{
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(4, 6, 10.0);
  costs.block<2, 1>(0, 0).setZero();
  costs.block<2, 1>(2, 1).setZero();
  const Eigen::VectorXi labels =
    shape::SolveGraphCutLabelling(costs, { { 0, 1, 1e-3 }, { 1, 2, 1e-3 }, { 2, 3, 1e-3 } });
  for (int i = 1; i < 4; ++i)
  {
    EXPECT_TRUE(labels(i) == labels(i - 1) || labels(i) / 2 != labels(i - 1) / 2);
  }
}

TEST(Charts, APolycubeIsWithoutFault)
{
  const shape::Mesh bracket = CellSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  const shape::Charts charts = shape::FindCharts(bracket, LabelsOf(bracket));
  EXPECT_EQ(charts.Count(), 8);
  EXPECT_EQ(charts.Borders.size(), 18U);
  EXPECT_TRUE(shape::FindChartFaults(charts, bracket.Points, 1e-9).empty());
  EXPECT_EQ(std::count_if(charts.AtPoint.begin(), charts.AtPoint.end(),
              [](const auto& around) { return around.size() == 3; }),
    12);
  // A unit for each of the 8 charts; every point here lies on two or three of them.
  const shape::ConstrainedCoordinates tied = shape::ConstrainCharts(charts, bracket.Points.rows());
  const std::set<int> unknowns(tied.Unknowns.begin(), tied.Unknowns.end());
  EXPECT_EQ(static_cast<int>(unknowns.size()), tied.Count);
  for (std::size_t v = 0; v < charts.AtPoint.size(); ++v)
  {
    for (const int chart : charts.AtPoint[v])
    {
      for (std::size_t u = 0; u < v; ++u)
      {
        const int axis = charts.Labels[chart] / 2;
        const auto& other = charts.AtPoint[u];
        EXPECT_EQ(std::find(other.begin(), other.end(), chart) != other.end(),
          tied.Unknowns(3 * v + axis) == tied.Unknowns(3 * u + axis));
      }
    }
  }
}

TEST(Charts, BadLabelsAreToldByTheirFault)
{
  using Kind = shape::ChartFault::Kind;
  const shape::Mesh cube = CellSurface({ { 0, 0, 0 } });
  const Eigen::VectorXi good = LabelsOf(cube);
  const auto kinds = [&](const Eigen::VectorXi& labels)
  {
    const shape::Charts charts = shape::FindCharts(cube, labels);
    std::set<Kind> found;
    const auto faults = shape::FindChartFaults(charts, cube.Points, 1e-9);
    for (const shape::ChartFault& fault : faults)
    {
      found.insert(fault.What);
    }
    EXPECT_EQ(faults.empty(), shape::DescribeFaults(faults, charts).empty());
    return found;
  };
  EXPECT_TRUE(kinds(good).empty());
  Eigen::VectorXi opposite = good;
  for (int& label : opposite)
  {
    label = label == 2 ? 1 : label; // +y becomes -x, which is beside +x
  }
  EXPECT_EQ(kinds(opposite).count(Kind::Opposite), 1U);
  Eigen::VectorXi few = good;
  for (int& label : few)
  {
    label = label < 4 ? 0 : label; // all around is +x
  }
  EXPECT_EQ(kinds(few).count(Kind::FewNeighbours), 1U);
  Eigen::VectorXi corner = good;
  *std::find(corner.begin(), corner.end(), 4) = 0; // half of a side
  EXPECT_FALSE(kinds(corner).empty());
}

TEST(Charts, ABorderThatTurnsBackIsTold)
{
  const shape::Mesh bar = CellSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } });
  const shape::Charts charts = shape::FindCharts(bar, LabelsOf(bar));
  EXPECT_TRUE(shape::FindChartFaults(charts, bar.Points, 1e-9).empty());
  // The middle of an edge behind its end.
  Eigen::MatrixXd positions = bar.Points;
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    positions(v, 0) = positions(v, 0) == 1.0 ? 2.5 : positions(v, 0);
  }
  const auto faults = shape::FindChartFaults(charts, positions, 1e-9);
  EXPECT_EQ(faults.size(), 4U);
  EXPECT_EQ(faults.front().What, shape::ChartFault::Kind::Turn);
  EXPECT_TRUE(shape::FindChartFaults(charts, positions, 1.0).empty());
}

TEST(AxisAlignment, ATurnedCubeIsTurnedBack)
{
  shape::Mesh cube = CellSurface({ { 0, 0, 0 } });
  EXPECT_EQ(shape::FindAxisRotation(cube), Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  cube.Points = cube.Points * turn.transpose();
  const Eigen::Matrix3d back = shape::FindAxisRotation(cube);
  EXPECT_NEAR(back.determinant(), 1.0, 1e-12);
  const Eigen::MatrixXd normals =
    shape::ComputeAreaVectors(cube).rowwise().normalized() * back.transpose();
  EXPECT_LT((normals.rowwise().lpNorm<Eigen::Infinity>().array() - 1.0).abs().maxCoeff(), 1e-3);
}

TEST(IsotropicRemesh, CreasesAndTopologyStay)
{
  const shape::Mesh cube = CellSurface({ { 0, 0, 0 } });
  shape::IsotropicRemeshOptions options;
  options.EdgeLength = 0.1;
  const shape::Mesh fine = shape::RemeshIsotropically(cube, options);
  EXPECT_EQ(shape::RequireClosedSurface(fine, "the surface").EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(fine), 1.0, 1e-12);
  EXPECT_GT(fine.Triangles.rows(), 1000);
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 80, 40);
  options.EdgeLength = 0.15;
  const shape::Mesh coarse = shape::RemeshIsotropically(torus, options);
  EXPECT_EQ(shape::RequireClosedSurface(coarse, "the surface").EulerNumber, 0);
  EXPECT_LT(coarse.Triangles.rows(), torus.Triangles.rows() / 2);
  EXPECT_NEAR(
    shape::ComputeEnclosedVolume(coarse) / shape::ComputeEnclosedVolume(torus), 1.0, 0.03);
  options.EdgeLength = 0.0;
  EXPECT_THROW(shape::RemeshIsotropically(cube, options), shape::InvalidInput);
}
