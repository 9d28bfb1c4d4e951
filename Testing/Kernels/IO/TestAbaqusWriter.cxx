#include "IO/AbaqusWriter.h"
#include "Support/SolverMeshes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// The blocks of an input file: the keyword's line, and the fields of the data lines.
struct Deck
{
  explicit Deck(const shape::MeshSets& sets, const shape::AbaqusWriterOptions& options = {})
  {
    std::stringstream text;
    shape::WriteAbaqus(text, sets, options);
    std::vector<std::vector<std::string>>* block = nullptr;
    for (std::string line; std::getline(text, line);)
    {
      EXPECT_LE(line.size(), 256u);
      if (line.rfind("**", 0) == 0)
      {
        continue;
      }
      if (line[0] == '*')
      {
        EXPECT_EQ(this->Blocks.count(line), 0u) << line << " comes twice";
        block = &this->Blocks[line];
        continue;
      }
      block->emplace_back();
      std::stringstream fields(line);
      for (std::string field; std::getline(fields, field, ',');)
      {
        field.erase(0, field.find_first_not_of(' '));
        EXPECT_LE(field.size(), 20u) << field;
        block->back().push_back(field);
      }
      EXPECT_LE(block->back().size(), 16u);
    }
  }

  std::vector<std::vector<int>> Numbers(const std::string& keyword) const
  {
    std::vector<std::vector<int>> numbers;
    for (const auto& line : this->Blocks.at(keyword))
    {
      numbers.emplace_back();
      std::transform(line.begin(), line.end(), std::back_inserter(numbers.back()),
        [](const std::string& field) { return std::stoi(field); });
    }
    return numbers;
  }

  std::vector<int> Set(const std::string& keyword) const
  {
    std::vector<int> all;
    for (const std::vector<int>& line : this->Numbers(keyword))
    {
      all.insert(all.end(), line.begin(), line.end());
    }
    return all;
  }

  std::map<std::string, std::vector<std::vector<std::string>>> Blocks;
};

std::vector<int> Range(int first, int last)
{
  std::vector<int> range;
  for (int i = first; i <= last; ++i)
  {
    range.push_back(i);
  }
  return range;
}

/// The corners of Abaqus's faces S1, ... of a solid element, as its manual has them.
std::vector<std::vector<int>> AbaqusFaces(std::size_t corners)
{
  switch (corners)
  {
    case 8:
      return { { 1, 2, 3, 4 }, { 5, 8, 7, 6 }, { 1, 5, 6, 2 }, { 2, 6, 7, 3 }, { 3, 7, 8, 4 },
        { 4, 8, 5, 1 } };
    case 6:
      return { { 1, 2, 3 }, { 4, 6, 5 }, { 1, 4, 5, 2 }, { 2, 5, 6, 3 }, { 3, 6, 4, 1 } };
    case 5:
      return { { 1, 2, 3, 4 }, { 1, 5, 2 }, { 2, 5, 3 }, { 3, 5, 4 }, { 4, 5, 1 } };
    default:
      return { { 1, 2, 3 }, { 1, 4, 2 }, { 2, 4, 3 }, { 3, 4, 1 } };
  }
}

} // namespace

