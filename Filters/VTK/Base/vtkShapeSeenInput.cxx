#include "vtkShapeSeenInput.h"

#include "vtkShapeAlgorithm.h"
#include "vtkShapeComposite.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

namespace
{

bool AreSame(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b)
  {
    return a == b;
  }
  const auto name = [](vtkAbstractArray* array)
  { return std::string(array->GetName() ? array->GetName() : ""); };
  if (name(a) != name(b) || a->GetDataType() != b->GetDataType() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents() ||
    a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return false;
  }
  const vtkIdType count = a->GetNumberOfValues();
  if (vtkDataArray::SafeDownCast(a))
  {
    return count == 0 ||
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(count * a->GetDataTypeSize())) == 0;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (a->GetVariantValue(i) != b->GetVariantValue(i))
    {
      return false;
    }
  }
  return true;
}

bool AreSame(vtkFieldData* a, vtkFieldData* b)
{
  const int count = a->GetNumberOfArrays();
  bool areSame = count == b->GetNumberOfArrays();
  for (int i = 0; areSame && i < count; ++i)
  {
    areSame = AreSame(a->GetAbstractArray(i), b->GetAbstractArray(i));
  }
  return areSame;
}

/// Includes the attribute types of the arrays.
bool AreSame(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  int rolesOfA[vtkDataSetAttributes::NUM_ATTRIBUTES];
  int rolesOfB[vtkDataSetAttributes::NUM_ATTRIBUTES];
  a->GetAttributeIndices(rolesOfA);
  b->GetAttributeIndices(rolesOfB);
  return std::equal(std::begin(rolesOfA), std::end(rolesOfA), rolesOfB) &&
    AreSame(static_cast<vtkFieldData*>(a), static_cast<vtkFieldData*>(b));
}

bool AreSame(vtkCellArray* a, vtkCellArray* b)
{
  return AreSame(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
    AreSame(a->GetConnectivityArray(), b->GetConnectivityArray());
}

bool HaveSameCells(vtkPolyData* a, vtkPolyData* b)
{
  return AreSame(a->GetVerts(), b->GetVerts()) && AreSame(a->GetLines(), b->GetLines()) &&
    AreSame(a->GetPolys(), b->GetPolys()) && AreSame(a->GetStrips(), b->GetStrips());
}

bool HaveSameCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return AreSame(a->GetCells(), b->GetCells()) &&
    AreSame(a->GetCellTypesArray(), b->GetCellTypesArray()) &&
    AreSame(a->GetFaces(), b->GetFaces());
}

bool AreSame(vtkPointSet* a, vtkPointSet* b)
{
  const auto positions = [](vtkPointSet* data)
  { return data->GetPoints() ? data->GetPoints()->GetData() : nullptr; };
  auto* surface = vtkPolyData::SafeDownCast(a);
  const bool haveSameCells = surface
    ? HaveSameCells(surface, vtkPolyData::SafeDownCast(b))
    : HaveSameCells(vtkUnstructuredGrid::SafeDownCast(a), vtkUnstructuredGrid::SafeDownCast(b));
  return haveSameCells && AreSame(positions(a), positions(b)) &&
    AreSame(a->GetPointData(), b->GetPointData()) && AreSame(a->GetCellData(), b->GetCellData()) &&
    AreSame(a->GetFieldData(), b->GetFieldData());
}

} // namespace

/// With one process, the identity and the modification time of the input are sufficient. With
/// several processes, these may change on some of them only, and the gathered data are new objects
/// each time. So the data themselves are compared, which gives the same result on every process.
bool vtkShapeSeenInput::IsNew(vtkShapeAlgorithm& filter, int port, vtkPointSet* whole)
{
  vtkMultiProcessController* controller = filter.GetController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    const bool isSame = this->Copy && AreSame(this->Copy, whole);
    if (!isSame)
    {
      this->Copy.TakeReference(whole->NewInstance());
      this->Copy->DeepCopy(whole);
    }
    return !isSame;
  }
  return this->IsNewHere(filter, port);
}

bool vtkShapeSeenInput::IsNewHere(vtkShapeAlgorithm& filter, int port)
{
  vtkDataObject* data = filter.GetInputDataObject(port, 0);
  // The modification time of composite data does not change when a block is modified.
  vtkMTimeType time = data->GetMTime();
  for (vtkDataSet* leaf : vtkShapeComposite::Of(data))
  {
    time = std::max(time, leaf->GetMTime());
  }
  const bool isSame = data == this->Data && time == this->Time;
  this->Data = data;
  this->Time = time;
  return !isSame;
}
