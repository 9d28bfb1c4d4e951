#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataObject;
class vtkPolyData;
class vtkShapeAlgorithm;

/// Detects whether an input of a filter has changed, so that results computed from it can be reused
/// if it has not.
class vtkShapeSeenInput
{
public:
  /// Returns whether the first connection of a port has other data than at the last call, or
  /// whether this is the first call. whole: the gathered data of the input. Data of other processes
  /// may change without notice: then `whole` is compared number by number.
  bool IsNew(vtkShapeAlgorithm& filter, int port, vtkPolyData* whole);

private:
  vtkDataObject* Data = nullptr; ///< only compared, since it may have been deleted
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkPolyData> Copy; ///< of the gathered data of several processes
};
