#include "vtkShapeHTMLWriter.h"

#include "vtkShapeConvert.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include "IO/HTMLWriter.h"

#include <filesystem>
#include <utility>

vtkStandardNewMacro(vtkShapeHTMLWriter);

namespace
{

/// Appends the arrays that a page can show.
void AddPageArrays(
  vtkDataSetAttributes* data, bool areOfCells, std::vector<shape::PageArray>& arrays)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    constexpr int most = 3;
    if (!array || !array->GetName() || array->GetNumberOfComponents() > most)
    {
      continue;
    }
    shape::PageArray shown{ array->GetName(), areOfCells, array->GetNumberOfComponents(), {} };
    for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
    {
      for (int k = 0; k < shown.Components; ++k)
      {
        shown.Values.push_back(static_cast<float>(array->GetComponent(tuple, k)));
      }
    }
    arrays.push_back(std::move(shown));
  }
}

/// Returns the single numbers and words of the field data.
std::vector<std::pair<std::string, std::string>> ReadFacts(vtkFieldData* data)
{
  std::vector<std::pair<std::string, std::string>> facts;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetName() && array->GetNumberOfValues() == 1)
    {
      facts.emplace_back(array->GetName(), array->GetVariantValue(0).ToString());
    }
  }
  return facts;
}

} // namespace

int vtkShapeHTMLWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkShapeFileWriter::Content vtkShapeHTMLWriter::ReadInput(const shape::Progress&)
{
  auto* input = vtkDataSet::SafeDownCast(this->GetInput());
  vtkNew<vtkAppendFilter> toGrid;
  toGrid->AddInputData(input);
  toGrid->Update();
  vtkUnstructuredGrid* grid = toGrid->GetOutput();
  if (grid->GetCellGhostArray())
  {
    grid->RemoveGhostCells();
  }
  shape::MeshPage page;
  page.Title =
    this->Title.empty() ? std::filesystem::path(this->FileName).stem().string() : this->Title;
  page.Facts = ReadFacts(input->GetFieldData());
  page.Mesh = vtkShapeConvert::ToCells(grid, "the Input");
  vtkShapeConvert::ReorderVoxels(page.Mesh);
  AddPageArrays(grid->GetCellData(), true, page.Arrays);
  AddPageArrays(grid->GetPointData(), false, page.Arrays);
  return [page = std::move(page)](std::ostream& file, const shape::Progress& progress)
  { shape::WriteHTML(file, page, progress); };
}

void vtkShapeHTMLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->Title << "\n";
}
