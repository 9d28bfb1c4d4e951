#pragma once

#include "vtkSmartPointer.h"

#include "Base/Processes.h"

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
 * processes of the controller must call the functions in the same order. With a null controller or
 * with one process, nothing is sent.
 */
namespace vtkShapeGather
{

/// Returns the number of points of `data`, including its blocks, over all processes.
vtkIdType CountPoints(vtkDataObject* data, vtkMultiProcessController* controller);

/// The points of several blocks or processes that become one. Points of a single piece are kept.
enum class Joined
{
  Coincident, ///< points at one position: the pieces of a surface are connected
  Copies      ///< points at one position with the same point data, which cutting made of one point
};

/**
 * Returns all blocks of `data` of all processes as one vtkPolyData, the same on every process.
 *
 * Ghost cells are omitted. An unstructured grid of surface cells becomes a vtkPolyData. ownPoints:
 * for each point of the blocks of this process, in order, its index in the result. name: denotes
 * the data in errors. Throws shape::InvalidInput on every process if a block is no surface.
 */
vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const std::string& name, Joined joined,
  vtkMultiProcessController* controller, std::vector<int>& ownPoints);

/**
 * Returns all blocks of `data` of all processes as one vtkUnstructuredGrid, the same on every
 * process. It has the arrays that all blocks have. All points are kept. Ghost cells, hidden cells
 * and the arrays that mark them are omitted.
 */
vtkSmartPointer<vtkUnstructuredGrid> GatherGrid(
  vtkDataObject* data, vtkMultiProcessController* controller);

/// Calls `work` on every process. If it throws on one process, this function throws on all
/// processes. Use it for work of Execute that precedes a collective call. Otherwise, the other
/// processes would wait forever for a process that has failed.
void RunOnAllOrFail(vtkMultiProcessController* controller, const std::function<void()>& work);

/// Calls `work` on every process, which may sum values over the processes. If it throws on one
/// process, the next sum of the others throws, and this function throws on all processes.
void RunTogether(
  vtkMultiProcessController* controller, const std::function<void(const shape::Processes&)>& work);

/// Returns the number of positions over all processes. A position that several processes have, at a
/// seam between their pieces, counts once.
double CountOnce(
  vtkMultiProcessController* controller, const std::vector<Eigen::RowVector3d>& positions);

///@{
/// Replaces the argument on every process by the data of the first process.
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

/// Combines each of the `count` values over all processes. Overwrites `values` with the results, on
/// every process.
void Reduce(vtkMultiProcessController* controller, double* values, int count, Reduction reduction);

/// If `failed` is true on any process, sets it to true on all processes, and sets `message` to the
/// message of the first process that failed.
void AgreeOnFailure(vtkMultiProcessController* controller, bool& failed, std::string& message);

} // namespace vtkShapeGather
