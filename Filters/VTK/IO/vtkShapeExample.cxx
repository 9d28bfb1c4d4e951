#include "vtkShapeExample.h"

#include "vtkShapeArchive.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFileContent.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLGenericDataObjectReader.h"

#include "Base/Errors.h"
#include "IO/OFFReader.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>

vtkStandardNewMacro(vtkShapeExample);

namespace
{

struct ExampleShape
{
  const char* Name;
  const char* File; ///< .off: in the archive; others: beside the library
  const char* TryNext;
};

constexpr ExampleShape ExampleShapes[] = {
  // generated
  { "Figure", "FigureASmall.vtp",
    "Shape Correspondence with Bent Figure as Surface B, then Shape Morph. Or Shape Hex Remesh." },
  { "Bent Figure", "FigureBSmall.vtp",
    "Shape Correspondence with Figure as the other surface, then Shape Map Quality." },
  { "Dented Sphere", "DentedSphere600.vtp",
    "Shape Parameterize: its output Image is a sphere. Then Shape Map Quality. It is quick." },
  { "Two-Holed Torus", "TwoTorusSmall.vtp",
    "Shape Hex Remesh, and Shape Laplace Spectrum. Its genus is 2, so it has no map to a sphere." },
  { "Bent Bar", "BentBarSmall.vtp",
    "Shape Polycube or Shape Hex Remesh, then Save Data as .inp. Its creases bound patches." },
  { "Twisted Bar", "TwistedBarSmall.vtp",
    "Shape Correspondence with Bent Bar, or Shape Hex Remesh: the creases are kept." },
  { "Head", "PhantomHeadSmall.vtp",
    "Add the shapes Skull and Brain. Then Shape Hex Remesh of Head, with both as Inner Surfaces." },
  { "Skull", "PhantomSkullSmall.vtp",
    "An inner surface of Head in Shape Hex Remesh. Its genus is 2." },
  { "Brain", "PhantomBrainSmall.vtp",
    "An inner surface of Head in Shape Hex Remesh. Or Shape Parameterize." },
  { "Ball of Hexahedra", "BallSmall.vtu",
    "Shape Harmonic Volume Map with this ball as Domain, and a map of its boundary." },
  { "Bar of Hexahedra", "BentBarSmall.vtu",
    "Colour by ScaledJacobian of Mesh Quality. Save Data as .inp, .mesh or .html." },
  // of libcgal-demo
  { "Bunny", "bunny00.off",
    "Shape Hex Remesh: 21,186 hexahedra after a minute. Then Clip, with Crinkle Clip, to look "
    "inside." },
  { "Bear", "bear.off",
    "Shape Correspondence with Walking Bear as Surface B, then Shape Morph and Play." },
  { "Walking Bear", "bear_bis.off",
    "Shape Correspondence with Bear as Surface A. Both have the same triangles." },
  { "Cow", "cow.off",
    "Shape Parameterize with Area Weight 3. Then Shape Harmonic Volume Map of a ball into the "
    "cow." },
  { "Armadillo", "armadillo.off",
    "Shape Geodesic Distance, or Shape Laplace Spectrum, coloured by an eigenfunction." },
  { "Elephant", "elephant.off",
    "Shape Cut Feature: press Draw Loop and click around its trunk. Then Shape Paste Feature." },
  { "Elephant with Holes", "elephant-with-holes.off",
    "Shape Fill Holes. Then Shape Hex Remesh, which needs a closed surface." },
  { "Mannequin", "mannequin-devil.off",
    "Shape Cut Feature: cut off a horn, and paste it to another shape." },
  { "Femur", "femur.off", "Shape Hex Remesh, then Save Data as .inp for CalculiX." },
  { "Fandisk", "fandisk.off", "Shape Hex Remesh: its creases and corners are kept." },
  { "Hand", "hand.off",
    "Shape Tetrahedralize, or Shape Deform. Fill its hole first with Shape Fill Holes." },
};

bool IsModel(const ExampleShape& shape)
{
  return std::filesystem::path(shape.File).extension() == ".off";
}

const ExampleShape* FindExample(const std::string& name)
{
  const auto* found = std::find_if(std::begin(ExampleShapes), std::end(ExampleShapes),
    [&](const ExampleShape& shape) { return name == shape.Name; });
  return found == std::end(ExampleShapes) ? nullptr : found;
}

/// Returns share/ShapeMap/examples beside the folder of this library, in a build and in an
/// installation.
std::filesystem::path FindExampleFolder()
{
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&FindExampleFolder), &library) == 0)
  {
    return {};
  }
  // In Debian's layout the library is one folder deeper: lib/x86_64-linux-gnu.
  std::error_code ignored;
  for (auto folder = std::filesystem::weakly_canonical(library.dli_fname, ignored).parent_path();
       folder.has_relative_path(); folder = folder.parent_path())
  {
    const auto examples = folder / "share" / "ShapeMap" / "examples";
    if (std::filesystem::is_directory(examples, ignored))
    {
      return examples;
    }
  }
  return {};
}

} // namespace

vtkShapeExample::vtkShapeExample() = default;
vtkShapeExample::~vtkShapeExample() = default;

vtkStringArray* vtkShapeExample::GetShapes()
{
  const std::filesystem::path folder = FindExampleFolder();
  std::error_code ignored;
  const bool hasModels = std::filesystem::exists(this->ModelArchive, ignored);
  this->Shapes->Initialize();
  for (const ExampleShape& shape : ExampleShapes)
  {
    if (IsModel(shape) ? hasModels : std::filesystem::exists(folder / shape.File, ignored))
    {
      this->Shapes->InsertNextValue(shape.Name);
    }
  }
  return this->Shapes;
}

const char* vtkShapeExample::GetTryNext()
{
  const ExampleShape* shape = FindExample(this->Shape);
  return shape ? shape->TryNext : "";
}

std::string vtkShapeExample::GetOutputType()
{
  const ExampleShape* shape = FindExample(this->Shape);
  const bool isSolid = shape && std::filesystem::path(shape->File).extension() == ".vtu";
  return isSolid ? "vtkUnstructuredGrid" : "vtkPolyData";
}

void vtkShapeExample::Make(vtkDataObject* output, const shape::Progress& progress)
{
  const ExampleShape* shape = FindExample(this->Shape);
  if (!shape)
  {
    throw shape::InvalidInput("there is no shape '" + this->Shape + "'; choose one of the list");
  }
  std::error_code ignored;
  if (IsModel(*shape))
  {
    if (!std::filesystem::exists(this->ModelArchive, ignored))
    {
      throw shape::InvalidInput(
        "install libcgal-demo, the Debian package that has '" + this->Shape + "'");
    }
    const std::string content =
      vtkShapeArchive::Read(this->ModelArchive, std::string("data/meshes/") + shape->File);
    vtkShapeFileContent::ToPolyData(
      shape::ReadOFF(content, progress), vtkPolyData::SafeDownCast(output));
  }
  else
  {
    const std::filesystem::path path = FindExampleFolder() / shape->File;
    if (!std::filesystem::exists(path, ignored))
    {
      throw shape::InvalidInput(
        "install ShapeMap again; the file of '" + this->Shape + "' is missing");
    }
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    output->ShallowCopy(reader->GetOutput());
  }
  vtkShapeConvert::AddFact(output, "Example.Shape", std::string(shape->Name));
  vtkShapeConvert::AddFact(output, "Example.TryNext", std::string(shape->TryNext));
}

void vtkShapeExample::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "ModelArchive: " << this->ModelArchive << "\n";
}
