#include "vtkShapeWriter.h"

#include "vtkShapeConvert.h"
#include "vtkShapeProgress.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "IO/MeshSets.h"
#include "Mesh/CellFaces.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <new>
#include <stdexcept>
#include <system_error>

namespace
{

/// The file cannot be written.
class FileError : public std::runtime_error
{
public:
  FileError(const std::string& what, unsigned long code)
    : std::runtime_error(what)
    , Code(code)
  {
  }
  unsigned long Code; ///< of vtkErrorCode
};

void RequireKnownCells(const shape::Cells& cells)
{
  const auto unknown = [](int kind) { return shape::GetCornerCount(kind) == 0; };
  const auto first = std::find_if(cells.Kinds.begin(), cells.Kinds.end(), unknown);
  if (first != cells.Kinds.end())
  {
    const auto count = std::count(cells.Kinds.begin(), cells.Kinds.end(), *first);
    throw shape::InvalidInput("the Input has " + std::to_string(count) +
      (count == 1 ? " cell" : " cells") + " of the type " +
      vtkCellTypes::GetClassNameFromTypeId(*first) + " (first cell " +
      std::to_string(first - cells.Kinds.begin()) +
      "), but only linear vertices, lines, triangles, quadrilaterals, tetrahedra, pyramids, wedges "
      "and hexahedra can be written; divide others with Tetrahedralize, or remove them with "
      "Extract "
      "Cells By Type");
  }
}

Eigen::VectorXi ReadRegions(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name.c_str());
  if (name.empty() || (!array && name == "RegionId"))
  {
    return {};
  }
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw shape::InvalidInput("the Input has no cell array '" + name +
      "' with one number for each cell; choose another Region Array, or none");
  }
  Eigen::VectorXi regions(array->GetNumberOfTuples());
  for (Eigen::Index cell = 0; cell < regions.size(); ++cell)
  {
    const double region = array->GetComponent(cell, 0);
    if (region != std::floor(region) || std::abs(region) >= std::numeric_limits<int>::max())
    {
      throw shape::InvalidInput("the cell array '" + name + "' has the value " +
        std::to_string(region) + " at cell " + std::to_string(cell) +
        "; use integers from 0, or choose another Region Array");
    }
    regions(cell) = static_cast<int>(region);
  }
  return regions;
}

} // namespace

std::string vtkShapeWriter::GetLabel()
{
  return vtkShapeAlgorithm::LabelOf(this->GetClassName());
}

int vtkShapeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

shape::MeshSets vtkShapeWriter::ReadInput(const shape::Progress& progress)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(vtkUnstructuredGrid::SafeDownCast(this->GetInput()));
  if (grid->GetCellGhostArray())
  {
    grid->RemoveGhostCells();
  }
  shape::Cells cells = vtkShapeConvert::ToCells(grid, "the Input");
  vtkShapeConvert::ReorderVoxels(cells);
  RequireKnownCells(cells);
  return shape::FindMeshSets(
    cells, ReadRegions(grid, this->RegionArray), this->FeatureAngle, progress);
}

void vtkShapeWriter::WriteWhole(const shape::MeshSets& sets, const shape::Progress& progress)
{
  const auto why = [] { return " (" + std::generic_category().message(errno) + "); "; };
  // Streams do not report why they failed, but the system calls that they use set errno.
  errno = 0;
  std::ofstream file(this->FileName);
  if (!file)
  {
    throw FileError("cannot open the file '" + this->FileName + "'" + why() +
        "choose an existing folder with write permission",
      vtkErrorCode::CannotOpenFileError);
  }
  try
  {
    file.imbue(std::locale::classic()); // otherwise digits may be grouped
    this->WriteText(file, sets, progress);
    file.close();
    if (!file)
    {
      throw FileError("the file '" + this->FileName + "' could not be written completely" + why() +
          "free some space, or choose another disk",
        vtkErrorCode::OutOfDiskSpaceError);
    }
  }
  catch (...)
  {
    file.close();
    std::error_code ignored;
    // A partial file is removed, but never a device or a pipe.
    if (std::filesystem::is_regular_file(this->FileName, ignored))
    {
      std::filesystem::remove(this->FileName, ignored);
    }
    throw;
  }
}

void vtkShapeWriter::WriteData()
{
  const shape::Progress progress = vtkShapeProgress::Make(this, this->GetLabel());
  unsigned long code = vtkErrorCode::UserError;
  std::string message;
  try
  {
    if (this->FileName.empty())
    {
      throw FileError("there is no file name; set one", vtkErrorCode::NoFileNameError);
    }
    this->WriteWhole(this->ReadInput(progress.Part(0.0, 0.5, "reading the input")),
      progress.Part(0.5, 1.0, "writing the file"));
    return;
  }
  catch (const shape::Aborted&)
  {
  }
  catch (const FileError& error)
  {
    code = error.Code;
    message = error.what();
  }
  catch (const std::bad_alloc&)
  {
    message = "out of memory; use a coarser mesh";
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  this->SetErrorCode(code);
  if (!message.empty())
  {
    vtkErrorMacro(<< this->GetLabel() << ": " << message);
  }
}

void vtkShapeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "RegionArray: " << this->RegionArray << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
