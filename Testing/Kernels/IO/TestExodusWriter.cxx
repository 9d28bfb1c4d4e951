#include "IO/ExodusWriter.h"
#include "Support/SolverMeshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace shape::cell_kind;

namespace
{

/// Variables of a file in netCDF's classic format, and their attributes.
class FileContent
{
public:
  explicit FileContent(std::string bytes)
    : Bytes(std::move(bytes))
  {
    EXPECT_EQ(this->Take(4), "CDF\2");
    EXPECT_EQ(this->TakeNumber(), 0) << "records";
    this->TakeList(10,
      [&]
      {
        const std::string name = this->TakeName();
        this->Dimensions.emplace_back(name, this->TakeNumber());
      });
    this->TakeAttributes();
    this->TakeList(11,
      [&]
      {
        Variable variable;
        const std::string name = this->TakeName();
        const int dimensions = this->TakeNumber();
        variable.Count = 1;
        for (int k = 0; k < dimensions; ++k)
        {
          variable.Count *= this->Dimensions[this->TakeNumber()].second;
        }
        variable.Attributes = this->TakeAttributes();
        variable.Type = this->TakeNumber();
        EXPECT_EQ(this->TakeNumber() % 4, 0);
        EXPECT_EQ(this->TakeNumber(), 0) << "upper half of the offset";
        variable.Offset = this->TakeNumber();
        EXPECT_EQ(variable.Offset % 4, 0);
        this->Variables[name] = variable;
      });
  }

  int FindDimension(const std::string& name) const
  {
    for (const auto& [known, length] : this->Dimensions)
    {
      if (known == name)
      {
        return length;
      }
    }
    return -1;
  }

  std::vector<int> ReadIntegers(const std::string& name)
  {
    const Variable& variable = this->Variables.at(name);
    EXPECT_EQ(variable.Type, 4);
    this->Position = variable.Offset;
    std::vector<int> values(variable.Count);
    for (int& value : values)
    {
      value = this->TakeNumber();
    }
    return values;
  }

  std::vector<double> ReadDoubles(const std::string& name)
  {
    const Variable& variable = this->Variables.at(name);
    EXPECT_EQ(variable.Type, 6);
    std::vector<double> values(variable.Count);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      std::string bytes = this->Bytes.substr(variable.Offset + 8 * i, 8);
      std::reverse(bytes.begin(), bytes.end());
      std::memcpy(&values[i], bytes.data(), 8);
    }
    return values;
  }

  std::vector<std::string> ReadTexts(const std::string& name)
  {
    const Variable& variable = this->Variables.at(name);
    EXPECT_EQ(variable.Type, 2);
    std::vector<std::string> texts;
    for (int i = 0; i < variable.Count; i += 33)
    {
      texts.emplace_back(this->Bytes.substr(variable.Offset + i, 33).c_str());
    }
    return texts;
  }

  std::string FindType(const std::string& variable) const
  {
    return this->Variables.at(variable).Attributes.at("elem_type");
  }

private:
  struct Variable
  {
    int Count = 0, Type = 0, Offset = 0;
    std::map<std::string, std::string> Attributes;
  };

  std::string Take(std::size_t count)
  {
    this->Position += count;
    return this->Bytes.substr(this->Position - count, count);
  }

  int TakeNumber()
  {
    int number = 0;
    for (const char byte : this->Take(4))
    {
      number = number << 8 | static_cast<unsigned char>(byte);
    }
    return number;
  }

  std::string TakeName()
  {
    const int length = this->TakeNumber();
    return this->Take((length + 3) / 4 * 4).substr(0, length);
  }

  template <class TakeOne>
  void TakeList(int code, const TakeOne& takeOne)
  {
    const int found = this->TakeNumber(), length = this->TakeNumber();
    EXPECT_EQ(found, length == 0 ? 0 : code);
    for (int i = 0; i < length; ++i)
    {
      takeOne();
    }
  }

  std::map<std::string, std::string> TakeAttributes()
  {
    std::map<std::string, std::string> attributes;
    this->TakeList(12,
      [&]
      {
        const std::string name = this->TakeName();
        const int type = this->TakeNumber();
        if (type == 2)
        {
          attributes[name] = this->TakeName();
          return;
        }
        EXPECT_EQ(this->TakeNumber(), 1);
        this->TakeNumber();
      });
    return attributes;
  }

  std::string Bytes;
  std::size_t Position = 0;
  std::vector<std::pair<std::string, int>> Dimensions;
  std::map<std::string, Variable> Variables;
};

FileContent Write(const shape::Cells& cells, const Eigen::VectorXi& regions)
{
  std::stringstream file;
  shape::WriteExodus(file, shape::FindMeshSets(cells, regions, 40.0));
  return FileContent(file.str());
}

/// The nodes of each side, counter-clockwise seen from outside, from the manual's tables of sides.
const std::map<std::string, std::vector<std::vector<int>>> SidesOf = {
  { "HEX8",
    { { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 4, 8, 7 }, { 1, 5, 8, 4 }, { 1, 4, 3, 2 },
      { 5, 6, 7, 8 } } },
  { "TETRA4", { { 1, 2, 4 }, { 2, 3, 4 }, { 1, 4, 3 }, { 1, 3, 2 } } },
  { "WEDGE6", { { 1, 2, 5, 4 }, { 2, 3, 6, 5 }, { 1, 4, 6, 3 }, { 1, 3, 2 }, { 4, 5, 6 } } },
  { "PYRAMID5", { { 1, 2, 5 }, { 2, 3, 5 }, { 3, 4, 5 }, { 1, 5, 4 }, { 1, 4, 3, 2 } } }
};

