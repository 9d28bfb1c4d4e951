#include "IO/ImageReader.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{

constexpr std::array<int, 3> Size = { 3, 4, 5 };

/// Numbers that differ from voxel to voxel.
std::string MakeValues()
{
  std::string values(3 * 4 * 5, '\0');
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<char>(3 * i);
  }
  return values;
}

std::string Write(const std::string& ending, const std::string& content)
{
  const std::string path =
    testing::TempDir() + "TestImageReader" + std::to_string(getpid()) + ending;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

std::string MakeNRRD(const std::string& space, const std::string& origin,
  const std::string& directions, const std::string& sizes = "3 4 5")
{
  return "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: " + space + "\nsizes: " + sizes +
    "\nspace directions: " + directions + "\nkinds: domain domain domain\nencoding: raw\n" +
    "space origin: " + origin + "\n\n" + MakeValues();
}

/// A NIfTI file whose voxel (i, j, k) is at (rows (i, j, k, 1)^T), in NIfTI's axes: x to the right,
/// y to the front. sizes: the number of dimensions and their lengths.
std::string MakeNIfTI(const std::array<std::array<float, 4>, 3>& rows,
  const std::array<std::int16_t, 8>& sizes = { 3, 3, 4, 5, 1, 1, 1, 1 })
{
  std::string file(352, '\0');
  const auto put = [&](std::size_t offset, auto value)
  { std::memcpy(file.data() + offset, &value, sizeof value); };
  put(0, std::int32_t{ 348 });
  put(40, sizes);
  put(70, std::int16_t{ 2 }); // unsigned char
  put(72, std::int16_t{ 8 });
  put(76, std::array<float, 4>{ 1.0f, 2.0f, 3.0f, 4.0f });
  put(108, 352.0f);
  put(112, 1.0f);
  put(254, std::int16_t{ 1 });
  put(280, rows);
  std::memcpy(file.data() + 344, "n+1", 4);
  return file + MakeValues();
}

void ExpectImage(const std::string& path, const std::array<double, 3>& origin,
  const std::array<double, 9>& directions)
{
  const shape::ImageHeader header = shape::ReadImageHeader(path);
  EXPECT_EQ(header.Size, Size) << path;
  EXPECT_EQ(header.Number, shape::ImageNumber::UInt8);
  EXPECT_EQ(header.Components, 1);
  EXPECT_EQ(header.Spacing, (std::array<double, 3>{ 2.0, 3.0, 4.0 })) << path;
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(header.Origin[axis], origin[axis], 1e-5) << path << axis;
  }
  for (int k = 0; k < 9; ++k)
  {
    EXPECT_NEAR(header.Directions[k], directions[k], 1e-6) << path << k;
  }
  std::string values(header.GetNumberOfVoxels(), '\0');
  shape::ReadImage(path, values.data());
  EXPECT_EQ(values, MakeValues()) << path;
}

} // namespace

// The same image, whose first index goes to the patient's right, in three formats.
TEST(ImageReader, FormatsAgreeOnLeftAndRight)
{
  const std::array<double, 3> origin{ 100.0, -7.0, 9.0 };
  const std::array<double, 9> directions{ -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  ExpectImage(
    Write(".nrrd", MakeNRRD("left-posterior-superior", "(100,-7,9)", "(-2,0,0) (0,3,0) (0,0,4)")),
    origin, directions);
  ExpectImage(Write(".ras.nrrd",
                MakeNRRD("right-anterior-superior", "(-100,7,9)", "(2,0,0) (0,-3,0) (0,0,4)")),
    origin, directions);
  ExpectImage(Write(".mha",
                "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                "CompressedData = False\nTransformMatrix = -1 0 0 0 1 0 0 0 1\nOffset = 100 -7 9\n"
                "ElementSpacing = 2 3 4\nDimSize = 3 4 5\nElementType = MET_UCHAR\n"
                "ElementDataFile = LOCAL\n" +
                  MakeValues()),
    origin, directions);
  ExpectImage(Write(".nii", MakeNIfTI({ { { 2, 0, 0, -100 }, { 0, -3, 0, 7 }, { 0, 0, 4, 9 } } })),
    origin, directions);
}

TEST(ImageReader, ObliqueAxesAreOrthonormal)
{
  // The first two indices turn by atan(3/4) about z.
  ExpectImage(Write(".oblique.nrrd",
                MakeNRRD("left-posterior-superior", "(0,0,0)", "(1.6,1.2,0) (-1.8,2.4,0) (0,0,4)")),
    { 0.0, 0.0, 0.0 }, { 0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0 });
}

TEST(ImageReader, RefusesWhatItCannotRead)
{
  const auto refuse =
    [](const std::string& ending, const std::string& content, const std::vector<std::string>& words)
  {
    const std::string path = Write(ending, content);
    const auto read = [&]()
    {
      std::vector<char> values(shape::ReadImageHeader(path).GetNumberOfVoxels());
      shape::ReadImage(path, values.data());
    };
    EXPECT_TRUE(shapetest::HasWords(shapetest::Refusal(read), words));
  };
  refuse(".nrrd", "", { "no NRRD, MetaImage or NIfTI image", "export" });
  refuse(".stl", "solid of STL\n", { "no NRRD, MetaImage or NIfTI image" });
  std::string cut = MakeNRRD("left-posterior-superior", "(0,0,0)", "(2,0,0) (0,3,0) (0,0,4)");
  cut.resize(cut.size() - 7);
  refuse(".cut.nrrd", cut, { "ITK cannot read it", "write it again" });
  refuse(".time.nii",
    MakeNIfTI({ { { 2, 0, 0, 0 }, { 0, 3, 0, 0 }, { 0, 0, 4, 0 } } }, { 4, 3, 4, 1, 5, 1, 1, 1 }),
    { "4 dimensions", "5 images", "a file of its own" });
}