TEST(AbaqusWriter, WritesNodesElementsAndPatchesOfABlock)
{
  const shape::Cells cells = shapetest::Cubes({ 2, 3, 4 }, shapetest::Everywhere);
  const Deck deck(shape::FindMeshSets(cells, {}, 40.0));
  const auto& nodes = deck.Blocks.at("*NODE");
  ASSERT_EQ(static_cast<Eigen::Index>(nodes.size()), cells.Points.rows());
  const auto elements = deck.Numbers("*ELEMENT, TYPE=C3D8I, ELSET=Hexahedra");
  ASSERT_EQ(elements.size(), 24u);
  for (int i = 0; i < 24; ++i)
  {
    EXPECT_EQ(elements[i][0], i + 1);
    for (int k = 0; k < 8; ++k)
    {
      EXPECT_EQ(elements[i][k + 1], cells.Corners(8 * i + k) + 1);
    }
  }
  EXPECT_EQ(deck.Set("*ELSET, ELSET=Region0"), Range(1, 24));
  std::multiset<std::size_t> nodesOfPatches, facesOfPatches;
  for (int patch = 0; patch < 6; ++patch)
  {
    nodesOfPatches.insert(deck.Set("*NSET, NSET=Patch" + std::to_string(patch)).size());
    facesOfPatches.insert(
      deck.Blocks.at("*SURFACE, NAME=PatchSurface" + std::to_string(patch) + ", TYPE=ELEMENT")
        .size());
  }
  EXPECT_EQ(nodesOfPatches, (std::multiset<std::size_t>{ 12, 12, 15, 15, 20, 20 }));
  EXPECT_EQ(facesOfPatches, (std::multiset<std::size_t>{ 6, 6, 8, 8, 12, 12 }));
  EXPECT_EQ(deck.Set("*NSET, NSET=Boundary").size(), 60u - 1u * 2u * 3u);
  EXPECT_EQ(deck.Blocks.size(), 1u + 1u + 1u + 12u + 1u);

  shape::AbaqusWriterOptions options;
  options.HexahedronType = shape::HexahedronType::C3D8R;
  EXPECT_EQ(Deck(shape::FindMeshSets(cells, {}, 40.0), options)
              .Blocks.count("*ELEMENT, TYPE=C3D8R, ELSET=Hexahedra"),
    1u);
}

TEST(AbaqusWriter, CoordinatesAreReadBackAsTheyWereWhereTwentyColumnsAreEnough)
{
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0), exponent(-120.0, 120.0);
  shape::Cells cells = shapetest::Cubes({ 20, 20, 20 }, shapetest::Everywhere);
  for (double& x : cells.Points.reshaped())
  {
    // A third of them are about as large as a model is; the others any.
    const double size = exponent(generator) * (generator() % 3 == 0 ? 0.02 : 1.0);
    x = mantissa(generator) * std::pow(10.0, size);
  }
  cells.Points.row(0) << 0.1, -0.01234567890123456, 0.0;
  cells.Points.row(1) << 1e-300, -1.7976931348623157e+308, -5e-324;
  cells.Points.row(2) << -0.0, 12345678901234567.0, -1.2345678901234567e-5;
  const Deck deck(shape::FindMeshSets(cells, {}, 180.0));
  const auto& nodes = deck.Blocks.at("*NODE");
  int exact = 0, rounded = 0;
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    ASSERT_EQ(nodes[i].size(), 4u);
    for (int k = 0; k < 3; ++k)
    {
      const double x = cells.Points(i, k), read = std::strtod(nodes[i][k + 1].c_str(), nullptr);
      const bool fits = x == 0.0 || (std::abs(x) >= 0.01 && std::abs(x) < 1e17);
      EXPECT_LE(std::abs(read - x), fits ? 0.0 : 1e-12 * std::abs(x)) << nodes[i][k + 1];
      fits ? ++exact : ++rounded;
    }
  }
  EXPECT_GT(exact, 5000);
  EXPECT_GT(rounded, 5000);
}

