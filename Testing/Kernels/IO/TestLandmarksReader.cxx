#include "IO/LandmarksReader.h"

#include "Base/Errors.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

namespace
{

using SystemType = shape::LandmarksReaderOptions::CoordinateSystemType;

std::string LandmarksRefusal(const std::string& content)
{
  try
  {
    shape::ReadLandmarks(content);
  }
  catch (const shape::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

const char* const SlicerTable = "# Markups fiducial file version = 4.11\n"
                                "# CoordinateSystem = LPS\n"
                                "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc\n"
                                "1,1.5,-2,3e1,0,0,0,1,1,1,0,\"nasion, left\",,\n"
                                "2,4,5,6,0,0,0,1,1,1,0,,,\n";

const char* const SlicerMarkups = R"({"markups": [{"type": "Fiducial", "coordinateSystem": "RAS",
  "controlPoints": [{"label": "F-1", "position": [1.5, -2.0, 30]},
                    {"label": "F-2", "position": [0, 0, 0], "positionStatus": "undefined"},
                    {"label": "F-3", "position": [4, 5, 6], "positionStatus": "defined"}]}]})";

const char* const MeshLabPoints = R"(<!DOCTYPE PickedPoints>
<PickedPoints>
 <DocumentData><User name="me"/></DocumentData>
 <point x="1.5" y="-2" z="30" active="1" name="nose"/>
 <point x="7" y="8" z="9" active="0" name="off"/>
 <point x="4" y="5" z="6" active="1" name=""/>
</PickedPoints>)";

Eigen::MatrixXd Expected()
{
  Eigen::MatrixXd points(2, 3);
  points << 1.5, -2.0, 30.0, 4.0, 5.0, 6.0;
  return points;
}

} // namespace

TEST(LandmarksReader, ReadsPairs)
{
  const shape::LandmarkFile file = shape::ReadLandmarks(
    "x,y,z,tx,ty,tz,name\n1.5,-2,30,7,8,9,\"a \"\"b\"\", c\"\n\n4,5,6,10,11,12,\r\n");
  EXPECT_EQ(file.Points, Expected());
  EXPECT_EQ(file.Targets.row(1), Eigen::RowVector3d(10.0, 11.0, 12.0));
  EXPECT_EQ(file.Names, (std::vector<std::string>{ "a \"b\", c", "2" }));
  EXPECT_EQ(file.CoordinateSystem, "");
}

TEST(LandmarksReader, ReadsTheFilesOfSlicer)
{
  const shape::LandmarkFile table = shape::ReadLandmarks(SlicerTable);
  EXPECT_EQ(table.Points, Expected());
  EXPECT_EQ(table.Targets.rows(), 0);
  EXPECT_EQ(table.Names, (std::vector<std::string>{ "nasion, left", "2" }));
  EXPECT_EQ(table.CoordinateSystem, "LPS");
  const shape::LandmarkFile markups = shape::ReadLandmarks(SlicerMarkups);
  EXPECT_EQ(markups.Points, Expected());
  EXPECT_EQ(markups.Names, (std::vector<std::string>{ "F-1", "F-3" }));
  EXPECT_EQ(markups.CoordinateSystem, "RAS");
}

TEST(LandmarksReader, ReadsTheFilesOfMeshLab)
{
  const shape::LandmarkFile file = shape::ReadLandmarks(MeshLabPoints);
  EXPECT_EQ(file.Points, Expected());
  EXPECT_EQ(file.Names, (std::vector<std::string>{ "nose", "2" }));
}

TEST(LandmarksReader, ConvertsBetweenLPSAndRAS)
{
  shape::LandmarksReaderOptions options;
  options.CoordinateSystem = SystemType::RAS;
  const shape::LandmarkFile table = shape::ReadLandmarks(SlicerTable, options);
  EXPECT_EQ(table.Points.row(0), Eigen::RowVector3d(-1.5, 2.0, 30.0));
  EXPECT_EQ(table.CoordinateSystem, "RAS");
  EXPECT_EQ(shape::ReadLandmarks(SlicerMarkups, options).Points, Expected());
  // Nothing is known of other files, so they stay as they are.
  EXPECT_EQ(shape::ReadLandmarks(MeshLabPoints, options).Points, Expected());
}

TEST(LandmarksReader, NamesTheLineOfAnError)
{
  EXPECT_EQ(
    LandmarksRefusal("x,y,z\n1,2,3\n1,two,3\n"), "line 3, column y: `two` is no finite number");
  EXPECT_EQ(LandmarksRefusal("x,y,z\n1,2\n"), "line 2, column z: `` is no finite number");
  EXPECT_EQ(LandmarksRefusal("x,y,z\n1,2,nan\n"), "line 2, column z: `nan` is no finite number");
  EXPECT_EQ(LandmarksRefusal("1,2,3\n"),
    "line 1: there is no column x; name the columns x,y,z,name or x,y,z,tx,ty,tz,name");
  EXPECT_EQ(LandmarksRefusal("x,y,z,tx\n"),
    "line 1: there is no column ty; name the columns x,y,z,name or x,y,z,tx,ty,tz,name");
  EXPECT_EQ(LandmarksRefusal("# CoordinateSystem = IJK\n"),
    "line 1: the coordinate system is `IJK`; save as LPS or RAS");
  EXPECT_EQ(LandmarksRefusal("{\n\"markups\": [\n").substr(0, 5), "line ");
  EXPECT_EQ(LandmarksRefusal("<PickedPoints>\n<point x=1/>").substr(0, 5), "line ");
  EXPECT_EQ(LandmarksRefusal("<PickedPoints><point x='1' y='2'/></PickedPoints>"),
    "point 1, attribute z: `` is no finite number");
  EXPECT_EQ(LandmarksRefusal(R"({"markups": [{"controlPoints": [{"position": [1, 2]}]}]})"),
    "control point 1: `position` has 2 numbers instead of 3");
  EXPECT_EQ(LandmarksRefusal(""),
    "there are no landmarks; expected .csv, .fcsv, .mrk.json, .pp, .pts or .tps");
}

