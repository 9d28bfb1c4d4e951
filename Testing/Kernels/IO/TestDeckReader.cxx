#include "IO/DeckReader.h"

#include "Base/Errors.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace
{

/// Reads a deck whose other files are given by name.
shape::Deck Read(const std::string& name, const std::string& content,
  const std::map<std::string, std::string>& files = {})
{
  return shape::ReadDeck(name, content,
    [&](const std::string& file)
    {
      const auto found = files.find(file);
      return found == files.end() ? throw shape::InvalidInput("no file " + file) : found->second;
    });
}

std::vector<std::int64_t> NumbersOf(const shape::Deck& deck)
{
  std::vector<std::int64_t> numbers;
  for (const shape::DeckNode& node : deck.Nodes)
  {
    numbers.push_back(node.Number);
  }
  return numbers;
}

/// Returns the text of a coordinate in its file.
std::string TextOf(const shape::Deck& deck, int node, int axis)
{
  const shape::DeckNode& at = deck.Nodes[node];
  return deck.Files[at.File].Content.substr(at.Begin[axis], at.Length[axis]);
}

using Numbers = std::vector<std::int64_t>;
using Words = std::vector<std::string>;

} // namespace

TEST(DeckReader, FindsTheTextOfEachCoordinate)
{
  const shape::Deck deck = Read(
    "a.inp", "** comment\r\n*Node , nset=ALL\r\n 7, 1.5D0,\t-2. , +3e-1\r\n9,,4,5\r\n3, 1-2\r\n");
  EXPECT_EQ(NumbersOf(deck), (Numbers{ 7, 9, 3 }));
  EXPECT_EQ(
    deck.Mesh.Points, (Eigen::MatrixXd(3, 3) << 1.5, -2, 0.3, 0, 4, 5, 0.01, 0, 0).finished());
  EXPECT_EQ(TextOf(deck, 0, 0), "1.5D0");
  EXPECT_EQ(TextOf(deck, 0, 1), "-2.");
  EXPECT_EQ(TextOf(deck, 0, 2), "+3e-1");
  EXPECT_EQ(TextOf(deck, 1, 0), "");
  EXPECT_EQ(deck.Nodes[2].Begin[1], shape::DeckNode::NoText);
}

TEST(DeckReader, ReadsElementsOfAbaqusOverSeveralLines)
{
  std::string nodes = "*NODE\n";
  for (int i = 1; i <= 20; ++i)
  {
    nodes += std::to_string(10 * i) + ", " + std::to_string(i) + ", 0, 0\n";
  }
  const shape::Deck deck = Read("a.INP",
    nodes +
      "*ELEMENT, TYPE=c3d20R,\nELSET=Block\n5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100,\n"
      "110, 120, 130, 140, 150, 160, 170, 180, 190, 200\n"
      "*ELEMENT, TYPE=S4R5\n6,10,20,30,40\n*ELEMENT, TYPE=SPRINGA\n7,10,20\n8,10,30\n"
      "*ELEMENT, TYPE=C3D4, ELSET=BLOCK\n9,10,20,30,40\n");
  EXPECT_EQ(deck.Mesh.Kinds, (Eigen::VectorXi(3) << 25, 9, 10).finished());
  EXPECT_EQ(deck.Mesh.Corners.head(20), Eigen::VectorXi::LinSpaced(20, 0, 19));
  EXPECT_EQ(deck.ElementNumbers, (Numbers{ 5, 6, 9 }));
  EXPECT_EQ(deck.RegionNames, (Words{ "BLOCK", "S4R5" }));
  EXPECT_EQ(deck.Regions, (Eigen::VectorXi(3) << 0, 1, 0).finished());
  ASSERT_EQ(deck.Skipped.size(), 1);
  EXPECT_EQ(deck.Skipped[0], (std::pair<std::string, int>("SPRINGA", 2)));
}

TEST(DeckReader, IncludedFilesAreReadInTheirPosition)
{
  const shape::Deck deck = Read("a.inp",
    "*NODE\n1, 0, 0, 0\n*INCLUDE, INPUT=\"more nodes.txt\"\n3, 2, 0, 0\n"
    "*ELEMENT, TYPE=T3D2, INPUT=e.inc\n*MATERIAL, NAME=M\n*INCLUDE, INPUT=m.inc\n"
    "*INCLUDE, INPUT=m.inc\n",
    { { "more nodes.txt", "2, 1, 0, 0\n" }, { "e.inc", "1, 1, 2\n2, 2, 3" },
      { "m.inc", "*ELASTIC\n1, 0.3\n" } });
  EXPECT_EQ(NumbersOf(deck), (Numbers{ 1, 2, 3 }));
  EXPECT_EQ(deck.Nodes[1].File, 1);
  EXPECT_EQ(deck.Mesh.Corners, (Eigen::VectorXi(4) << 0, 1, 1, 2).finished());
  EXPECT_EQ(deck.Files.size(), 4);
}