/// Returns the sum over the sides of a set: area vectors, and six times the volume below them.
std::pair<Eigen::Vector3d, double> Measure(FileContent& file, const std::string& number)
{
  std::array<std::vector<double>, 3> coordinates{ file.ReadDoubles("coordx"),
    file.ReadDoubles("coordy"), file.ReadDoubles("coordz") };
  std::vector<std::pair<std::string, std::vector<int>>> elements;
  for (int block = 1; block <= file.FindDimension("num_el_blk"); ++block)
  {
    const std::string connect = "connect" + std::to_string(block);
    const std::vector<int> nodes = file.ReadIntegers(connect);
    const int size = file.FindDimension("num_nod_per_el" + std::to_string(block));
    for (std::size_t first = 0; first < nodes.size(); first += size)
    {
      elements.emplace_back(file.FindType(connect),
        std::vector<int>(nodes.begin() + first, nodes.begin() + first + size));
    }
  }
  const std::vector<int> cells = file.ReadIntegers("elem_ss" + number);
  const std::vector<int> sides = file.ReadIntegers("side_ss" + number);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  double volume = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto& [type, nodes] = elements[cells[i] - 1];
    std::vector<Eigen::Vector3d> corners;
    for (const int corner : SidesOf.at(type)[sides[i] - 1])
    {
      const int node = nodes[corner - 1] - 1;
      corners.emplace_back(coordinates[0][node], coordinates[1][node], coordinates[2][node]);
    }
    for (std::size_t k = 2; k < corners.size(); ++k)
    {
      area += (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]) / 2.0;
      volume += corners[0].dot(corners[k - 1].cross(corners[k]));
    }
  }
  return { area, volume };
}

} // namespace

TEST(ExodusWriter, SideSetsEncloseEveryKindOfCell)
{
  FileContent file = Write(shapetest::OneOfEach(), (Eigen::VectorXi(4) << 0, 0, 2, 2).finished());
  const std::vector<std::string> names = file.ReadTexts("ss_names");
  EXPECT_EQ(file.ReadTexts("ns_names"), names);
  EXPECT_EQ(names.back(), "Interface0_2");
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  double volume = 0.0;
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
  {
    EXPECT_EQ(names[i], "Patch" + std::to_string(i));
    const auto [partArea, partVolume] = Measure(file, std::to_string(i + 1));
    area += partArea;
    volume += partVolume / 6.0;
  }
  EXPECT_LE(area.norm(), 1e-12);
  EXPECT_NEAR(volume, 1.0 + 1.0 / 3.0 + 1.0 / 2.0 + 1.0 / 6.0, 1e-12);
}

TEST(ExodusWriter, BlocksAreRegionsAndKinds)
{
  FileContent file = Write(shapetest::OneOfEach(), (Eigen::VectorXi(4) << 0, 0, 2, 2).finished());
  EXPECT_EQ(file.ReadTexts("eb_names"),
    (std::vector<std::string>{
      "Region0_hex8", "Region0_pyramid5", "Region2_tetra4", "Region2_wedge6" }));
  EXPECT_EQ(file.ReadIntegers("eb_prop1"), (std::vector<int>{ 1, 4, 3, 5 }));
  EXPECT_EQ(file.ReadIntegers("eb_status"), (std::vector<int>{ 1, 1, 1, 1 }));
  EXPECT_EQ(file.ReadIntegers("elem_num_map"), (std::vector<int>{ 1, 2, 4, 3 }));
  EXPECT_EQ(file.ReadIntegers("connect3"), (std::vector<int>{ 6, 7, 9, 12 }));
}

TEST(ExodusWriter, CoordinatesKeepTheirBits)
{
  shape::Cells cells = shapetest::Cubes({ 2, 2, 1 }, shapetest::Everywhere);
  cells.Points.array() = cells.Points.array() / 3.0 + 1e-17;
  FileContent file = Write(cells, (Eigen::VectorXi(4) << 0, 1, 0, 1).finished());
  for (int k = 0; k < 3; ++k)
  {
    const std::vector<double> read = file.ReadDoubles(std::string("coord") + "xyz"[k]);
    const Eigen::VectorXd column = cells.Points.col(k);
    EXPECT_EQ(read, std::vector<double>(column.begin(), column.end()));
  }
  // Between the regions: two faces of the cells of region 0, whose normals are +x.
  EXPECT_EQ(file.ReadTexts("ss_names").back(), "Interface0_1");
  const Eigen::Vector3d area = Measure(file, "7").first;
  EXPECT_LE((area - Eigen::Vector3d(2.0 / 9.0, 0.0, 0.0)).norm(), 1e-12);
}

TEST(ExodusWriter, SurfacesLinesAndVerticesHaveBlocksAndNoSets)
{
  shapetest::CellList list;
  list.Add(Triangle, { 0, 1, 2 });
  list.Add(Quadrilateral, { 0, 1, 2, 3 });
  list.Add(Line, { 0, 1 });
  list.Add(Vertex, { 3 });
  FileContent file =
    Write(list.Over(shapetest::OneOfEach().Points), Eigen::VectorXi::LinSpaced(4, 0, 3));
  const std::array<const char*, 4> types{ "TRI3", "SHELL4", "BAR2", "SPHERE" };
  for (int block = 1; block <= 4; ++block)
  {
    EXPECT_EQ(file.FindType("connect" + std::to_string(block)), types[block - 1]);
  }
  EXPECT_EQ(file.FindDimension("num_side_sets"), -1);
}
