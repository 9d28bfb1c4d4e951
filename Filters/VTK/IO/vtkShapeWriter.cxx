#include "vtkShapeWriter.h"

#include "vtkShapeConvert.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "IO/MeshSets.h"
#include "Mesh/CellFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace
{

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
  if (!vtkShapeConvert::IsChosen(name) || (!array && name == "RegionId"))
  {
    return {};
  }
  return vtkShapeConvert::ToCellIntegers(
    grid, name, "the Input", "choose another Region Array, or None");
}

Eigen::VectorXd ReadNumbers(vtkDataArray* array)
{
  Eigen::VectorXd numbers(array->GetNumberOfTuples());
  for (Eigen::Index cell = 0; cell < numbers.size(); ++cell)
  {
    numbers(cell) = array->GetComponent(cell, 0);
  }
  return numbers;
}

shape::MeshMaterials ReadMaterials(
  vtkUnstructuredGrid* grid, const shape::MeshMaterialsOptions& options)
{
  vtkDataArray* arrays[3];
  const char* const names[3] = { "MaterialId", "MaterialModulus", "MaterialDensity" };
  for (int i = 0; i < 3; ++i)
  {
    arrays[i] = grid->GetCellData()->GetArray(names[i]);
    if (!arrays[i] || arrays[i]->GetNumberOfComponents() != 1)
    {
      return {};
    }
  }
  return shape::FindMeshMaterials(vtkShapeConvert::ToCellIntegers(grid, names[0], "the Input",
                                    "remove the array with Pass Arrays"),
    ReadNumbers(arrays[1]), ReadNumbers(arrays[2]), options);
}

/// Reads the patch of each face of each hexahedron.
Eigen::MatrixXi ReadFacePatches(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray("FacePatch");
  if (!array || array->GetNumberOfComponents() != 6)
  {
    return {};
  }
  Eigen::MatrixXi patches(array->GetNumberOfTuples(), 6);
  for (Eigen::Index cell = 0; cell < patches.rows(); ++cell)
  {
    for (int face = 0; face < 6; ++face)
    {
      patches(cell, face) = static_cast<int>(array->GetComponent(cell, face));
    }
  }
  return patches;
}

} // namespace

int vtkShapeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkShapeFileWriter::Content vtkShapeWriter::ReadInput(const shape::Progress& progress)
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
  shape::MeshSets sets = shape::FindMeshSets(cells, ReadRegions(grid, this->RegionArray),
    this->FeatureAngle, ReadFacePatches(grid), progress.Part(0.0, 0.7));
  sets.Materials = ReadMaterials(grid, this->MaterialOptions);
  this->AddFiles(sets, progress.Part(0.7, 1.0));
  return [this, sets = std::move(sets)](std::ostream& file, const shape::Progress& part)
  { this->WriteText(file, sets, part); };
}

void vtkShapeWriter::AddFiles(const shape::MeshSets&, const shape::Progress&)
{
}

void vtkShapeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RegionArray: " << this->RegionArray << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "PoissonRatio: " << this->MaterialOptions.PoissonRatio << "\n";
  os << indent << "DensityScale: " << this->MaterialOptions.DensityScale << "\n";
}
