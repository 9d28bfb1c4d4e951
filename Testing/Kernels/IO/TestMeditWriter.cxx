#include "IO/MeditWriter.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace shape::cell_kind;

/// The sections of a .mesh file: lines of numbers, references last.
struct File
{
  explicit File(const shape::MeshSets& sets)
  {
    std::stringstream text;
    shape::WriteMedit(text, sets);
    std::string word;
    int number = 0;
    text >> word >> number;
    EXPECT_EQ(word + std::to_string(number), "MeshVersionFormatted2");
    text >> word >> number;
    EXPECT_EQ(word + std::to_string(number), "Dimension3");
    while (text >> word && word != "End")
    {
      EXPECT_EQ(this->Sections.count(word), 0u);
      std::vector<std::vector<double>>& lines = this->Sections[word];
      std::string line;
      std::getline(text, line);
      std::getline(text, line);
      lines.resize(std::stoi(line));
      for (std::vector<double>& numbers : lines)
      {
        std::getline(text, line);
        std::stringstream fields(line);
        for (std::string field; fields >> field;)
        {
          numbers.push_back(std::strtod(field.c_str(), nullptr));
        }
      }
    }
    EXPECT_EQ(word, "End");
  }

  std::map<std::string, std::vector<std::vector<double>>> Sections;
};

} // namespace

TEST(MeditWriter, IsReadBackToTheBit)
{
  shape::Cells cells = shapetest::Cubes({ 2, 3, 4 }, shapetest::Everywhere);
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& x : cells.Points.reshaped())
  {
    x = uniform(generator) * std::pow(10.0, 100.0 * uniform(generator));
  }
  Eigen::VectorXi regions = Eigen::VectorXi::Zero(24);
  regions(5) = 8;
  File file(shape::FindMeshSets(cells, regions, 180.0));
  ASSERT_EQ(file.Sections.size(), 3u);
  const auto& vertices = file.Sections["Vertices"];
  ASSERT_EQ(static_cast<Eigen::Index>(vertices.size()), cells.Points.rows());
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    const std::vector<double> expected = { cells.Points(i, 0), cells.Points(i, 1),
      cells.Points(i, 2), 0.0 };
    EXPECT_EQ(vertices[i], expected);
  }
  const auto& hexahedra = file.Sections["Hexahedra"];
  ASSERT_EQ(hexahedra.size(), 24u);
  for (int i = 0; i < 24; ++i)
  {
    ASSERT_EQ(hexahedra[i].size(), 9u);
    for (int k = 0; k < 8; ++k)
    {
      EXPECT_EQ(hexahedra[i][k], cells.Corners(8 * i + k) + 1);
    }
    EXPECT_EQ(hexahedra[i][8], i == 5 ? 9 : 1);
  }
  // The boundary's quads, and those around region 8.
  EXPECT_EQ(file.Sections["Quadrilaterals"].size(), 2u * (6u + 8u + 12u) + 3u);
}

TEST(MeditWriter, ReferencesOfTheBoundaryAreItsPatchesAndThenTheInterfaces)
{
  const shape::Cells cells = shapetest::Cubes({ 4, 1, 1 }, shapetest::Everywhere);
  File file(shape::FindMeshSets(cells, Eigen::Vector4i(1, 1, 0, 3), 40.0));
  std::map<int, int> counts;
  for (const std::vector<double>& quad : file.Sections["Quadrilaterals"])
  {
    ++counts[static_cast<int>(quad[4])];
    if (quad[4] == 7)
    {
      // Between 0 and 1, seen from 0: at x = 2, facing -x.
      EXPECT_EQ(quad, (std::vector<double>{ 3, 13, 18, 8, 7 }));
    }
  }
  EXPECT_EQ(counts,
    (std::map<int, int>{
      { 1, 1 }, { 2, 4 }, { 3, 4 }, { 4, 4 }, { 5, 4 }, { 6, 1 }, { 7, 1 }, { 8, 1 } }));
}

TEST(MeditWriter, WritesEveryKindAndKeepsSurfaceCellsOfTheMesh)
{
  const shape::Cells solid = shapetest::OneOfEach();
  File first(shape::FindMeshSets(solid, {}, 40.0));
  EXPECT_EQ(first.Sections["Hexahedra"].size(), 1u);
  EXPECT_EQ(first.Sections["Pyramids"][0], (std::vector<double>{ 5, 6, 7, 8, 9, 1 }));
  EXPECT_EQ(first.Sections["Prisms"][0], (std::vector<double>{ 2, 6, 10, 3, 7, 11, 1 }));
  EXPECT_EQ(first.Sections["Tetrahedra"][0], (std::vector<double>{ 6, 7, 9, 12, 1 }));
  EXPECT_EQ(first.Sections["Triangles"].size(), 8u);
  EXPECT_EQ(first.Sections["Quadrilaterals"].size(), 6u);

  shapetest::CellList list;
  list.Add(Hexahedron, { 0, 1, 2, 3, 4, 5, 6, 7 });
  list.Add(Quadrilateral, { 0, 3, 2, 1 });
  list.Add(Line, { 0, 1 });
  list.Add(Vertex, { 6 });
  Eigen::VectorXi regions(4);
  regions << 0, 4, 2, 1;
  File second(shape::FindMeshSets(list.Over(solid.Points), regions, 40.0));
  ASSERT_EQ(second.Sections["Quadrilaterals"].size(), 1u);
  EXPECT_EQ(second.Sections["Quadrilaterals"][0], (std::vector<double>{ 1, 4, 3, 2, 5 }));
  EXPECT_EQ(second.Sections["Edges"][0], (std::vector<double>{ 1, 2, 3 }));
  EXPECT_EQ(second.Sections["Corners"][0], (std::vector<double>{ 7 }));
}
