#include "IO/CADReader.h"
#include "Mesh/Topology.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>

namespace
{

constexpr double radius = 0.75;

/// A box of 4 x 3 x 2 with a hole along z.
TopoDS_Shape Plate()
{
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4.0, 3.0, 2.0).Shape(),
    BRepPrimAPI_MakeCylinder(gp_Ax2({ 2.0, 1.5, -1.0 }, { 0.0, 0.0, 1.0 }), radius, 4.0).Shape());
}

TopoDS_Shape Moved(const TopoDS_Shape& shape, double x)
{
  gp_Trsf shift;
  shift.SetTranslation({ x, 0.0, 0.0 });
  return BRepBuilderAPI_Transform(shape, shift).Shape();
}

TopoDS_Shape Together(const std::vector<TopoDS_Shape>& shapes)
{
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes)
  {
    BRep_Builder().Add(all, shape);
  }
  return all;
}

std::string ToBREP(const TopoDS_Shape& shape)
{
  std::ostringstream stream;
  BRepTools::Write(shape, stream);
  return stream.str();
}

/// Millimetres, written in the given unit.
std::string ToSTEP(const TopoDS_Shape& shape, const char* unit)
{
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const std::string path = testing::TempDir() + "TestCADReader" + std::to_string(getpid());
  EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  std::ifstream file(path);
  std::string content{ std::istreambuf_iterator<char>(file), {} };
  std::filesystem::remove(path);
  return content;
}

/// Trimmed surfaces alone, which know nothing of their neighbours.
std::string ToIGES(const TopoDS_Shape& shape, const char* unit)
{
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit, 0);
  writer.AddShape(shape);
  writer.ComputeModel();
  std::ostringstream stream;
  EXPECT_TRUE(writer.Write(stream));
  return stream.str();
}

double LargestDistanceFromCircle(const shape::CADModel& model)
{
  double largest = 0.0;
  int circles = 0;
  for (const shape::CADEdge& edge : model.Edges)
  {
    if (edge.Points.front() != edge.Points.back())
    {
      continue;
    }
    ++circles;
    EXPECT_GE(edge.Points.size(), 19U); // 20 degrees at most
    for (const int point : edge.Points)
    {
      const Eigen::RowVector3d position = model.Surface.Points.row(point);
      largest =
        std::max({ largest, std::abs(std::hypot(position(0) - 2.0, position(1) - 1.5) - radius),
          std::abs(std::abs(position(2) - 1.0) - 1.0) });
    }
  }
  EXPECT_EQ(circles, 2);
  return largest;
}

/// A closed plate with seven faces, outwards, whose volume is within the bound of the deflection.
void ExpectPlate(const shape::CADModel& model, double scale)
{
  const shape::Topology topology = shape::ComputeTopology(model.Surface);
  EXPECT_EQ(topology.EulerNumber, 0);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(model.OpenEdges, 0);
  EXPECT_EQ(model.PatchNames.size(), 7U);
  EXPECT_EQ(std::set<int>(model.Patches.begin(), model.Patches.end()).size(), 7U);
  EXPECT_EQ(model.Regions.cwiseAbs().maxCoeff(), 0);
  // Only the hole is curved: 2 pi r h of it is moved by the deflection at most.
  const double exact = 24.0 - M_PI * radius * radius * 2.0;
  const double bound = 2.0 * M_PI * radius * 2.0 * model.Deflection / scale;
  EXPECT_NEAR(shape::ComputeEnclosedVolume(model.Surface) / std::pow(scale, 3), exact, bound);
  EXPECT_LE(model.Distance, model.Deflection);
  EXPECT_GT(model.Distance, 0.0);
}

} // namespace

TEST(CADReader, ASolidIsClosedAndItsEdgesAreExact)
{
  for (const std::string& content : { ToBREP(Plate()), ToSTEP(Plate(), "MM") })
  {
    for (const double deflection : { 0.0, 0.1, 0.001 })
    {
      shape::CADReaderOptions options;
      options.Deflection = deflection;
      const shape::CADModel model = shape::ReadCAD(content, options);
      ExpectPlate(model, 1.0);
      EXPECT_LE(LargestDistanceFromCircle(model), 1e-9);
      EXPECT_EQ(model.Edges.size(), 14U); // twelve of the box and two circles
      EXPECT_EQ(model.Unit, content[0] == 'I' ? "mm" : "");
    }
  }
}

TEST(CADReader, DeflectionBoundsTheDistanceFromASphere)
{
  const std::string content = ToBREP(BRepPrimAPI_MakeSphere(2.0).Shape());
  shape::CADReaderOptions options;
  options.Angle = 90.0;
  Eigen::Index coarse = 0;
  for (const double deflection : { 0.1, 0.01, 0.001 })
  {
    options.Deflection = deflection;
    const shape::CADModel model = shape::ReadCAD(content, options);
    EXPECT_EQ(shape::ComputeTopology(model.Surface).EulerNumber, 2);
    EXPECT_NEAR((model.Surface.Points.rowwise().norm().array() - 2.0).abs().maxCoeff(), 0.0, 1e-12);
    EXPECT_LE(model.Distance, deflection);
    EXPECT_GT(model.Surface.Triangles.rows(), 2 * coarse);
    coarse = model.Surface.Triangles.rows();
  }
}

TEST(CADReader, TheApexOfAConeIsOnePoint)
{
  const shape::CADModel model = shape::ReadCAD(ToBREP(BRepPrimAPI_MakeCone(1.0, 0.0, 2.0).Shape()));
  EXPECT_EQ(shape::ComputeTopology(model.Surface).EulerNumber, 2);
  EXPECT_EQ(model.OpenEdges, 0);
  EXPECT_EQ((model.Surface.Points.col(2).array() > 2.0 - 1e-9).count(), 1);
}

