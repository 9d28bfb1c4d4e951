#include "IO/OFFReader.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{

/// A binary file's numbers: 32 bits, most significant byte first.
void Append(std::string& file, std::uint32_t bits)
{
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    file += static_cast<char>(bits >> shift & 0xFF);
  }
}

void AppendIntegers(std::string& file, std::initializer_list<int> numbers)
{
  for (const int number : numbers)
  {
    Append(file, static_cast<std::uint32_t>(number));
  }
}

void AppendFloats(std::string& file, std::initializer_list<float> numbers)
{
  for (const float number : numbers)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    Append(file, bits);
  }
}

} // namespace

TEST(OFFReader, ReadsPolygonsLinesAndVerticesBetweenComments)
{
  const shape::OFFSurface surface = shape::ReadOFF("# made by hand\nOFF # the keyword\n\n"
                                                   "5 4 0\n0 0 0\n+1 0 -0.0\n1e0 1 .5 # third\n"
                                                   "0 1 0\r\n-2.5e-3 0 1\n"
                                                   "3 0 1 2\n5 0 1 2 3 4\n2 3 4\n1 0");
  const shape::Cells& faces = surface.Faces;
  ASSERT_EQ(faces.Points.rows(), 5);
  EXPECT_EQ(faces.Points.row(2), Eigen::RowVector3d(1.0, 1.0, 0.5));
  EXPECT_EQ(faces.Points(4, 0), -2.5e-3);
  EXPECT_EQ(faces.Kinds, Eigen::Vector4i(7, 7, 3, 1));
  EXPECT_EQ(faces.Offsets, (Eigen::VectorXi(5) << 0, 3, 8, 10, 11).finished());
  EXPECT_EQ(faces.Corners, (Eigen::VectorXi(11) << 0, 1, 2, 0, 1, 2, 3, 4, 3, 4, 0).finished());
  EXPECT_EQ(surface.PointColors.Components, 0);
  EXPECT_EQ(surface.FaceColors.Components, 0);
}

TEST(OFFReader, KeepsColoursNormalsAndTextureCoordinates)
{
  const shape::OFFSurface surface =
    shape::ReadOFF("STCNOFF\n3 4 3\n0 0 0  0 0 1  1 0 0 1  0 0.25\n"
                   "1 0 0  0 0 1  255 128 0 0  1 0\n0 1 0  0 1 0  0 0 0.2  0 1\n"
                   "3 0 1 2\n3 0 1 2 10 20 30\n3 0 1 2 0.5 0 1\n3 2 1 0 7\n");
  EXPECT_EQ(surface.Normals.row(2), Eigen::RowVector3d(0.0, 1.0, 0.0));
  EXPECT_EQ(surface.TextureCoordinates,
    (Eigen::MatrixXd(3, 2) << 0.0, 0.25, 1.0, 0.0, 0.0, 1.0).finished());
  EXPECT_EQ(surface.PointColors.Components, 4);
  EXPECT_EQ(surface.PointColors.Values,
    (std::vector<std::uint8_t>{ 255, 0, 0, 255, 255, 128, 0, 0, 0, 0, 51, 255 }));
  // Without a colour: grey. With an index: the index.
  EXPECT_EQ(surface.FaceColors.Components, 3);
  EXPECT_EQ((std::vector<std::uint8_t>(
              surface.FaceColors.Values.begin(), surface.FaceColors.Values.begin() + 9)),
    (std::vector<std::uint8_t>{ 170, 170, 170, 10, 20, 30, 128, 0, 255 }));
  EXPECT_EQ(surface.FaceColorIndices, (std::vector<int>{ -1, -1, -1, 7 }));
}

TEST(OFFReader, ReadsWithoutKeywordAndWithCountsOnItsLine)
{
  EXPECT_EQ(shape::ReadOFF("1 0 0\n4 5 6").Faces.Points, Eigen::RowVector3d(4.0, 5.0, 6.0));
  EXPECT_EQ(shape::ReadOFF("OFF 1 0\n4 5 6\n").Faces.Points.rows(), 1);
}

TEST(OFFReader, ReadsTheBinaryForm)
{
  std::string file = "COFF BINARY\n";
  AppendIntegers(file, { 3, 2, 0 });
  AppendFloats(file, { 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F });
  AppendFloats(file, { 1.5F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 1.0F });
  AppendFloats(file, { 0.0F, -2.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.5F });
  AppendIntegers(file, { 3, 0, 1, 2, 0 });
  AppendIntegers(file, { 3, 2, 1, 0, 3 });
  AppendFloats(file, { 1.0F, 1.0F, 0.0F });
  const shape::OFFSurface surface = shape::ReadOFF(file);
  EXPECT_EQ(surface.Faces.Points(1, 0), 1.5);
  EXPECT_EQ(surface.Faces.Points(2, 1), -2.0);
  EXPECT_EQ(surface.Faces.Corners, (Eigen::VectorXi(6) << 0, 1, 2, 2, 1, 0).finished());
  EXPECT_EQ(surface.PointColors.Values[11], 128);
  EXPECT_EQ(surface.FaceColors.Values, (std::vector<std::uint8_t>{ 170, 170, 170, 255, 255, 0 }));
  EXPECT_REFUSED(shape::ReadOFF(file.substr(0, file.size() - 4)), "binary file ends too early");
  file[file.size() - 21] = 9; // the last corner of face 1
  EXPECT_REFUSED(shape::ReadOFF(file), "face 1: a face refers to vertex 9");
}

TEST(OFFReader, RefusesWrongFilesWithTheLine)
{
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_REFUSED(shape::ReadOFF(""), "the file ends before the keyword OFF");
  EXPECT_REFUSED(shape::ReadOFF("ply\nformat"), "line 1: 'ply' is no keyword");
  EXPECT_REFUSED(shape::ReadOFF("4OFF\n1 0 0\n0 0 0 1"), "another dimension than 3");
  EXPECT_REFUSED(shape::ReadOFF("OFF\n0 0 0\n"), "line 2: the file declares 0 vertices");
  EXPECT_REFUSED(shape::ReadOFF("OFF\n3 -1 0\n"), "3 vertices and -1 faces");
  EXPECT_REFUSED(shape::ReadOFF("OFF\n2000000000 2000000000 0\n1 2 3\n"), "too short for them");
  EXPECT_REFUSED(shape::ReadOFF("OFF\n99999999999 1 0\n"), "'99999999999' is not an integer");
  EXPECT_REFUSED(shape::ReadOFF(points + "3 0 1 3\n"), "line 6: a face refers to vertex 3");
  EXPECT_REFUSED(shape::ReadOFF(points + "3 0 1 -1\n"), "line 6: a face refers to vertex -1");
  EXPECT_REFUSED(shape::ReadOFF(points + "0      \n"), "line 6: a face has 0 vertices");
  EXPECT_REFUSED(shape::ReadOFF(points + "3 0 1  "), "line 6: the file ends before a face");
  EXPECT_REFUSED(shape::ReadOFF(points + "3 0 1 x"), "line 6: 'x' is not an integer of a face");
  EXPECT_REFUSED(shape::ReadOFF(points + "3 0 1 2 1 2"), "a face is followed by 2 numbers");
  EXPECT_REFUSED(shape::ReadOFF("OFF\n2 0 0\n0 0 nan\n0 0 0\n"), "line 3");
  EXPECT_REFUSED(shape::ReadOFF("OFF\n2 0 0\n0 0 0 1 1 0 0 1 1\n0 0 0\n"), "line 3", "own line");
}
