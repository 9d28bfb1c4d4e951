#include "vtkShapeComposite.h"

#include "vtkShapeConvert.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTypes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include "Base/Errors.h"

#include <algorithm>

std::vector<vtkDataSet*> vtkShapeComposite::Of(vtkDataObject* data)
{
  std::vector<vtkDataSet*> leaves;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
      {
        leaves.push_back(leaf);
      }
    }
  }
  else if (auto* leaf = vtkDataSet::SafeDownCast(data))
  {
    leaves.push_back(leaf);
  }
  return leaves;
}

std::string vtkShapeComposite::FindOutputType(vtkDataObject* input, Points points)
{
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    // Other composites, such as AMR, cannot hold structured or moved grids.
    return vtkDataObjectTree::SafeDownCast(input) ? input->GetClassName() : "vtkMultiBlockDataSet";
  }
  const bool keeps = points == Points::Kept || vtkPointSet::SafeDownCast(input);
  return keeps ? input->GetClassName() : "vtkStructuredGrid";
}

void vtkShapeComposite::Move(vtkDataSet* input, const Eigen::MatrixXd& points, vtkDataSet* output)
{
  auto* moved = vtkPointSet::SafeDownCast(output);
  // Images and rectilinear grids have no points of their own: moved, they are structured grids.
  if (auto* image = vtkImageData::SafeDownCast(input))
  {
    vtkStructuredGrid::SafeDownCast(output)->SetExtent(image->GetExtent());
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(input))
  {
    vtkStructuredGrid::SafeDownCast(output)->SetExtent(grid->GetExtent());
  }
  else
  {
    moved->CopyStructure(input);
  }
  vtkNew<vtkPoints> positions;
  positions->SetData(vtkShapeConvert::ToArray(points, "Points"));
  moved->SetPoints(positions);
  moved->GetPointData()->PassData(input->GetPointData());
  moved->GetCellData()->PassData(input->GetCellData());
  moved->GetFieldData()->PassData(input->GetFieldData());
}

void vtkShapeComposite::RequireDataSets(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      RequireDataSets(it->GetCurrentDataObject());
    }
  }
  // Tables and other blocks without points cannot pass through a filter of points.
  else if (!vtkDataSet::SafeDownCast(data))
  {
    throw shape::InvalidInput(std::string("a block is a ") + data->GetClassName() +
      ", which has no points; remove it with Extract Block");
  }
}

void vtkShapeComposite::ForEach(vtkDataObject* input, vtkDataObject* output, Points points,
  const std::function<void(vtkDataSet* input, vtkDataSet* output)>& fill)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    fill(vtkDataSet::SafeDownCast(input), vtkDataSet::SafeDownCast(output));
    return;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(output);
  // Otherwise the blocks are numbered in the order of traversal.
  const bool sameTree = input->IsA(output->GetClassName());
  if (sameTree)
  {
    tree->CopyStructure(composite);
  }
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  unsigned int block = 0;
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
    RequireDataSets(it->GetCurrentDataObject());
    vtkSmartPointer<vtkDataSet> filled;
    filled.TakeReference(vtkDataSet::SafeDownCast(
      vtkDataObjectTypes::NewDataObject(FindOutputType(leaf, points).c_str())));
    fill(leaf, filled);
    if (sameTree)
    {
      tree->SetDataSet(it, filled);
    }
    else
    {
      vtkMultiBlockDataSet::SafeDownCast(output)->SetBlock(block++, filled);
    }
  }
  output->GetFieldData()->PassData(input->GetFieldData());
}

void vtkShapeComposite::ActivateScalars(vtkDataObject* data, const std::vector<std::string>& names)
{
  for (vtkDataSet* leaf : Of(data))
  {
    vtkDataSetAttributes* const kinds[] = { leaf->GetCellData(), leaf->GetPointData() };
    const auto isHere = [&](const std::string& name)
    { return kinds[0]->HasArray(name.c_str()) || kinds[1]->HasArray(name.c_str()); };
    const auto name = std::find_if(names.begin(), names.end(), isHere);
    if (name == names.end())
    {
      continue;
    }
    for (vtkDataSetAttributes* kind : kinds)
    {
      kind->SetActiveScalars(kind->HasArray(name->c_str()) ? name->c_str() : nullptr);
    }
  }
}

void vtkShapeComposite::AddPointFields(
  vtkDataObject* input, vtkDataObject* output, const std::vector<PointField>& fields)
{
  vtkIdType first = 0;
  ForEach(input, output, Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const vtkIdType count = from->GetNumberOfPoints();
      to->ShallowCopy(from);
      for (const PointField& field : fields)
      {
        const auto own = field.Values.middleRows(first, count);
        if (!field.AreIds)
        {
          to->GetPointData()->AddArray(vtkShapeConvert::ToArray(own, field.Name));
          continue;
        }
        vtkNew<vtkIdTypeArray> ids;
        ids->SetName(field.Name.c_str());
        ids->SetNumberOfTuples(count);
        // Doubles represent all ids up to 2^53 exactly.
        std::transform(own.col(0).begin(), own.col(0).end(), ids->GetPointer(0),
          [](double id) { return static_cast<vtkIdType>(id); });
        to->GetPointData()->AddArray(ids);
      }
      first += count;
    });
}