TEST(DeckReader, PartsNumberTheirNodesIndependently)
{
  const std::string parts = "*Part, name=A\n*Node\n1, 0., 0., 0.\n2, 1., 0., 0.\n"
                            "*Element, type=T3D2\n1, 1, 2\n*End Part\n"
                            "*Part, name=B\n*Node\n1, 5., 0., 0.\n2, 6., 0., 0.\n"
                            "*Element, type=T3D2\n1, 2, 1\n*End Part\n*Assembly, name=All\n";
  const shape::Deck deck = Read("a.inp",
    parts +
      "*Instance, name=A-1, part=A\n*End Instance\n*Instance, name=B-1, part=B\n0., 0., 0.\n"
      "*End Instance\n*Node\n1, 9., 0., 0.\n*End Assembly\n");
  EXPECT_EQ(NumbersOf(deck), (Numbers{ 1, 2, 1, 2, 1 }));
  EXPECT_EQ(deck.Mesh.Corners, (Eigen::VectorXi(4) << 0, 1, 3, 2).finished());
  EXPECT_TRUE(deck.HasParts);
  EXPECT_EQ(deck.Nodes[4].Part, 0);
  EXPECT_REFUSED(Read("a.inp", parts + "*Instance, name=A-1, part=A\n0., 2., 0.\n"), "line 17",
    "A-1", "translated");
  EXPECT_REFUSED(
    Read(
      "a.inp", parts + "*Instance, name=A-1, part=A\n*End Instance\n*Instance, name=A-2, part=A\n"),
    "part A", "2 instances");
}

TEST(DeckReader, ReadsColumnsCommasAndWiderFormatsOfDyna)
{
  const std::string node =
    "       1             1.5            -2.0          3.0E-1       0       0\n";
  const shape::Deck deck = Read("a.k",
    "*KEYWORD\n$ comment\n*NODE\n" + node +
      "       2-1.2345678901234-1.2345678901234\n3,4,5,6\n*NODE %\n"
      "         4               7               8               9\n*NODE+\n"
      "                   5                   1                   2                   3\n"
      "*ELEMENT_SOLID\n       9       4       1       2       3       4       4       4       4    "
      "   4\n"
      "*ELEMENT_SOLID\n      10       4\n       1       2       3       4       5       5       5  "
      "     5\n"
      "*ELEMENT_SHELL_THICKNESS\n11,7,1,2,3,3\n1.,1.,1.,1.\n12,7,1,2,3,4\n1.,1.,1.,1.\n"
      "*ELEMENT_MASS\n 1 2\n*END\n*NODE\nnonsense");
  EXPECT_EQ(NumbersOf(deck), (Numbers{ 1, 2, 3, 4, 5 }));
  EXPECT_EQ(deck.Mesh.Points,
    (Eigen::MatrixXd(5, 3) << 1.5, -2, 0.3, -1.2345678901234, -1.2345678901234, 0, 4, 5, 6, 7, 8, 9,
      1, 2, 3)
      .finished());
  EXPECT_EQ(deck.Nodes[0].Length[0], 16);
  EXPECT_EQ(deck.Nodes[4].Length[0], 20);
  EXPECT_EQ(deck.Mesh.Kinds, (Eigen::VectorXi(4) << 10, 14, 5, 9).finished());
  EXPECT_EQ(deck.ElementNumbers, (Numbers{ 9, 10, 11, 12 }));
  EXPECT_EQ(deck.RegionNames, (Words{ "4", "7" }));
  ASSERT_EQ(deck.Skipped.size(), 1);
}

TEST(DeckReader, ReadsSectionsOfFebio)
{
  const std::string head =
    "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!-- <node id=\"8\">\xe9 -->\n"
    "<febio_spec version='4.0'><Mesh><Nodes name=\"All\">\n";
  const shape::Deck deck = Read("a.feb",
    head +
      "<node id=\"1\">0,0, 0</node>\n<node  id='2' >1 ,0,0</node><node id=\"3\">0,1,0</node>\n"
      "<node id=\"4\">\n0,0,1.50\n</node></Nodes>\n<Elements type=\"tet4\" name=\"Bone\">\n"
      "<elem id=\"1\"> 1, 2,3,4</elem></Elements>\n<Elements type=\"hex27\"><elem id=\"2\">1</elem>"
      "</Elements><NodeSet name=\"s\"><n id=\"1\"/></NodeSet></Mesh></febio_spec>");
  EXPECT_EQ(NumbersOf(deck), (Numbers{ 1, 2, 3, 4 }));
  EXPECT_EQ(TextOf(deck, 1, 0), "1");
  EXPECT_EQ(TextOf(deck, 3, 2), "1.50");
  EXPECT_EQ(deck.Mesh.Kinds, Eigen::VectorXi::Constant(1, 10));
  EXPECT_EQ(deck.RegionNames, Words{ "Bone" });
  EXPECT_EQ(deck.Skipped[0].first, "hex27");
  const shape::Deck old = Read("a.feb",
    "<febio_spec version=\"1.2\"><Geometry><Nodes><node id=\"1\">0,0,0</node><node "
    "id=\"2\">1,0,0</node>"
    "<node id=\"3\">0,1,0</node></Nodes><Elements><tri3 id=\"1\" mat=\"1\">1,2,3</tri3></Elements>"
    "</Geometry></febio_spec>");
  EXPECT_EQ(old.Mesh.Kinds, Eigen::VectorXi::Constant(1, 5));
}

