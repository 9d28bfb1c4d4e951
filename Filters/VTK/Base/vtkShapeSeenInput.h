#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataObject;
class vtkPointSet;
class vtkShapeAlgorithm;

/// Detects whether an input of a filter has changed. If it has not, results computed from it can be
/// reused.
class vtkShapeSeenInput
{
public:
  /// Returns whether this is the first call, or the first connection of a port has other data than
  /// at the last call. whole: the gathered data of the input, a vtkPolyData or a
  /// vtkUnstructuredGrid. With several processes, `whole` is compared value by value, because a
  /// change on another process leaves the modification time here unchanged.
  bool IsNew(vtkShapeAlgorithm& filter, int port, vtkPointSet* whole);
  /// The same for the data of this process alone, for results that other processes do not need.
  bool IsNewHere(vtkShapeAlgorithm& filter, int port);

private:
  vtkDataObject* Data = nullptr; ///< only compared, since the data may have been deleted
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkPointSet> Copy; ///< with several processes: the gathered data of the last call
};
