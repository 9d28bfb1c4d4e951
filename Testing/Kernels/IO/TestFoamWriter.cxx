#include "IO/FoamWriter.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/// The words of each file after its header; brackets and semicolons are words.
std::map<std::string, std::vector<std::string>> ReadFoam(const shape::PolyMesh& mesh)
{
  std::map<std::string, std::vector<std::string>> files;
  for (const shape::FoamFile& file : shape::GetFoamFiles())
  {
    std::stringstream text;
    file.Write(text, mesh, {});
    std::string spaced;
    for (const char letter : text.str())
    {
      const bool alone = std::string("(){};").find(letter) != std::string::npos;
      spaced += alone ? std::string(" ") + letter + ' ' : std::string(1, letter);
    }
    std::stringstream words(spaced.substr(spaced.find('}') + 1));
    EXPECT_NE(spaced.find(std::string("object      ") + file.Name), std::string::npos);
    for (std::string word; words >> word;)
    {
      files[file.Name].push_back(word);
    }
  }
  return files;
}

std::vector<std::string> SplitWords(const std::string& text)
{
  std::stringstream stream(text);
  return { std::istream_iterator<std::string>(stream), {} };
}

shape::MeshSets TwoCubes()
{
  return shape::FindMeshSets(
    shapetest::Cubes({ 2, 1, 1 }, shapetest::Everywhere), Eigen::Vector2i(6, 2), 40.0);
}

} // namespace

TEST(FoamWriter, WritesTheListsOfTwoCubes)
{
  auto files = ReadFoam(shape::MakePolyMesh(TwoCubes()));
  ASSERT_EQ(files.size(), 7u);
  EXPECT_EQ(files["neighbour"], SplitWords("1 ( 1 )"));
  const std::vector<std::string>& owner = files["owner"];
  EXPECT_EQ(owner.size(), 14u);
  EXPECT_EQ(owner.front(), "11");
  const std::vector<std::string>& faces = files["faces"];
  ASSERT_EQ(faces.size(), 3u + 11u * 7u);
  EXPECT_EQ(
    std::vector<std::string>(faces.begin() + 2, faces.begin() + 9), SplitWords("4 ( 1 4 10 7 )"))
    << "the face between the cubes faces towards +x";
  EXPECT_EQ(files["cellZones"],
    SplitWords("2 ( Region2 { type cellZone ; cellLabels List<label> 1 ( 1 ) ; } "
               "Region6 { type cellZone ; cellLabels List<label> 1 ( 0 ) ; } )"));
  EXPECT_EQ(files["faceZones"],
    SplitWords("1 ( Interface2_6 { type faceZone ; faceLabels List<label> 1 ( 0 ) ; "
               "flipMap List<bool> 1 ( 1 ) ; } )"))
    << "cube 0, which the face leaves, is in the upper region";
  const std::vector<std::string>& boundary = files["boundary"];
  const std::vector<std::string> first(boundary.begin(), boundary.begin() + 13);
  EXPECT_EQ(first, SplitWords("6 ( Patch0 { type patch ; nFaces 1 ; startFace 1 ;"));
}

TEST(FoamWriter, KeepsTheBitsOfCoordinates)
{
  shape::PolyMesh mesh = shape::MakePolyMesh(TwoCubes());
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& x : mesh.Points.reshaped())
  {
    x = uniform(generator) * std::pow(10.0, 100.0 * uniform(generator));
  }
  const std::vector<std::string> words = ReadFoam(mesh)["points"];
  ASSERT_EQ(words.size(), 3u + 12u * 5u);
  EXPECT_EQ(words[0], "12");
  for (int point = 0; point < 12; ++point)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(std::strtod(words[3 + 5 * point + k].c_str(), nullptr), mesh.Points(point, k));
    }
  }
}

TEST(FoamWriter, EmptiesTheZonesOfAnOlderMesh)
{
  const shape::Cells cells = shapetest::Cubes({ 2, 2, 1 }, shapetest::Everywhere);
  auto files = ReadFoam(shape::MakePolyMesh(shape::FindMeshSets(cells, {}, 40.0)));
  EXPECT_EQ(files["faceZones"], SplitWords("0 ( )"));
}
