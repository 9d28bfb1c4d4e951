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
 * What the processes of a parallel ParaView tell each other. Every function is collective: all
 * processes of the controller call it, in the same order. With a null controller or one process
 * nothing is sent.
 */
namespace vtkShapeGather
{

/// The number of points of `data`, its blocks included, over all processes.
vtkIdType CountPoints(vtkDataObject* data, vtkMultiProcessController* controller);

/**
 * All blocks of `data` of all processes as one vtkPolyData, the same on every process.
 *
 * weld: points with the same coordinates in several blocks or processes become one, so that the
 * pieces of a surface are connected; otherwise every point stays. Ghost cells are left out.
 * A block that is not vtkPolyData raises shape::InvalidInput, on every process; `name` is what its
 * message calls the data. ownPoints: for each point of this process's blocks, in order, its index
 * in the whole.
 */
vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const std::string& name, bool weld,
  vtkMultiProcessController* controller, std::vector<int>& ownPoints);

/**
 * All blocks of `data` of all processes as one vtkUnstructuredGrid, the same on every process, with
 * the arrays that all of them have. Every point stays. Ghost and hidden cells are left out, and so
 * are the arrays that mark them.
 */
vtkSmartPointer<vtkUnstructuredGrid> GatherGrid(
  vtkDataObject* data, vtkMultiProcessController* controller);

/// Does `work` on every process; where it throws on one, throws on all: what Execute does before a
/// collective call goes in here, since no process may wait for one that has failed.
void RunOnAllOrFail(vtkMultiProcessController* controller, const std::function<void()>& work);

///@{
/// What the first process has, on every process.
void Share(vtkMultiProcessController* controller, vtkDataObject* data);
void Share(vtkMultiProcessController* controller, Eigen::MatrixXd& matrix);
///@}

/// How the processes' values become one.
enum class Reduction
{
  Sum,
  Minimum,
  Maximum
};

/// Reduces `count` values, each over all processes, and overwrites them.
void Reduce(vtkMultiProcessController* controller, double* values, int count, Reduction reduction);

/// Sets `failed` on every process where it is set on one, and `message` to that of the first that
/// failed.
void AgreeOnFailure(vtkMultiProcessController* controller, bool& failed, std::string& message);

} // namespace vtkShapeGather
