#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataObject;
class vtkPolyData;
class vtkShapeAlgorithm;

/// Remembers an input of a filter, so that what was made from it can be kept while it stays as it
/// is.
class vtkShapeSeenInput
{
public:
  /// Whether the first connection of a port has other data than at the last call, if there was one.
  /// whole: all of it, gathered. What other processes have may change unseen: then `whole` is
  /// compared, number by number.
  bool IsNew(vtkShapeAlgorithm& filter, int port, vtkPolyData* whole);

private:
  vtkDataObject* Data = nullptr; ///< for comparison alone: it may be gone
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkPolyData> Copy; ///< of several processes' data
};
