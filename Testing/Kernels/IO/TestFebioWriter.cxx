#include "IO/FebioWriter.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace shape::cell_kind;

/// The lines within each list of the mesh, by the tag that opens it, without blanks.
std::map<std::string, std::vector<std::string>> ReadFebio(const shape::MeshSets& sets)
{
  std::stringstream text;
  shape::WriteFebio(text, sets);
  std::map<std::string, std::vector<std::string>> lists;
  std::string line, last, opened;
  const std::regex opening("<(Nodes|Elements|NodeSet|Surface) .*>");
  while (std::getline(text, line))
  {
    line.erase(0, line.find_first_not_of('\t'));
    last = line;
    if (std::regex_match(line, opening))
    {
      EXPECT_EQ(lists.count(line), 0u) << line;
      opened = line;
      lists[opened];
    }
    else if (line.rfind("</", 0) == 0)
    {
      opened.clear();
    }
    else if (!opened.empty())
    {
      lists[opened].push_back(line);
    }
  }
  EXPECT_EQ(last, "</febio_spec>");
  return lists;
}

} // namespace

TEST(FebioWriter, CoordinatesAreReadBackToTheBit)
{
  shape::Cells cells = shapetest::Cubes({ 3, 3, 3 }, shapetest::Everywhere);
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& x : cells.Points.reshaped())
  {
    x = uniform(generator) * std::pow(10.0, 100.0 * uniform(generator));
  }
  const auto lists = ReadFebio(shape::FindMeshSets(cells, {}, 180.0));
  const std::vector<std::string>& nodes = lists.at("<Nodes name=\"Nodes\">");
  ASSERT_EQ(static_cast<Eigen::Index>(nodes.size()), cells.Points.rows());
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    const std::string tag = "<node id=\"" + std::to_string(i + 1) + "\">";
    ASSERT_EQ(nodes[i].rfind(tag, 0), 0u);
    const char* at = nodes[i].c_str() + tag.size();
    for (int k = 0; k < 3; ++k)
    {
      char* end = nullptr;
      EXPECT_EQ(std::strtod(at, &end), cells.Points(i, k));
      at = end + 1;
    }
  }
}

TEST(FebioWriter, PartsSurfacesAndNodeSetsHaveTheNamesOfRegionsAndPatches)
{
  const shape::Cells cells = shapetest::Cubes({ 2, 1, 1 }, shapetest::Everywhere);
  const auto lists = ReadFebio(shape::FindMeshSets(cells, Eigen::Vector2i(0, 3), 40.0));
  EXPECT_EQ(lists.size(), 1u + 2u + 2u * 7u);
  EXPECT_EQ(lists.at("<Elements type=\"hex8\" name=\"Region3\">"),
    std::vector<std::string>{ "<elem id=\"2\">2,3,6,5,8,9,12,11</elem>" });
  EXPECT_EQ(lists.at("<Surface name=\"Interface0_3\">"),
    std::vector<std::string>{ "<quad4 id=\"1\">2,5,11,8</quad4>" });
  EXPECT_EQ(lists.at("<NodeSet name=\"Interface0_3\">"), std::vector<std::string>{ "2,5,8,11" });
  std::size_t faces = 0;
  for (int patch = 0; patch < 6; ++patch)
  {
    faces += lists.at("<Surface name=\"Patch" + std::to_string(patch) + "\">").size();
  }
  EXPECT_EQ(faces, 10u);
}

TEST(FebioWriter, WritesEveryKind)
{
  const shape::Cells solid = shapetest::OneOfEach();
  const auto lists = ReadFebio(shape::FindMeshSets(solid, {}, 40.0));
  EXPECT_EQ(lists.at("<Elements type=\"penta6\" name=\"Region0_penta6\">"),
    std::vector<std::string>{ "<elem id=\"3\">2,6,10,3,7,11</elem>" });
  EXPECT_EQ(lists.count("<Elements type=\"pyra5\" name=\"Region0_pyra5\">"), 1u);
  EXPECT_EQ(lists.count("<Elements type=\"tet4\" name=\"Region0_tet4\">"), 1u);

  shapetest::CellList list;
  list.Add(Triangle, { 0, 1, 2 });
  list.Add(Line, { 3, 4 });
  list.Add(Vertex, { 5 });
  const auto others =
    ReadFebio(shape::FindMeshSets(list.Over(solid.Points), Eigen::Vector3i(0, 1, 0), 40.0));
  EXPECT_EQ(others.at("<Elements type=\"tri3\" name=\"Region0\">").size(), 1u);
  EXPECT_EQ(others.at("<Elements type=\"line2\" name=\"Region1\">"),
    std::vector<std::string>{ "<elem id=\"2\">4,5</elem>" });
  EXPECT_EQ(others.at("<NodeSet name=\"Points\">"), std::vector<std::string>{ "6" });
}
