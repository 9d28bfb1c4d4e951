#include "IO/HTMLWriter.h"
#include "Support/Refusals.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace
{

std::string Write(const shape::MeshPage& page)
{
  std::stringstream file;
  shape::WriteHTML(file, page);
  return file.str();
}

/// Decodes what follows `"key":"`, as the page does.
template <typename Number>
std::vector<Number> Decode(const std::string& file, const std::string& key, std::size_t count)
{
  const std::size_t first = file.find('"' + key + "\":\"") + key.size() + 4;
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> packed;
  std::uint32_t bits = 0;
  int known = 0;
  for (std::size_t i = first; letters.find(file[i]) != std::string::npos; ++i)
  {
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(file[i]));
    known += 6;
    if (known >= 8)
    {
      known -= 8;
      packed.push_back(static_cast<unsigned char>(bits >> known));
    }
  }
  std::vector<unsigned char> grouped(4 * count);
  uLongf size = grouped.size();
  EXPECT_EQ(uncompress(grouped.data(), &size, packed.data(), packed.size()), Z_OK);
  EXPECT_EQ(size, 4 * count);
  std::vector<Number> numbers(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      word |= static_cast<std::uint32_t>(grouped[k * count + i]) << (8 * k);
    }
    std::memcpy(&numbers[i], &word, 4);
  }
  return numbers;
}

} // namespace

TEST(HTMLWriter, HoldsPointsCellsAndValuesToTheBit)
{
  shape::MeshPage page;
  page.Mesh = shapetest::Cubes({ 3, 2, 2 }, shapetest::Everywhere);
  page.Mesh.Points *= 1.0 / 3.0;
  page.Arrays = { { "Quality", true, 1, std::vector<float>(12, 0.1F) } };
  page.Arrays[0].Values[7] = -2.5e-7F;
  const std::string file = Write(page);
  const std::size_t points = page.Mesh.Points.rows();
  const auto coordinates = Decode<float>(file, "points", 3 * points);
  for (std::size_t i = 0; i < points; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(coordinates[3 * i + k],
        static_cast<float>(page.Mesh.Points(static_cast<Eigen::Index>(i), k)));
    }
  }
  EXPECT_EQ(Decode<std::int32_t>(file, "kinds", 12), std::vector<std::int32_t>(12, 12));
  EXPECT_EQ(Decode<std::int32_t>(file, "sizes", 12), std::vector<std::int32_t>(12, 8));
  const auto differences = Decode<std::int32_t>(file, "corners", 96);
  int corner = 0;
  for (int i = 0; i < 96; ++i)
  {
    corner += differences[i];
    EXPECT_EQ(corner, page.Mesh.Corners(i));
  }
  EXPECT_EQ(Decode<float>(file, "values", 12), page.Arrays[0].Values);
}

TEST(HTMLWriter, LeavesOutVerticesAndLinesWithTheirValues)
{
  shapetest::CellList list;
  list.Add(shape::cell_kind::Line, { 0, 1 });
  list.Add(shape::cell_kind::Triangle, { 0, 1, 2 });
  list.Add(shape::cell_kind::Vertex, { 2 });
  list.Add(7, { 0, 1, 3, 2 });
  const shape::MeshPage page{ "", {}, list.Over(Eigen::MatrixXd::Random(4, 3)),
    { { "Id", true, 2, { 0, 0, 1, 1, 2, 2, 3, 3 } } } };
  const std::string file = Write(page);
  EXPECT_EQ(Decode<std::int32_t>(file, "kinds", 2), (std::vector<std::int32_t>{ 5, 7 }));
  EXPECT_EQ(Decode<std::int32_t>(file, "sizes", 2), (std::vector<std::int32_t>{ 3, 4 }));
  EXPECT_EQ(Decode<float>(file, "values", 4), (std::vector<float>{ 1, 1, 3, 3 }));
}

TEST(HTMLWriter, NeedsNoOtherFileAndKeepsWordsFromEndingTheScript)
{
  shape::MeshPage page;
  page.Mesh = shapetest::Cubes({ 1, 1, 1 }, shapetest::Everywhere);
  page.Title = "</script> \"quoted\" \\ \n";
  page.Facts = { { "Reason", "<b>" } };
  const std::string file = Write(page);
  EXPECT_NE(file.find(R"("title":"\u003c/script\u003e \u0022quoted\u0022 \u005c \u000a")"),
    std::string::npos);
  EXPECT_NE(file.find(R"([["Reason","\u003cb\u003e"]])"), std::string::npos);
  for (const char* outside : { "http:", "https:", "src=", "href=", "import " })
  {
    EXPECT_EQ(file.find(outside), std::string::npos) << outside;
  }
}

TEST(HTMLWriter, RefusesWhatAPageCannotShow)
{
  shapetest::CellList list;
  list.Add(shape::cell_kind::Line, { 0, 1 });
  shape::MeshPage page;
  page.Mesh = list.Over(Eigen::MatrixXd::Random(4, 3));
  EXPECT_REFUSED(Write(page), "no surface or solid cells");
  list.Add(24, { 0, 1, 2, 3, 0, 1, 2, 3, 0, 1 });
  page.Mesh = list.Over(Eigen::MatrixXd::Random(4, 3));
  EXPECT_REFUSED(Write(page), "cell 1 has VTK's cell type 24");
}
