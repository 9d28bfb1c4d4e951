#pragma once

class vtkAlgorithm;
class vtkMultiProcessController;

/**
 * The turn of a filter: while an object of this class exists, filters in other threads of the
 * process wait. BLAS has one number of threads for the entire process, which a kernel sets for a
 * while, and the bits of its results depend on this number. Within a thread, turns may be nested.
 *
 * A thread that waits releases Python's lock if it holds it, because the thread whose turn it is
 * may need it for an observer.
 */
class vtkShapeTurn
{
public:
  /// Waits for the turn. With several processes, it does not wait, because processes could wait for
  /// each other's turns in different orders. Throws shape::Aborted if AbortExecute of `filter` is
  /// set meanwhile.
  vtkShapeTurn(vtkAlgorithm* filter, vtkMultiProcessController* controller);
  ~vtkShapeTurn();
  vtkShapeTurn(const vtkShapeTurn&) = delete;
  vtkShapeTurn& operator=(const vtkShapeTurn&) = delete;

private:
  bool IsMine = false;
};
