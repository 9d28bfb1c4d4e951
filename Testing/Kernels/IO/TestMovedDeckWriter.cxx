#include "IO/DeckReader.h"
#include "IO/MovedDeckWriter.h"

#include "IO/Private/ColumnText.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace
{

shape::Deck ReadAlone(const std::string& name, const std::string& content)
{
  return shape::ReadDeck(name, content, [](const std::string&) { return ""; });
}

std::string Write(const shape::Deck& deck, const Eigen::MatrixXd& positions)
{
  std::stringstream file;
  shape::WriteMovedFile(file, deck, 0, positions);
  return file.str();
}

/// Returns the bytes of the deck outside of coordinates.
std::string Rest(const shape::Deck& deck)
{
  std::string content = deck.Files[0].Content;
  for (auto node = deck.Nodes.rbegin(); node != deck.Nodes.rend(); ++node)
  {
    for (int k = 2; k >= 0; --k)
    {
      node->Begin[k] == shape::DeckNode::NoText ? content
                                                : content.erase(node->Begin[k], node->Length[k]);
    }
  }
  return content;
}

/// All that may be around nodes: CR LF, tabs, bytes of Latin 1, no line end at the end.
const char* const Abaqus =
  "** b\xfchne\r\n*Node , nset=ALL\r\n 1, 0.10 ,\t2.,3\r\n\r\n** 5, 5\r\n2, -1E0,,0\r\n"
  "*Element,type=T3D2\r\n1,1,2\r\n*STEP\r\n*NODE PRINT\r\nU";
const char* const Dyna =
  "*KEYWORD\n*NODE\n       1             0.1              2.               3       7       0\n"
  "$ x\n2, 1.0 , 2,3,4\n*SET_NODE\n       1\n";
const char* const Febio =
  "<febio_spec>\n<Nodes><node id=\"1\"> 0.1,2, 3 </node><node id=\"2\">1,1,1</node></Nodes>\n"
  "<!-- \xe9 --></febio_spec>\n\n";

} // namespace

TEST(MovedDeckWriter, TheIdentityWritesTheSameBytes)
{
  for (const auto& [name, content] :
    { std::pair("a.inp", Abaqus), { "a.k", Dyna }, { "a.feb", Febio } })
  {
    const shape::Deck deck = ReadAlone(name, content);
    EXPECT_EQ(Write(deck, deck.Mesh.Points), content);
  }
}

TEST(MovedDeckWriter, OnlyCoordinatesChangeAndAreReadBack)
{
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  for (const auto& [name, content] :
    { std::pair("a.inp", Abaqus), { "a.k", Dyna }, { "a.feb", Febio } })
  {
    const shape::Deck deck = ReadAlone(name, content);
    for (int repeat = 0; repeat < 50; ++repeat)
    {
      Eigen::MatrixXd positions = deck.Mesh.Points;
      for (double& x : positions.reshaped())
      {
        x = normal(generator) * std::pow(10.0, 30.0 * normal(generator));
      }
      const shape::Deck written = ReadAlone(name, Write(deck, positions));
      EXPECT_EQ(Rest(written), Rest(deck));
      const double bound = deck.Nodes[0].Columns == 0 ? 0.0
        : deck.Nodes[0].Columns == 16                 ? 1e-8
                                                      : 1e-12;
      const Eigen::ArrayXXd error = (written.Mesh.Points - positions).array().abs();
      EXPECT_TRUE((error <= bound * positions.array().abs()).all());
    }
  }
}

TEST(MovedDeckWriter, UnmovedCoordinatesKeepTheirBytes)
{
  const shape::Deck deck = ReadAlone("a.inp", Abaqus);
  Eigen::MatrixXd positions = deck.Mesh.Points;
  positions(1, 1) = 7.5;
  std::string expected = Abaqus;
  EXPECT_EQ(Write(deck, positions), expected.insert(expected.find(",,") + 1, "7.5"));
}

TEST(MovedDeckWriter, ColumnsAreFilledFromTheRight)
{
  const shape::Deck deck = ReadAlone("a.k", Dyna);
  Eigen::MatrixXd positions = deck.Mesh.Points;
  positions(0, 1) = -0.25;
  std::string expected = Dyna;
  EXPECT_EQ(Write(deck, positions),
    expected.replace(expected.find("              2."), 16, "            -.25"));
}

TEST(MovedDeckWriter, TheTextInColumnsIsTheNearestOfItsLength)
{
  EXPECT_EQ(shape::ToColumnText(0.5, 16), ".5");
  EXPECT_EQ(shape::ToColumnText(-2.0, 16), "-2.");
  EXPECT_EQ(shape::ToColumnText(1e-5, 16), "1e-5");
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i)
  {
    const double value = normal(generator) * std::pow(10.0, 20.0 * normal(generator));
    const std::string text = shape::ToColumnText(value, 16);
    ASSERT_LE(text.size(), 16);
    // No other number with the same digits after its point is nearer.
    const double read = std::stod(text);
    const std::size_t point = text.find('.'), exponent = text.find('e');
    const std::size_t digits = std::min(exponent, text.size()) - point - 1;
    const double unit = std::pow(10.0,
      (exponent == std::string::npos ? 0.0 : std::stod(text.substr(exponent + 1))) -
        double(digits));
    EXPECT_LE(std::abs(read - value), 0.5000001 * unit + 1e-15 * std::abs(value)) << text;
  }
}

TEST(MovedDeckWriter, NodesAreFoundByTheirNumbers)
{
  const shape::Deck deck = ReadAlone("a.inp", "*NODE\n40, 0, 0, 0\n7, 1, 0, 0\n900000, 2, 0, 0\n");
  shape::NumberedPoints moved;
  moved.Points = (Eigen::MatrixXd(4, 3) << 7, 7, 7, 9, 9, 9, 4, 4, 4, 7, 7, 7).finished();
  moved.Numbers = { 7, 900000, 40, 7 };
  const Eigen::MatrixXd expected = (Eigen::MatrixXd(3, 3) << 4, 4, 4, 7, 7, 7, 9, 9, 9).finished();
  EXPECT_EQ(shape::FindMovedNodes(deck, moved), expected);
  const auto refused = [&](const shape::NumberedPoints& points)
  { return shape::FindMovedNodes(deck, points); };
  shape::NumberedPoints wrong = moved;
  wrong.Points(3, 0) = 8;
  EXPECT_REFUSED(refused(wrong), "two positions in the Input: 1", "node 7");
  wrong = moved;
  wrong.Numbers[1] = 40;
  wrong.Points.row(1) = wrong.Points.row(2);
  EXPECT_REFUSED(refused(wrong), "missing in the Input: 1", "node 900000");
  wrong = moved;
  wrong.Numbers[1] = 41;
  EXPECT_REFUSED(refused(wrong), "does not have", "node 41");
  wrong = moved;
  wrong.Points(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(refused(wrong), "not finite", "node 900000");
}

TEST(MovedDeckWriter, RefusesToMoveCoordinatesThatTheDeckLeavesOut)
{
  const shape::Deck deck = ReadAlone("a.inp", "*NODE\n1, 0, 0\n2, 1, 0\n");
  shape::NumberedPoints moved{ deck.Mesh.Points, { 1, 2 }, {} };
  moved.Points(1, 1) = 5;
  EXPECT_EQ(Write(deck, shape::FindMovedNodes(deck, moved)), "*NODE\n1, 0, 0\n2, 1, 5.\n");
  moved.Points(1, 2) = 5;
  EXPECT_REFUSED(shape::FindMovedNodes(deck, moved), "leaves out: 1", "node 2");
}