TEST(DeckReader, FindsTheSameNodesWithoutElements)
{
  const std::pair<std::string, std::string> decks[] = {
    { "a.inp", "*NODE\n1,0,0,0\n2,1,0,0\n*ELEMENT, TYPE=T3D2\n1,1,\n2\n*NODE\n3,0,1,0\n" },
    { "a.k",
      "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,3\n*NODE\n4,0,0,1\n*END\n" },
    { "a.feb",
      "<febio_spec><Nodes><node id=\"1\">0,0,0</node><node id=\"2\">1,0,0</node></Nodes>"
      "<Elements type=\"line2\" name=\"A\"><elem id=\"1\">1,2</elem></Elements>"
      "<Nodes><node id=\"3\">0,1,0</node></Nodes></febio_spec>" }
  };
  for (const auto& [name, content] : decks)
  {
    const shape::Deck all = Read(name, content);
    const shape::Deck nodes = shape::ReadDeck(
      name, content, [](const std::string&) { return ""; }, {}, shape::DeckContent::Nodes);
    EXPECT_EQ(all.ElementNumbers.size(), 1u) << name;
    EXPECT_EQ(nodes.ElementNumbers.size(), 0u);
    EXPECT_EQ(NumbersOf(nodes), NumbersOf(all));
    EXPECT_EQ(nodes.Mesh.Points, all.Mesh.Points);
    for (std::size_t i = 0; i < all.Nodes.size(); ++i)
    {
      EXPECT_EQ(nodes.Nodes[i].Begin, all.Nodes[i].Begin);
    }
  }
}

TEST(DeckReader, RefusesNodesThatAreNotWhereTheirCoordinatesSay)
{
  const std::string node = "*NODE\n1, 0, 0, 0\n";
  EXPECT_REFUSED(Read("a.inp", "*SYSTEM\n0,0,0,1,0,0\n" + node), "line 2", "*SYSTEM");
  EXPECT_NO_THROW(Read("a.inp", "*SYSTEM\n" + node));
  EXPECT_REFUSED(Read("a.inp", "*NODE, SYSTEM=C\n1, 0, 0, 0\n"), "line 1", "SYSTEM=C");
  EXPECT_REFUSED(Read("a.inp", node + "*NGEN\n1, 5\n"), "line 3", "*NGEN");
  EXPECT_REFUSED(
    Read("a.k", "*NODE\n1,0,0,0\n*NODE_TRANSFORM\n1,2\n"), "line 3", "*NODE_TRANSFORM");
  EXPECT_REFUSED(Read("a.k", "*INCLUDE_TRANSFORM\nb.k\n"), "*INCLUDE_TRANSFORM");
  EXPECT_REFUSED(Read("a.feb", "<febio_spec><Mesh from=\"b.feb\"/></febio_spec>"), "<Mesh>");
}

TEST(DeckReader, RefusesWrongDecksWithTheLine)
{
  const std::string node = "*NODE\n1, 0, 0, 0\n";
  EXPECT_REFUSED(Read("a.stl", node), ".STL", ".inp");
  EXPECT_REFUSED(Read("a.inp", "*HEADING\n"), "no nodes");
  EXPECT_REFUSED(Read("a.inp", node + "1, 1, 0, 0\n2, 1, 0, 0\n2, 1, 1, 0\n"), "another node: 2",
    "first: node 1");
  EXPECT_REFUSED(Read("a.inp", node + "2, x, 0, 0\n"), "line 3", "'x'");
  EXPECT_REFUSED(Read("a.inp", node + "2, 1e999, 0, 0\n"), "line 3", "1e999");
  EXPECT_REFUSED(Read("a.inp", node + "*ELEMENT, TYPE=T3D2\n4, 1, 5\n"), "element 4", "node 5");
  EXPECT_REFUSED(Read("a.inp", node + "*ELEMENT, TYPE=S4\n4, 1, 1\n*STEP\n"), "line 5", "element 4",
    "2 nodes", "S4");
  EXPECT_REFUSED(Read("a.inp", node + "*INCLUDE, INPUT=b\n", { { "b", "*INCLUDE, INPUT=b\n" } }),
    "included file 'b', line 1", "itself");
  EXPECT_REFUSED(Read("a.inp", node + "*INCLUDE, INPUT=c\n"), "line 3", "no file c");
  EXPECT_REFUSED(Read("a.k", "*NODE\n       1              &x\n"), "line 2", "&x");
  EXPECT_REFUSED(Read("a.k", "*NODE\n1,0,0,0\n*ELEMENT_SOLID\n1,1,1,1\n"), "line 4", "2 nodes");
  EXPECT_REFUSED(Read("a.feb", "<html>"), "febio_spec");
  EXPECT_REFUSED(Read("a.feb", "<febio_spec><Nodes><node id=\"1\">0,0</node>"), "node 1", "three");
  EXPECT_REFUSED(Read("a.feb", "<febio_spec><!-- "), "no end");
}
