#include "Base/Errors.h"
#include "IO/Private/CascadeFile.h"
#include "IO/Private/OpenCascade.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <Eigen/Geometry>

#include <algorithm>
#include <clocale>
#include <cmath>

namespace shape
{
namespace
{

TopoDS_Shape WithoutLocation(const TopoDS_Shape& shape)
{
  return shape.Located(TopLoc_Location());
}

/// Returns the solids, and then the connected sheets of the faces that belong to no solid.
std::vector<TopoDS_Shape> FindRegions(CascadeFile& file, double sewingTolerance)
{
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(file.Shape, TopAbs_SOLID, solids);
  std::vector<TopoDS_Shape> regions;
  for (TopExp_Explorer solid(file.Shape, TopAbs_SOLID); solid.More(); solid.Next())
  {
    if (solids.RemoveKey(solid.Current()))
    {
      regions.push_back(solid.Current());
    }
  }
  BRepBuilderAPI_Sewing sewing(sewingTolerance);
  TopTools_IndexedMapOfShape loose;
  for (TopExp_Explorer face(file.Shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next())
  {
    if (loose.Add(face.Current()) == loose.Extent())
    {
      sewing.Add(face.Current());
    }
  }
  if (loose.IsEmpty())
  {
    return regions;
  }
  sewing.Perform();
  for (int i = 1; i <= loose.Extent(); ++i)
  {
    const TopoDS_Shape key = WithoutLocation(loose(i));
    const TopoDS_Shape sewn = WithoutLocation(sewing.Modified(loose(i)));
    if (file.Names.IsBound(key) && !file.Names.IsBound(sewn))
    {
      file.Names.Bind(sewn, std::string(file.Names(key)));
    }
  }
  for (TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL); shell.More(); shell.Next())
  {
    regions.push_back(shell.Current());
  }
  for (TopExp_Explorer face(sewing.SewedShape(), TopAbs_FACE, TopAbs_SHELL); face.More();
       face.Next())
  {
    regions.push_back(face.Current());
  }
  return regions;
}

/// Triangulates the edges and faces of all regions, by common points on common edges.
void Triangulate(const std::vector<TopoDS_Shape>& regions, double deflection, double degrees)
{
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& region : regions)
  {
    builder.Add(all, region);
  }
  BRepTools::Clean(all); // a file may bring triangles
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = degrees * M_PI / 180.0;
  BRepMesh_IncrementalMesh(all, parameters);
}

Eigen::Vector3d ToVector(const gp_XYZ& position)
{
  return { position.X(), position.Y(), position.Z() };
}

/// The largest distance of a face from the planes of its triangles, at their centres and those of
/// their edges.
double MeasureDistance(const TopoDS_Face& face, const Poly_Triangulation& triangulation,
  const std::vector<Eigen::Vector3d>& nodes)
{
  const BRepAdaptor_Surface surface(face);
  double largest = 0.0;
  for (int i = 1; i <= triangulation.NbTriangles(); ++i)
  {
    std::array<int, 3> corners{};
    triangulation.Triangle(i).Get(corners[0], corners[1], corners[2]);
    const Eigen::Vector3d first = nodes[corners[0] - 1];
    const Eigen::Vector3d normal =
      (nodes[corners[1] - 1] - first).cross(nodes[corners[2] - 1] - first).stableNormalized();
    std::array<gp_XY, 3> parameters;
    std::transform(corners.begin(), corners.end(), parameters.begin(),
      [&](int node) { return triangulation.UVNode(node).XY(); });
    const auto& [a, b, c] = parameters;
    for (const gp_XY& sample : { (a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0 })
    {
      const Eigen::Vector3d exact = ToVector(surface.Value(sample.X(), sample.Y()).XYZ());
      largest = std::max(largest, std::abs((exact - first).dot(normal)));
    }
  }
  return largest;
}

/// Numbers and collects the faces of regions.
class FaceCollector
{
public:
  explicit FaceCollector(CascadeFile& file)
    : Names(file.Names)
  {
    this->Model.Unit = file.Unit;
  }

  void Add(const TopoDS_Shape& region)
  {
    const int number = static_cast<int>(this->Model.RegionNames.size());
    this->Model.RegionNames.push_back(this->FindName(region));
    for (TopExp_Explorer face(region, TopAbs_FACE); face.More(); face.Next())
    {
      this->AddFace(TopoDS::Face(face.Current()), number);
    }
  }

  CascadeModel Model;

private:
  std::string FindName(const TopoDS_Shape& shape) const
  {
    const std::string* name = this->Names.Seek(WithoutLocation(shape));
    return name ? *name : std::string();
  }

  void AddFace(const TopoDS_Face& face, int region);
  CascadeEdge ReadEdge(const TopoDS_Edge& edge, const TopoDS_Face& face,
    const Poly_PolygonOnTriangulation& polygon, const std::vector<Eigen::Vector3d>& nodes);

  const ShapeNames& Names;
  TopTools_IndexedMapOfShape Faces, Edges, Vertices;
};

CascadeEdge FaceCollector::ReadEdge(const TopoDS_Edge& edge, const TopoDS_Face& face,
  const Poly_PolygonOnTriangulation& polygon, const std::vector<Eigen::Vector3d>& nodes)
{
  const auto forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
  CascadeEdge result{ this->Edges.Add(edge), this->Vertices.Add(first), this->Vertices.Add(last),
    static_cast<bool>(BRep_Tool::Degenerated(edge)),
    static_cast<bool>(BRep_Tool::IsClosed(edge, face)), {}, {} };
  double low = 0.0, high = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, low, high);
  const bool isExact = !curve.IsNull() && polygon.HasParameters() && BRep_Tool::SameParameter(edge);
  for (int i = 1; i <= polygon.NbNodes(); ++i)
  {
    result.Nodes.push_back(polygon.Node(i) - 1);
    result.Positions.push_back(
      isExact ? ToVector(curve->Value(polygon.Parameter(i)).XYZ()) : nodes[polygon.Node(i) - 1]);
  }
  result.Positions.front() = ToVector(BRep_Tool::Pnt(first).XYZ());
  result.Positions.back() = ToVector(BRep_Tool::Pnt(last).XYZ());
  return result;
}

void FaceCollector::AddFace(const TopoDS_Face& face, int region)
{
  CascadeFace result;
  result.Region = region;
  result.Patch = this->Faces.Add(face);
  if (result.Patch > static_cast<int>(this->Model.PatchNames.size()))
  {
    this->Model.PatchNames.push_back(this->FindName(face));
  }
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
  if (!triangulation.IsNull())
  {
    for (int node = 1; node <= triangulation->NbNodes(); ++node)
    {
      result.Nodes.push_back(ToVector(triangulation->Node(node).Transformed(location).XYZ()));
    }
    const bool isMirrored = location.Transformation().IsNegative();
    const bool isReversed = (face.Orientation() == TopAbs_REVERSED) != isMirrored;
    for (int i = 1; i <= triangulation->NbTriangles(); ++i)
    {
      std::array<int, 3> corners{};
      triangulation->Triangle(i).Get(
        corners[0], corners[isReversed ? 2 : 1], corners[isReversed ? 1 : 2]);
      result.Triangles.push_back({ corners[0] - 1, corners[1] - 1, corners[2] - 1 });
    }
    for (TopExp_Explorer edge(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); edge.More(); edge.Next())
    {
      const auto current = TopoDS::Edge(edge.Current());
      const auto polygon = BRep_Tool::PolygonOnTriangulation(current, triangulation, location);
      if (!polygon.IsNull())
      {
        result.Edges.push_back(this->ReadEdge(current, face, *polygon, result.Nodes));
      }
    }
    if (triangulation->HasUVNodes())
    {
      this->Model.Distance =
        std::max(this->Model.Distance, MeasureDistance(face, *triangulation, result.Nodes));
    }
  }
  this->Model.Faces.push_back(std::move(result));
}

CascadeModel ReadModel(std::string_view content, CADFormat format, const CADReaderOptions& options)
{
  CascadeFile file = ReadCascadeFile(content, format);
  Bnd_Box box;
  if (!file.Shape.IsNull())
  {
    BRepBndLib::Add(file.Shape, box, Standard_False);
  }
  if (box.IsVoid())
  {
    throw InvalidInput("there are no shapes in it; choose another file");
  }
  const double diagonal = std::sqrt(box.SquareExtent());
  const double tolerance = ShapeAnalysis_ShapeTolerance().Tolerance(file.Shape, 1, TopAbs_EDGE);
  const std::vector<TopoDS_Shape> regions = FindRegions(file,
    options.SewingTolerance > 0.0 ? options.SewingTolerance : std::max(1e-5 * diagonal, tolerance));
  if (regions.empty())
  {
    throw InvalidInput("there are no faces in it; export the faces or solids, not only curves");
  }
  const double deflection = options.Deflection > 0.0 ? options.Deflection : 0.001 * diagonal;
  Triangulate(regions, deflection, options.Angle);
  FaceCollector collector(file);
  for (const TopoDS_Shape& region : regions)
  {
    collector.Add(region);
  }
  collector.Model.Deflection = deflection;
  return std::move(collector.Model);
}

} // namespace
} // namespace shape

shape::CascadeModel ShapeMapReadCascade(
  std::string_view content, shape::CADFormat format, const shape::CADReaderOptions& options)
{
  using namespace shape;
  setlocale(LC_NUMERIC, "C"); // files are text
  try
  {
    return ReadModel(content, format, options);
  }
  catch (const Standard_Failure& failure)
  {
    throw SolveFailure(std::string("OpenCASCADE failed (") + failure.DynamicType()->Name() + ": " +
      failure.GetMessageString() + "); export the file again");
  }
}