TEST(LandmarksReader, ReadsLandmarkEditor)
{
  const shape::LandmarkFile file = shape::ReadLandmarks(
    "Version 1.0\r\n3\r\nnose 1.5 -2 30\r\nlost 9999 9999 9999\r\nchin 4 5 6\r\n");
  EXPECT_EQ(file.Points, Expected());
  EXPECT_EQ(file.Names, (std::vector<std::string>{ "nose", "chin" }));
  const shape::LandmarkFile flat =
    shape::ReadLandmarks("version: 1\nn_points:  2\n{\n1.5 -2\n4 5\n}\n");
  EXPECT_EQ(flat.Points.leftCols(2), Expected().leftCols(2));
  EXPECT_EQ(flat.Points.col(2), Eigen::Vector2d::Zero());
}

TEST(LandmarksReader, ReadsSpecimensOfTPS)
{
  const std::string content = "LM3=3\n0.75 -1 15\nNA NA NA\n2 2.5 3\nCURVES=1\nPOINTS=2\n1 1 1\n"
                              "2 2 2\nIMAGE=a = b.jpg\nID=first\nSCALE=2\n\n"
                              "lm3=3\n7 8 9\n1 1 1\n10 11 12\nID=second\n"
                              "LM=1\n1 2\n";
  shape::LandmarksReaderOptions options;
  const shape::LandmarkFile pairs = shape::ReadLandmarks(content);
  EXPECT_EQ(pairs.Points, Expected());
  EXPECT_EQ(pairs.Targets.row(0), Eigen::RowVector3d(7.0, 8.0, 9.0));
  EXPECT_EQ(pairs.Targets.row(1), Eigen::RowVector3d(10.0, 11.0, 12.0));
  EXPECT_EQ(pairs.Names, (std::vector<std::string>{ "1", "3" }));
  options.TargetSpecimen = 0;
  EXPECT_EQ(shape::ReadLandmarks(content, options).Targets.rows(), 0);
  options.Specimen = 2;
  EXPECT_EQ(shape::ReadLandmarks(content, options).Points.rows(), 3);
  options.Specimen = 3;
  EXPECT_EQ(
    shape::ReadLandmarks(content, options).Points.row(0), Eigen::RowVector3d(1.0, 2.0, 0.0));
  options.Specimen = 4;
  EXPECT_REFUSED(shape::ReadLandmarks(content, options), "Specimen is 4", "has 3");
  options.Specimen = 1;
  options.TargetSpecimen = 3;
  EXPECT_REFUSED(shape::ReadLandmarks(content, options), "specimen 3 has 1 landmarks",
    "specimen 1 has 3", "TargetSpecimen");
}

TEST(LandmarksReader, RefusesWrongMorphometrics)
{
  const auto read = [](const char* content) { shape::ReadLandmarks(content); };
  EXPECT_REFUSED(read("Version 1.0\n2\na 1 2 3\n"), "line 4", "ends before the last landmark");
  EXPECT_REFUSED(read("Version 1.0\n1\na 1 2 3\nb 1 2 3\n"), "line 4", "more landmarks");
  EXPECT_REFUSED(read("Version 1.0\n1.5\na 1 2 3\n"), "line 2", "`1.5` is no number of points");
  EXPECT_REFUSED(read("Version 1.0\n1\na 1 x 3\n"), "line 3", "`x` is no finite number");
  EXPECT_REFUSED(read("version: 1\nn_points: 1\n1 2\n"), "line 3", "`{` should follow");
  EXPECT_REFUSED(read("version: 1\nn_points: 1\n{\n1 2\n3 4\n}\n"), "line 5", "more points");
  EXPECT_REFUSED(read("LM=2\n1 2\n1 2 3\n"), "line 3", "3 coordinates instead of 2");
  EXPECT_REFUSED(read("LM=1\n1 2\n3 4\n"), "line 3", "belongs to no entry");
  EXPECT_REFUSED(read("LM=1\n1 2\nSCALE=big\n"), "line 3", "`big` is no finite number");
  EXPECT_REFUSED(read("LM=1\nNA NA\n"), "there are no landmarks");
}

TEST(LandmarksReader, CoordinateSystemsAreThoseOfSlicer)
{
  // A table without a system is RAS, and markups without one are LPS.
  EXPECT_EQ(
    shape::ReadLandmarks("# columns = id,x,y,z,label\n1,1,2,3,a\n").CoordinateSystem, "RAS");
  EXPECT_EQ(shape::ReadLandmarks(R"({"markups": [{"controlPoints": [{"position": [1, 2, 3]}]}]})")
              .CoordinateSystem,
    "LPS");
  for (const auto& [word, system] :
    { std::pair("0", "RAS"), { "1", "LPS" }, { "RAS", "RAS" }, { "LPS", "LPS" } })
  {
    const std::string content =
      std::string("# CoordinateSystem = ") + word + "\n# columns = id,x,y,z,label\n1,1,2,3,a\n";
    EXPECT_EQ(shape::ReadLandmarks(content).CoordinateSystem, system);
    shape::LandmarksReaderOptions options;
    options.CoordinateSystem = SystemType::LPS;
    const double sign = std::string(system) == "LPS" ? 1.0 : -1.0;
    EXPECT_EQ(shape::ReadLandmarks(content, options).Points.row(0),
      Eigen::RowVector3d(sign, 2.0 * sign, 3.0));
  }
}