TEST(CADReader, CoordinatesKeepTheUnitOfTheFile)
{
  const std::map<std::string, std::pair<const char*, double>> units{ { "in", { "INCH", 25.4 } },
    { "m", { "M", 1000.0 } }, { "mm", { "MM", 1.0 } } };
  for (const auto& [unit, written] : units)
  {
    const auto& [name, millimetres] = written;
    const shape::CADModel step = shape::ReadCAD(ToSTEP(Plate(), name));
    EXPECT_EQ(step.Unit, unit);
    ExpectPlate(step, 1.0 / millimetres);
    const shape::CADModel iges = shape::ReadCAD(ToIGES(Plate(), name));
    EXPECT_EQ(iges.Unit, unit);
    ExpectPlate(iges, 1.0 / millimetres);
    for (const shape::CADModel* model : { &step, &iges })
    {
      // OpenCASCADE writes IGES with nine digits.
      EXPECT_NEAR(
        model->Surface.Points.col(0).maxCoeff() * millimetres, 4.0, model == &step ? 1e-9 : 4e-9);
    }
  }
}

TEST(CADReader, FacesThatAreNotSewnAreJoined)
{
  const std::string content = ToIGES(Plate(), "MM");
  ExpectPlate(shape::ReadCAD(content), 1.0);
  // With no tolerance to speak of, the circles stay apart or not: nothing else is joined wrongly.
  shape::CADReaderOptions options;
  options.SewingTolerance = 1e-12;
  EXPECT_EQ(shape::ReadCAD(content, options).PatchNames.size(), 7U);
}

TEST(CADReader, SolidsAreRegionsWithoutCommonPoints)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
  // The second touches the first. The third is the first one again, which is read once.
  const shape::CADModel model =
    shape::ReadCAD(ToBREP(Together({ box, Moved(box, 1.0), box, Moved(Plate(), 9.0) })));
  EXPECT_EQ(shape::ComputeTopology(model.Surface).Components, model.Regions.maxCoeff() + 1);
  EXPECT_EQ(model.OpenEdges, 0);
  std::map<int, std::set<int>> patches;
  for (Eigen::Index i = 0; i < model.Patches.size(); ++i)
  {
    patches[model.Regions(i)].insert(model.Patches(i));
  }
  std::multiset<std::size_t> counts;
  for (const auto& [region, faces] : patches)
  {
    counts.insert(faces.size());
  }
  EXPECT_EQ(counts, (std::multiset<std::size_t>{ 6, 6, 7 }));
}

TEST(CADReader, NamesAreThoseOfTheFile)
{
  std::string content = ToSTEP(Plate(), "MM");
  const auto replace = [&](const std::string& from, const std::string& to)
  {
    const std::size_t at = content.find(from);
    ASSERT_NE(at, std::string::npos);
    content.replace(at, from.size(), to);
  };
  replace("ADVANCED_FACE(''", "ADVANCED_FACE('inlet'");
  replace("MANIFOLD_SOLID_BREP(''", "MANIFOLD_SOLID_BREP('plate'");
  const shape::CADModel model = shape::ReadCAD(content);
  EXPECT_EQ(model.RegionNames, std::vector<std::string>{ "plate" });
  EXPECT_EQ(std::count(model.PatchNames.begin(), model.PatchNames.end(), "inlet"), 1);
  EXPECT_EQ(std::count(model.PatchNames.begin(), model.PatchNames.end(), ""), 6);
}

TEST(CADReader, TheSameFileGivesTheSameBits)
{
  const std::string content = ToIGES(Together({ Plate(), Moved(Plate(), 5.0) }), "MM");
  const shape::CADModel first = shape::ReadCAD(content), second = shape::ReadCAD(content);
  EXPECT_EQ(first.Surface.Points, second.Surface.Points);
  EXPECT_EQ(first.Surface.Triangles, second.Surface.Triangles);
}

TEST(CADReader, ReportsProgressAndStops)
{
  const std::string content = ToBREP(Plate());
  shapetest::ExpectProgressRises(
    [&](const shape::Progress& progress) { shape::ReadCAD(content, {}, progress); });
  shapetest::ExpectStopsAt(
    1, [&](const shape::Progress& progress) { shape::ReadCAD(content, {}, progress); });
}

TEST(CADReader, RefusesWhatItCannotRead)
{
  EXPECT_REFUSED(shape::ReadCAD(""), "the file is empty");
  EXPECT_REFUSED(shape::ReadCAD("solid ascii"), "does not begin as a STEP, IGES or BREP file");
  const std::string step = ToSTEP(Plate(), "MM"), brep = ToBREP(Plate());
  EXPECT_REFUSED(shape::ReadCAD(step.substr(0, 1500)), "as STEP", "export the file again");
  EXPECT_REFUSED(
    shape::ReadCAD("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"),
    "as STEP", "export the file again");
  EXPECT_REFUSED(shape::ReadCAD(brep.substr(0, 200)), "as BREP");
  EXPECT_REFUSED(shape::ReadCAD(ToBREP(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)))),
    "no faces", "not only curves");
  shapetest::ExpectRefused<shape::CADReaderOptions>(
    [&](const shape::CADReaderOptions& options) { shape::ReadCAD(brep, options); }, {},
    { { &shape::CADReaderOptions::Deflection, -1.0, { "Deflection", "0 or more" } },
      { &shape::CADReaderOptions::Angle, 0.0, { "Angle", "from 1 to 90" } },
      { &shape::CADReaderOptions::Angle, 91.0, { "Angle", "from 1 to 90" } },
      { &shape::CADReaderOptions::SewingTolerance, -1.0, { "SewingTolerance", "0 or more" } } });
}
