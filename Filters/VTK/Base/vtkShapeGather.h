#pragma once

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * The communication between the processes of a parallel ParaView. Every function is collective: all
 * processes of the controller call it, in the same order. With a null controller or one process
 * nothing is sent.
 */
namespace vtkShapeGather
{

/// Returns the number of points of `data`, including its blocks, over all processes.
vtkIdType CountPoints(vtkDataObject* data, vtkMultiProcessController* controller);

/**
 * Returns all blocks of `data` of all processes as one vtkPolyData, the same on every process.
 *
 * weld: points with the same coordinates in several blocks or processes become one, so that the
 * pieces of a surface are connected; otherwise every point stays. Ghost cells are left out.
 * Throws shape::InvalidInput on every process if a block is not vtkPolyData; `name` denotes the
 * data in the message. ownPoints: for each point of this process's blocks, in order, its index in
 * the result.
 */
vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const std::string& name, bool weld,
  vtkMultiProcessController* controller, std::vector<int>& ownPoints);

/**
 * Returns all blocks of `data` of all processes as one vtkUnstructuredGrid, the same on every
 * process, with the arrays that all of them have. All points are kept. Ghost and hidden cells are
 * left out, and so are the arrays that mark them.
 */
vtkSmartPointer<vtkUnstructuredGrid> GatherGrid(
  vtkDataObject* data, vtkMultiProcessController* controller);

/// Calls `work` on every process. If it throws on one process, this function throws on all. Use it
/// for the work of Execute before a collective call, since no process may wait for one that has
/// failed.
void RunOnAllOrFail(vtkMultiProcessController* controller, const std::function<void()>& work);

///@{
/// Copies the data of the first process to every process.
void Share(vtkMultiProcessController* controller, vtkDataObject* data);
void Share(vtkMultiProcessController* controller, Eigen::MatrixXd& matrix);
///@}

/// The operation that combines the values of the processes.
enum class Reduction
{
  Sum,
  Minimum,
  Maximum
};

/// Combines each of `count` values over all processes, and overwrites them with the results.
void Reduce(vtkMultiProcessController* controller, double* values, int count, Reduction reduction);

/// Sets `failed` on every process if it is set on any, and `message` to that of the first process
/// that failed.
void AgreeOnFailure(vtkMultiProcessController* controller, bool& failed, std::string& message);

} // namespace vtkShapeGather
