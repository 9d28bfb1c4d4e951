#include "IO/DynaWriter.h"
#include "Support/SolverMeshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace shape::cell_kind;

/// The lines after each keyword, cut into columns.
struct DynaFile
{
  explicit DynaFile(const shape::MeshSets& sets)
  {
    std::stringstream text;
    shape::WriteDyna(text, sets);
    std::string line, keyword;
    while (std::getline(text, line))
    {
      if (line[0] == '*')
      {
        keyword = line;
        this->Order.push_back(keyword);
      }
      else if (line[0] != '$')
      {
        this->Lines[keyword].push_back(line);
      }
    }
    EXPECT_EQ(this->Order.front(), "*KEYWORD");
    EXPECT_EQ(this->Order.back(), "*END");
  }

  static std::vector<int> Integers(const std::string& line, std::size_t width)
  {
    std::vector<int> values;
    for (std::size_t at = 0; at < line.size(); at += width)
    {
      values.push_back(std::stoi(line.substr(at, width)));
    }
    return values;
  }

  std::vector<std::string> Order;
  std::map<std::string, std::vector<std::string>> Lines;
};

/// The volume of a solid element. A fourth node that is repeated to the end makes it a tetrahedron,
/// by the manual; other repeated nodes collapse edges. Faces are divided at their centres.
double VolumeOf(const std::vector<int>& nodes, const Eigen::MatrixXd& points)
{
  const int faces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  double volume = 0.0;
  if (std::set<int>(nodes.begin() + 3, nodes.end()).size() == 1)
  {
    const Eigen::RowVector3d origin = points.row(nodes[0] - 1);
    const auto edge = [&](int k) { return Eigen::RowVector3d(points.row(nodes[k] - 1) - origin); };
    return edge(1).cross(edge(2)).dot(edge(3)) / 6.0;
  }
  for (const auto& face : faces)
  {
    Eigen::RowVector3d p[4], centre = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 4; ++k)
    {
      p[k] = points.row(nodes[face[k]] - 1);
      centre += 0.25 * p[k];
    }
    for (int k = 0; k < 4; ++k)
    {
      volume += centre.dot(p[k].cross(p[(k + 1) % 4])) / 6.0;
    }
  }
  return volume;
}

} // namespace

TEST(DynaWriter, SolidsWithRepeatedNodesHaveTheVolumesOfTheirCells)
{
  const shape::Cells cells = shapetest::OneOfEach();
  const DynaFile file(shape::FindMeshSets(cells, {}, 40.0));
  const auto& solids = file.Lines.at("*ELEMENT_SOLID");
  ASSERT_EQ(solids.size(), 4u);
  const std::map<int, double> volumes = { { 1, 1.0 }, { 2, 1.0 / 3.0 }, { 3, 0.5 },
    { 4, 1.0 / 6.0 } };
  for (const std::string& solid : solids)
  {
    std::vector<int> numbers = DynaFile::Integers(solid, 8);
    ASSERT_EQ(numbers.size(), 10u);
    EXPECT_EQ(numbers[1], 1);
    const double expected = volumes.at(numbers[0]);
    numbers.erase(numbers.begin(), numbers.begin() + 2);
    EXPECT_NEAR(VolumeOf(numbers, cells.Points), expected, 1e-15);
  }
}

TEST(DynaWriter, CoordinatesKeepNineDigits)
{
  shape::Cells cells = shapetest::Cubes({ 5, 5, 5 }, shapetest::Everywhere);
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& x : cells.Points.reshaped())
  {
    x = uniform(generator) * std::pow(10.0, 150.0 * uniform(generator));
  }
  const DynaFile file(shape::FindMeshSets(cells, {}, 180.0));
  const auto& nodes = file.Lines.at("*NODE");
  ASSERT_EQ(static_cast<Eigen::Index>(nodes.size()), cells.Points.rows());
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    ASSERT_EQ(nodes[i].size(), 8u + 3 * 16u);
    EXPECT_EQ(std::stoi(nodes[i].substr(0, 8)), i + 1);
    for (int k = 0; k < 3; ++k)
    {
      const double read = std::strtod(nodes[i].substr(8 + 16 * k, 16).c_str(), nullptr);
      EXPECT_NEAR(read / cells.Points(i, k), 1.0, 5e-9) << nodes[i];
    }
  }
}

TEST(DynaWriter, NamesPartsPatchesAndInterfaces)
{
  const shape::Cells cells = shapetest::Cubes({ 2, 1, 1 }, shapetest::Everywhere);
  const DynaFile file(shape::FindMeshSets(cells, Eigen::Vector2i(0, 3), 40.0));
  EXPECT_EQ(file.Lines.at("*PART"),
    (std::vector<std::string>{ "Region0", "         1", "Region3", "         4" }));
  const auto& segments = file.Lines.at("*SET_SEGMENT_TITLE");
  EXPECT_EQ(segments.size(), 7u * 2u + 10u + 1u);
  EXPECT_EQ(segments[segments.size() - 3], "Interface0_3");
  EXPECT_EQ(DynaFile::Integers(segments[segments.size() - 2], 10), std::vector<int>{ 7 });
  // Between the cubes, at x = 1, facing +x.
  EXPECT_EQ(DynaFile::Integers(segments.back(), 10), (std::vector<int>{ 2, 5, 11, 8 }));
  const auto& points = file.Lines.at("*SET_NODE_LIST_TITLE");
  EXPECT_EQ(DynaFile::Integers(points.back(), 10), (std::vector<int>{ 2, 5, 8, 11 }));
}

TEST(DynaWriter, WritesShellsBeamsAndPoints)
{
  shapetest::CellList list;
  list.Add(Triangle, { 0, 1, 2 });
  list.Add(Quadrilateral, { 0, 1, 2, 3 });
  list.Add(Line, { 3, 4 });
  list.Add(Vertex, { 5 });
  const DynaFile file(shape::FindMeshSets(list.Over(shapetest::OneOfEach().Points), {}, 40.0));
  const auto& shells = file.Lines.at("*ELEMENT_SHELL");
  EXPECT_EQ(DynaFile::Integers(shells[0], 8), (std::vector<int>{ 1, 1, 1, 2, 3, 3 }));
  EXPECT_EQ(DynaFile::Integers(shells[1], 8), (std::vector<int>{ 2, 1, 1, 2, 3, 4 }));
  EXPECT_EQ(
    DynaFile::Integers(file.Lines.at("*ELEMENT_BEAM")[0], 8), (std::vector<int>{ 3, 1, 4, 5 }));
  EXPECT_EQ(file.Lines.at("*SET_NODE_LIST_TITLE"),
    (std::vector<std::string>{ "Points", "         1", "         6" }));
}
