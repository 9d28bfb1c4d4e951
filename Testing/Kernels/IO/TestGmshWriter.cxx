#include "IO/GmshWriter.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace shape::cell_kind;

/// An element of a .msh file.
struct GmshElement
{
  int Dimension, Entity, Type;
  std::vector<int> Nodes;
};

/// The content of a .msh file.
struct GmshFile
{
  explicit GmshFile(const shape::MeshSets& sets)
  {
    std::stringstream text;
    shape::WriteGmsh(text, sets);
    std::string word;
    EXPECT_TRUE(text >> word && word == "$MeshFormat");
    while (text >> word)
    {
      if (word == "$PhysicalNames")
      {
        this->ReadNames(text);
      }
      else if (word == "$Nodes")
      {
        this->ReadNodes(text);
      }
      else if (word == "$Elements")
      {
        this->ReadElements(text);
      }
    }
    EXPECT_EQ(word, "$EndElements");
  }

  void ReadNames(std::istream& text)
  {
    int count = 0, dimension = 0, number = 0;
    std::string name;
    text >> count;
    for (; count > 0 && text >> dimension >> number >> name; --count)
    {
      this->Names[{ dimension, number }] = name;
    }
  }

  void ReadNodes(std::istream& text)
  {
    int blocks = 0, all = 0, lowest = 0, highest = 0, dimension = 0, entity = 0, parametric = 1;
    text >> blocks >> all >> lowest >> highest >> dimension >> entity >> parametric >> all;
    EXPECT_EQ(blocks, 1);
    EXPECT_EQ(parametric, 0);
    EXPECT_EQ(lowest, 1);
    EXPECT_EQ(highest, all);
    for (int i = 1, number = 0; i <= all; ++i)
    {
      text >> number;
      EXPECT_EQ(number, i);
    }
    this->Points.resize(all, 3);
    for (double& coordinate : this->Points.reshaped<Eigen::RowMajor>())
    {
      std::string word;
      text >> word;
      coordinate = std::strtod(word.c_str(), nullptr);
    }
  }

  void ReadElements(std::istream& text)
  {
    const std::map<int, int> nodes = { { 15, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 4 }, { 5, 8 },
      { 6, 6 }, { 7, 5 } };
    int blocks = 0, all = 0, lowest = 0, highest = 0;
    text >> blocks >> all >> lowest >> highest;
    for (; blocks > 0; --blocks)
    {
      GmshElement element;
      int count = 0;
      text >> element.Dimension >> element.Entity >> element.Type >> count;
      EXPECT_EQ(this->Names.count({ element.Dimension, element.Entity }), 1u);
      element.Nodes.resize(nodes.at(element.Type));
      for (; count > 0; --count)
      {
        int number = 0;
        text >> number;
        EXPECT_TRUE(number >= lowest && number <= highest);
        for (int& node : element.Nodes)
        {
          text >> node;
        }
        EXPECT_TRUE(this->Elements.emplace(number, element).second) << number;
      }
    }
    EXPECT_EQ(static_cast<int>(this->Elements.size()), all);
  }

  std::map<std::pair<int, int>, std::string> Names;
  Eigen::MatrixXd Points;
  std::map<int, GmshElement> Elements;
};

} // namespace

TEST(GmshWriter, KeepsBitsNumbersRegionsAndPatches)
{
  shape::Cells cells = shapetest::Cubes({ 2, 3, 4 }, shapetest::Everywhere);
  const shape::MeshSets sets = shape::FindMeshSets(cells, Eigen::VectorXi::Unit(24, 5) * 8, 40.0);
  shape::MeshSets moved = sets;
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& x : moved.Mesh.Points.reshaped())
  {
    x = uniform(generator) * std::pow(10.0, 100.0 * uniform(generator));
  }
  const GmshFile file(moved);
  EXPECT_EQ(file.Points, moved.Mesh.Points);
  EXPECT_EQ(file.Names.at({ 3, 1 }), "\"Region0\"");
  EXPECT_EQ(file.Names.at({ 3, 9 }), "\"Region8\"");
  EXPECT_EQ(file.Names.at({ 2, 6 }), "\"Patch5\"");
  EXPECT_EQ(file.Names.at({ 2, 7 }), "\"Interface0_8\"");
  EXPECT_EQ(file.Names.size(), 9u);
  std::map<int, int> faces;
  for (const auto& [number, element] : file.Elements)
  {
    if (number > 24)
    {
      EXPECT_EQ(element.Type, 3);
      ++faces[element.Entity];
      continue;
    }
    EXPECT_EQ(element.Type, 5);
    EXPECT_EQ(element.Entity, number == 6 ? 9 : 1);
    for (int k = 0; k < 8; ++k)
    {
      EXPECT_EQ(element.Nodes[k], cells.Corners(8 * (number - 1) + k) + 1);
    }
  }
  EXPECT_EQ(faces.at(7), 3) << "cube 5 has three other cubes beside it";
  std::vector<int> patches;
  for (int patch = 1; patch <= 6; ++patch)
  {
    patches.push_back(faces.at(patch));
  }
  std::sort(patches.begin(), patches.end());
  EXPECT_EQ(patches, (std::vector<int>{ 6, 6, 8, 8, 12, 12 }));
}

TEST(GmshWriter, WritesEveryKindAndKeepsSurfaceCellsOfTheMesh)
{
  const shape::Cells solid = shapetest::OneOfEach();
  const GmshFile first(shape::FindMeshSets(solid, {}, 40.0));
  const std::vector<int> types = { 5, 7, 6, 4 };
  for (int cell = 0; cell < 4; ++cell)
  {
    EXPECT_EQ(first.Elements.at(cell + 1).Type, types[cell]);
  }
  EXPECT_EQ(first.Elements.at(3).Nodes, (std::vector<int>{ 2, 6, 10, 3, 7, 11 }));
  EXPECT_EQ(first.Elements.size(), 4u + 8u + 6u);

  shapetest::CellList list;
  list.Add(Hexahedron, { 0, 1, 2, 3, 4, 5, 6, 7 });
  list.Add(Quadrilateral, { 0, 3, 2, 1 });
  list.Add(Line, { 0, 1 });
  list.Add(Vertex, { 6 });
  const GmshFile second(
    shape::FindMeshSets(list.Over(solid.Points), Eigen::Vector4i(0, 4, 2, 1), 40.0));
  EXPECT_EQ(second.Elements.size(), 4u);
  EXPECT_EQ(second.Elements.at(2).Nodes, (std::vector<int>{ 1, 4, 3, 2 }));
  EXPECT_EQ(second.Elements.at(2).Entity, 5);
  EXPECT_EQ(second.Elements.at(3).Dimension, 1);
  EXPECT_EQ(second.Elements.at(4).Type, 15);
  EXPECT_EQ(second.Names.at({ 0, 2 }), "\"Region1\"");
}