TEST(AbaqusWriter, FacesOfSurfacesAreThoseOfThePatchesAndEachKindHasItsElement)
{
  for (const bool turned : { false, true })
  {
    shape::Cells cells = shapetest::OneOfEach();
    if (turned)
    {
      const int first = cells.Offsets(2);
      std::swap(cells.Corners(first + 1), cells.Corners(first + 2));
      std::swap(cells.Corners(first + 4), cells.Corners(first + 5));
    }
    const shape::MeshSets sets = shape::FindMeshSets(cells, {}, 40.0);
    const Deck deck(sets);
    std::map<int, std::vector<int>> elements;
    for (const auto& [type, set, corners] :
      { std::tuple{ "C3D8I", "Hexahedra", 8u }, std::tuple{ "C3D5", "Pyramids", 5u },
        std::tuple{ "C3D6", "Wedges", 6u }, std::tuple{ "C3D4", "Tetrahedra", 4u } })
    {
      const auto block = deck.Numbers("*ELEMENT, TYPE=" + std::string(type) + ", ELSET=" + set);
      ASSERT_EQ(block.size(), 1u);
      ASSERT_EQ(block[0].size(), corners + 1u);
      elements[block[0][0]] = { block[0].begin() + 1, block[0].end() };
    }
    // C3D6: 1, 2, 3 counter-clockwise seen from 4, 5, 6.
    EXPECT_EQ(elements[3], (std::vector<int>{ 2, 6, 10, 3, 7, 11 }));
    for (int patch = 0; patch < sets.PatchCount; ++patch)
    {
      const std::string number = std::to_string(patch);
      std::set<std::set<int>> expected, found;
      std::set<int> points;
      for (Eigen::Index face = 0; face < sets.Patches.size(); ++face)
      {
        if (sets.Patches(face) == patch)
        {
          std::set<int> corners;
          for (const int corner : sets.Boundary.Corners.row(face))
          {
            if (corner >= 0)
            {
              corners.insert(corner + 1);
            }
          }
          points.insert(corners.begin(), corners.end());
          expected.insert(corners);
        }
      }
      for (const auto& line :
        deck.Blocks.at("*SURFACE, NAME=PatchSurface" + number + ", TYPE=ELEMENT"))
      {
        const std::vector<int>& corners = elements.at(std::stoi(line[0]));
        const auto faces = AbaqusFaces(corners.size());
        std::set<int> face;
        for (const int corner : faces.at(std::stoi(line[1].substr(1)) - 1))
        {
          face.insert(corners[corner - 1]);
        }
        found.insert(face);
      }
      EXPECT_EQ(found, expected);
      const std::vector<int> nodes = deck.Set("*NSET, NSET=Patch" + number);
      EXPECT_EQ(nodes, std::vector<int>(points.begin(), points.end()));
    }
    const std::vector<int> boundary = deck.Set("*NSET, NSET=Boundary");
    EXPECT_EQ(boundary, Range(1, 12)) << "every point but the one that no cell has";
  }
}

TEST(AbaqusWriter, RegionsAreSetsOfTheSolidCellsAndInterfacesLieBetween)
{
  const shape::Cells block = shapetest::Cubes({ 3, 2, 1 }, shapetest::Everywhere);
  shapetest::CellList list;
  for (int cell = 0; cell < 6; ++cell)
  {
    list.Add(
      Hexahedron, { block.Corners.begin() + 8 * cell, block.Corners.begin() + 8 * cell + 8 });
  }
  list.Add(Quadrilateral, { 0, 1, 5, 4 });
  list.Add(Triangle, { 0, 1, 5 });
  list.Add(Line, { 0, 1 });
  list.Add(Vertex, { 7 });
  Eigen::VectorXi regions(10);
  regions << 0, 0, 4, 0, 0, 4, 1, 1, 1, 1;
  const Deck deck(shape::FindMeshSets(list.Over(block.Points), regions, 40.0));
  EXPECT_EQ(deck.Set("*ELSET, ELSET=Region0"), (std::vector<int>{ 1, 2, 4, 5 }));
  EXPECT_EQ(deck.Set("*ELSET, ELSET=Region4"), (std::vector<int>{ 3, 6 }));
  EXPECT_EQ(deck.Blocks.count("*ELSET, ELSET=Region1"), 0u);
  // The points with x = 2.
  EXPECT_EQ(deck.Set("*NSET, NSET=Interface0_4"), (std::vector<int>{ 3, 7, 11, 15, 19, 23 }));
  EXPECT_EQ(
    deck.Set("*ELEMENT, TYPE=S4, ELSET=Quadrilaterals"), (std::vector<int>{ 7, 1, 2, 6, 5 }));
  EXPECT_EQ(deck.Set("*ELEMENT, TYPE=S3, ELSET=Triangles"), (std::vector<int>{ 8, 1, 2, 6 }));
  EXPECT_EQ(deck.Set("*ELEMENT, TYPE=T3D2, ELSET=Lines"), (std::vector<int>{ 9, 1, 2 }));
  EXPECT_EQ(deck.Set("*NSET, NSET=Points"), (std::vector<int>{ 8 }));
}
