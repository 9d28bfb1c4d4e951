#include "vtkShapeFacts.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <utility>

namespace
{

/// Returns the field data of a data object and of its blocks.
std::vector<vtkFieldData*> FieldsOf(vtkDataObject* data)
{
  std::vector<vtkFieldData*> fields = { data->GetFieldData() };
  for (vtkDataSet* block : vtkShapeComposite::Of(data))
  {
    if (block != data)
    {
      fields.push_back(block->GetFieldData());
    }
  }
  return fields;
}

/// Returns the values of an array as one tuple.
vtkSmartPointer<vtkAbstractArray> ToRow(vtkAbstractArray* array)
{
  auto row = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  row->SetName(array->GetName());
  row->SetNumberOfComponents(static_cast<int>(array->GetNumberOfValues()));
  for (int c = 0; array->GetNumberOfTuples() == 1 && c < array->GetNumberOfComponents(); ++c)
  {
    if (const char* name = array->GetComponentName(c))
    {
      row->SetComponentName(c, name);
    }
  }
  row->SetNumberOfTuples(1);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    row->SetVariantValue(i, array->GetVariantValue(i));
  }
  return row;
}

} // namespace

void vtkShapeFacts::Move(const std::string& prefix, const std::vector<vtkDataObject*>& inputs,
  const std::set<std::string>& kept, vtkDataObject* output, vtkTable* facts)
{
  std::set<const vtkAbstractArray*> inherited;
  for (vtkDataObject* input : inputs)
  {
    for (vtkFieldData* field : FieldsOf(input))
    {
      for (int i = 0; i < field->GetNumberOfArrays(); ++i)
      {
        inherited.insert(field->GetAbstractArray(i));
      }
    }
  }
  for (vtkFieldData* field : FieldsOf(output))
  {
    // Removing an array renumbers the others.
    std::vector<vtkSmartPointer<vtkAbstractArray>> found;
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = field->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (name.compare(0, prefix.size(), prefix) == 0 && !inherited.count(array))
      {
        found.emplace_back(array);
      }
    }
    for (const vtkSmartPointer<vtkAbstractArray>& array : found)
    {
      if (!facts->GetColumnByName(array->GetName()) && array->GetNumberOfValues() > 0)
      {
        facts->AddColumn(ToRow(array));
      }
      if (!kept.count(array->GetName() + prefix.size()))
      {
        field->RemoveArray(array->GetName());
      }
    }
  }
}

void vtkShapeFacts::AddWarnings(const std::string& prefix, const std::vector<std::string>& warnings,
  int splitPoints, int removedTriangles, vtkDataObject* output)
{
  std::string all;
  for (const std::string& warning : warnings)
  {
    all += (all.empty() ? "" : "; ") + warning;
  }
  vtkShapeConvert::AddFact(output, prefix + "Warning", all);
  const std::pair<const char*, int> repaired[] = { { "SplitPoints", splitPoints },
    { "RemovedTriangles", removedTriangles } };
  for (const auto& [fact, count] : repaired)
  {
    if (count > 0)
    {
      vtkShapeConvert::AddFact(output, prefix + fact, static_cast<double>(count));
    }
  }
}
