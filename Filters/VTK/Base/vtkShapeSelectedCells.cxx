#include "vtkShapeSelectedCells.h"

#include "vtkShapeComposite.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTypes.h"
#include "vtkExtractSelection.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include "Base/Errors.h"

#include <algorithm>
#include <vector>

namespace
{

void SetMarks(vtkDataSet* data, const std::vector<char>& marks)
{
  vtkNew<vtkIntArray> array;
  array->SetName(vtkShapeSelectedCells::Name.c_str());
  array->SetNumberOfValues(data->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    array->SetValue(cell, marks[cell]);
  }
  data->GetCellData()->AddArray(array);
}

/// Returns the parts of a selection that refer to this process.
vtkSmartPointer<vtkSelection> Own(vtkSelection* selection, vtkMultiProcessController* controller)
{
  const int process = controller ? controller->GetLocalProcessId() : 0;
  auto own = vtkSmartPointer<vtkSelection>::New();
  own->ShallowCopy(selection);
  for (int i = static_cast<int>(own->GetNumberOfNodes()) - 1; i >= 0; --i)
  {
    vtkInformation* properties = own->GetNode(i)->GetProperties();
    // Without a process, or with -1, a node refers to all of them.
    if (properties->Has(vtkSelectionNode::PROCESS_ID()) &&
      properties->Get(vtkSelectionNode::PROCESS_ID()) >= 0 &&
      properties->Get(vtkSelectionNode::PROCESS_ID()) != process)
    {
      own->RemoveNode(own->GetNode(i));
    }
  }
  return own;
}

/// Converts the result of vtkExtractSelection for a block: marks of its cells, or of its points. A
/// block that the selection does not contain is empty. Selected points stand for the cells whose
/// points are all selected.
std::vector<char> MarksOf(vtkDataSet* data, vtkIdType count)
{
  const char* name = "vtkInsidedness";
  std::vector<char> marks(count, 0);
  if (data->GetNumberOfCells() != count)
  {
    return marks;
  }
  if (vtkDataArray* cells = data->GetCellData()->GetArray(name))
  {
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      marks[cell] = static_cast<char>(cells->GetComponent(cell, 0) > 0.0);
    }
  }
  else if (vtkDataArray* points = data->GetPointData()->GetArray(name))
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      data->GetCellPoints(cell, ids);
      marks[cell] = static_cast<char>(ids->GetNumberOfIds() > 0 &&
        std::all_of(ids->begin(), ids->end(),
          [&](vtkIdType point) { return points->GetComponent(point, 0) > 0.0; }));
    }
  }
  return marks;
}

vtkSmartPointer<vtkDataObject> ByQuery(vtkDataObject* surface, vtkSelection* selection)
{
  vtkNew<vtkExtractSelection> extract;
  // The result keeps all cells and marks the selected ones, so blocks and cell ids stay.
  extract->PreserveTopologyOn();
  extract->SetInputDataObject(0, surface);
  extract->SetInputDataObject(1, selection);
  extract->Update();
  return extract->GetOutputDataObject(0);
}

std::vector<char> MarksOfExtracted(vtkDataSet* extracted, vtkIdType cells)
{
  std::vector<char> marks(cells, 0);
  vtkDataArray* ids = extracted->GetCellData()->GetArray("vtkOriginalCellIds");
  if (!ids && extracted->GetNumberOfCells() > 0)
  {
    throw shape::InvalidInput(
      "the Selection has no cell array 'vtkOriginalCellIds'; connect a selection made in a view, "
      "or the output of Extract Selection applied to the Input");
  }
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(ids->GetComponent(i, 0));
    if (cell < 0 || cell >= cells)
    {
      throw shape::InvalidInput("the Selection contains cell " + std::to_string(cell) +
        ", but the Input has only " + std::to_string(cells) +
        " cells; extract the selection from the Input itself");
    }
    marks[cell] = 1;
  }
  return marks;
}

/// Returns, for each data set of one tree, the data set at the same position in another tree, or
/// nullptr if there is none.
std::vector<vtkDataSet*> LeavesLike(vtkDataObject* like, vtkDataObject* data)
{
  auto* tree = vtkCompositeDataSet::SafeDownCast(like);
  auto* other = vtkCompositeDataSet::SafeDownCast(data);
  if ((tree == nullptr) != (other == nullptr))
  {
    throw shape::InvalidInput("the Selection does not have the same blocks as the Input; extract "
                              "the selection from the Input itself");
  }
  if (!tree)
  {
    return { vtkDataSet::SafeDownCast(data) };
  }
  std::vector<vtkDataSet*> leaves;
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(tree->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    leaves.push_back(vtkDataSet::SafeDownCast(other->GetDataSet(it)));
  }
  return leaves;
}

} // namespace

vtkSmartPointer<vtkDataObject> vtkShapeSelectedCells::Mark(
  vtkDataObject* surface, vtkDataObject* selection, vtkMultiProcessController* controller)
{
  auto* query = vtkSelection::SafeDownCast(selection);
  const vtkSmartPointer<vtkDataObject> found =
    query ? ByQuery(surface, Own(query, controller)) : vtkSmartPointer<vtkDataObject>(selection);
  const std::vector<vtkDataSet*> leaves = LeavesLike(surface, found);
  const std::string type =
    vtkShapeComposite::FindOutputType(surface, vtkShapeComposite::Points::Kept);
  auto marked =
    vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type.c_str()));
  std::size_t next = 0;
  vtkShapeComposite::ForEach(surface, marked, vtkShapeComposite::Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      to->ShallowCopy(from);
      vtkDataSet* leaf = leaves[next++];
      SetMarks(to,
        !leaf     ? std::vector<char>(from->GetNumberOfCells(), 0)
          : query ? MarksOf(leaf, from->GetNumberOfCells())
                  : MarksOfExtracted(leaf, from->GetNumberOfCells()));
    });
  return marked;
}
