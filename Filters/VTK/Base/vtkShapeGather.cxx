#include "vtkShapeGather.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConcatenate.h"
#include "vtkShapeSurfaces.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <numeric>

namespace
{

bool IsParallel(vtkMultiProcessController* controller)
{
  return controller && controller->GetNumberOfProcesses() > 1;
}

/// Whether two points have the same value in every array.
bool HaveSameData(vtkPointData* data, vtkIdType a, vtkIdType b)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const vtkIdType components = array->GetNumberOfComponents();
    for (vtkIdType c = 0; c < components; ++c)
    {
      if (array->GetVariantValue(a * components + c) != array->GetVariantValue(b * components + c))
      {
        return false;
      }
    }
  }
  return true;
}

/// Returns, for each point, the first of the points that become one, which may be the point itself.
/// pieceOf: the piece of each point.
std::vector<vtkIdType> FindJoinedPoints(
  vtkPolyData* data, vtkShapeGather::Joined joined, const std::vector<int>& pieceOf)
{
  std::vector<vtkIdType> first(data->GetNumberOfPoints());
  std::iota(first.begin(), first.end(), 0);
  if (first.empty())
  {
    return first;
  }
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  // Only points with exactly equal coordinates are merged. Pieces of a distributed surface have
  // such copies along their common boundary.
  locator->MergePoints(0.0, first.data());
  if (joined == vtkShapeGather::Joined::Coincident)
  {
    return first;
  }
  // The points at one position that stay, such as charges of two layers.
  std::map<vtkIdType, std::vector<vtkIdType>> kept;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    std::vector<vtkIdType>& others = kept[first[i]];
    const auto same = std::find_if(others.begin(), others.end(),
      [&](vtkIdType other) {
        return pieceOf[other] != pieceOf[point] && HaveSameData(data->GetPointData(), other, point);
      });
    first[i] = same == others.end() ? point : *same;
    if (first[i] == point)
    {
      others.push_back(point);
    }
  }
  return first;
}

/// Merges several surfaces into one. pointMap: for each point of the inputs, in order, its index in
/// the result.
vtkSmartPointer<vtkPolyData> Merge(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces,
  vtkShapeGather::Joined joined, std::vector<vtkIdType>& pointMap)
{
  auto merged = vtkSmartPointer<vtkPolyData>::New();
  if (pieces.empty())
  {
    pointMap.clear();
    return merged;
  }
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  std::vector<int> pieceOf;
  for (vtkPolyData* piece : pieces)
  {
    append->AddInputData(piece);
    pieceOf.resize(
      pieceOf.size() + piece->GetNumberOfPoints(), append->GetNumberOfInputConnections(0));
  }
  append->Update();
  vtkPolyData* all = append->GetOutput();

  const std::vector<vtkIdType> firstCoincident = FindJoinedPoints(all, joined, pieceOf);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  merged->GetPointData()->CopyAllocate(all->GetPointData());
  pointMap.assign(firstCoincident.size(), -1);
  for (std::size_t i = 0; i < firstCoincident.size(); ++i)
  {
    vtkIdType& position = pointMap[firstCoincident[i]];
    // The data of the first point are kept.
    if (position == -1)
    {
      const auto point = static_cast<vtkIdType>(i);
      position = points->InsertNextPoint(all->GetPoint(point));
      merged->GetPointData()->CopyData(all->GetPointData(), point, position);
    }
    pointMap[i] = position;
  }
  merged->SetPoints(points);
  merged->AllocateCopy(all);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    all->GetCellPoints(cell, corners);
    for (vtkIdType corner = 0; corner < corners->GetNumberOfIds(); ++corner)
    {
      corners->SetId(corner, pointMap[corners->GetId(corner)]);
    }
    merged->InsertNextCell(all->GetCellType(cell), corners);
  }
  merged->GetCellData()->ShallowCopy(all->GetCellData());
  // All pieces of one data set have the same field data; processes without a piece may have none.
  const auto first = std::find_if(pieces.begin(), pieces.end(),
    [](vtkPolyData* piece) { return piece->GetNumberOfPoints() > 0; });
  merged->GetFieldData()->ShallowCopy((first == pieces.end() ? pieces[0] : *first)->GetFieldData());
  return merged;
}

/// Merges several data sets into one grid. Data sets without points are omitted.
vtkSmartPointer<vtkUnstructuredGrid> Merge(const std::vector<vtkDataSet*>& pieces)
{
  vtkNew<vtkAppendFilter> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (vtkDataSet* piece : pieces)
  {
    if (piece->GetNumberOfPoints() > 0)
    {
      append->AddInputData(piece);
    }
  }
  auto merged = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    merged->ShallowCopy(append->GetOutput());
  }
  return merged;
}

/// Returns one data set as a grid that shares all unchanged arrays, for filters that run while a
/// handle is dragged.
vtkSmartPointer<vtkUnstructuredGrid> ToGrid(vtkDataSet* data)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  // Vertices, lines and strips come in separate arrays, which only the append filter puts in order.
  if (!surface || surface->GetNumberOfPoints() == 0 ||
    surface->GetNumberOfCells() != surface->GetNumberOfPolys())
  {
    return Merge({ data });
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(surface->GetPoints());
  vtkCellArray* polygons = surface->GetPolys();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(polygons->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    const vtkIdType size = polygons->GetCellSize(cell);
    types->SetValue(cell, size == 3 ? VTK_TRIANGLE : (size == 4 ? VTK_QUAD : VTK_POLYGON));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(types, polygons);
  grid->GetPointData()->ShallowCopy(surface->GetPointData());
  grid->GetCellData()->ShallowCopy(surface->GetCellData());
  grid->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return grid;
}

} // namespace

void vtkShapeGather::RunOnAllOrFail(
  vtkMultiProcessController* controller, const std::function<void()>& work)
{
  bool failed = true;
  std::string message; // empty if the user stopped it
  try
  {
    work();
    failed = false;
  }
  catch (const shape::Aborted&)
  {
  }
  catch (const std::bad_alloc&)
  {
    message = "out of memory; use a coarser input or more memory for each process";
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  // Otherwise, processes would wait in the next collective call for a process that has failed.
  AgreeOnFailure(controller, failed, message);
  if (failed && message.empty())
  {
    throw shape::Aborted();
  }
  if (failed)
  {
    throw shape::InvalidInput(message);
  }
}

void vtkShapeGather::RunTogether(
  vtkMultiProcessController* controller, const std::function<void(const shape::Processes&)>& work)
{
  // Every sum begins with an agreement that no process has failed. A process that fails takes part
  // in the next agreement, by which the others fail in their sum; they do not agree again.
  bool agreed = false;
  shape::Processes processes;
  if (IsParallel(controller))
  {
    processes.Count = controller->GetNumberOfProcesses();
    processes.Number = controller->GetLocalProcessId();
    processes.Add = [&](double* values, Eigen::Index count)
    {
      agreed = true;
      RunOnAllOrFail(controller, [] {});
      agreed = false;
      // The lengths of messages are int.
      constexpr Eigen::Index longest = 1 << 24;
      for (Eigen::Index first = 0; first < count; first += longest)
      {
        Reduce(controller, values + first, static_cast<int>(std::min(longest, count - first)),
          Reduction::Sum);
      }
    };
  }
  std::exception_ptr failure;
  try
  {
    work(processes);
  }
  catch (...)
  {
    failure = std::current_exception();
    if (agreed)
    {
      throw;
    }
  }
  RunOnAllOrFail(controller,
    [&]
    {
      if (failure)
      {
        std::rethrow_exception(failure);
      }
    });
}

void vtkShapeGather::Share(vtkMultiProcessController* controller, vtkDataObject* data)
{
  if (IsParallel(controller))
  {
    controller->Broadcast(data, 0);
  }
}

void vtkShapeGather::Share(vtkMultiProcessController* controller, Eigen::MatrixXd& matrix)
{
  if (IsParallel(controller))
  {
    vtkIdType sizes[] = { matrix.rows(), matrix.cols() };
    controller->Broadcast(sizes, 2, 0);
    matrix.resize(sizes[0], sizes[1]);
    controller->Broadcast(matrix.data(), matrix.size(), 0);
  }
}

void vtkShapeGather::Reduce(
  vtkMultiProcessController* controller, double* values, int count, Reduction reduction)
{
  if (!IsParallel(controller))
  {
    return;
  }
  const std::vector<double> own(values, values + count);
  const int operation = reduction == Reduction::Sum ? vtkCommunicator::SUM_OP
    : reduction == Reduction::Minimum               ? vtkCommunicator::MIN_OP
                                                    : vtkCommunicator::MAX_OP;
  controller->AllReduce(own.data(), values, count, operation);
}

double vtkShapeGather::CountOnce(
  vtkMultiProcessController* controller, const std::vector<Eigen::RowVector3d>& positions)
{
  std::vector<double> own;
  for (const Eigen::RowVector3d& position : positions)
  {
    own.insert(own.end(), position.begin(), position.end());
  }
  std::vector<vtkIdType> offsets;
  const std::vector<double> all = vtkShapeConcatenate::Concatenate(controller, own, offsets);
  // One process can have two points at one position: these count twice.
  std::map<std::array<double, 3>, double> counts;
  for (std::size_t process = 0; process + 1 < offsets.size(); ++process)
  {
    std::map<std::array<double, 3>, double> here;
    for (vtkIdType i = offsets[process]; i < offsets[process + 1]; i += 3)
    {
      ++here[{ all[i], all[i + 1], all[i + 2] }];
    }
    for (const auto& [position, count] : here)
    {
      counts[position] = std::max(counts[position], count);
    }
  }
  return std::accumulate(counts.begin(), counts.end(), 0.0,
    [](double sum, const auto& entry) { return sum + entry.second; });
}

vtkIdType vtkShapeGather::CountPoints(vtkDataObject* data, vtkMultiProcessController* controller)
{
  vtkIdType own = 0;
  for (vtkDataSet* leaf : vtkShapeComposite::Of(data))
  {
    own += leaf->GetNumberOfPoints();
  }
  vtkIdType sum = own;
  if (IsParallel(controller))
  {
    controller->AllReduce(&own, &sum, 1, vtkCommunicator::SUM_OP);
  }
  return sum;
}

// 1. Merge the blocks of this process.
// 2. Send them to process 0, which merges the pieces of all processes.
// 3. Broadcast the result, and the index in the result of each point of each piece.
// 4. Compose these indices with the indices of step 1.
vtkSmartPointer<vtkPolyData> vtkShapeGather::Gather(vtkDataObject* data, const std::string& name,
  Joined joined, vtkMultiProcessController* controller, std::vector<int>& ownPoints)
{
  vtkSmartPointer<vtkPolyData> whole;
  std::vector<vtkIdType> pointMap;
  RunOnAllOrFail(controller,
    [&]
    {
      const std::vector<vtkSmartPointer<vtkPolyData>> pieces = vtkShapeSurfaces::Of(data, name);
      whole = pieces.size() == 1 ? pieces[0] : Merge(pieces, joined, pointMap);
      if (pieces.size() == 1)
      {
        pointMap.resize(whole->GetNumberOfPoints());
        std::iota(pointMap.begin(), pointMap.end(), 0);
      }
    });
  if (IsParallel(controller))
  {
    std::vector<vtkSmartPointer<vtkDataObject>> received;
    controller->GetCommunicator()->Gather(whole.Get(), received, 0);
    std::vector<vtkIdType> mapOfAll;
    vtkNew<vtkPolyData> merged;
    const int rank = controller->GetLocalProcessId();
    RunOnAllOrFail(controller,
      [&]
      {
        if (rank == 0)
        {
          std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
          for (vtkDataObject* piece : received)
          {
            surfaces.push_back(vtkPolyData::SafeDownCast(piece));
          }
          merged->ShallowCopy(Merge(surfaces, joined, mapOfAll));
        }
      });
    controller->Broadcast(merged.Get(), 0);
    const vtkIdType count = whole->GetNumberOfPoints();
    std::vector<vtkIdType> counts(controller->GetNumberOfProcesses());
    controller->AllGather(&count, counts.data(), 1);
    mapOfAll.resize(std::accumulate(counts.begin(), counts.end(), vtkIdType(0)));
    controller->Broadcast(mapOfAll.data(), static_cast<vtkIdType>(mapOfAll.size()), 0);
    // The map has the points of all processes in the order of ranks.
    const vtkIdType first = std::accumulate(counts.begin(), counts.begin() + rank, vtkIdType(0));
    for (vtkIdType& point : pointMap)
    {
      point = mapOfAll[first + point];
    }
    whole = merged;
  }
  ownPoints.assign(pointMap.begin(), pointMap.end());
  return whole;
}

vtkSmartPointer<vtkUnstructuredGrid> vtkShapeGather::GatherGrid(
  vtkDataObject* data, vtkMultiProcessController* controller)
{
  vtkSmartPointer<vtkUnstructuredGrid> whole;
  RunOnAllOrFail(controller,
    [&]
    {
      std::vector<vtkSmartPointer<vtkUnstructuredGrid>> grids;
      std::vector<vtkDataSet*> pieces;
      for (vtkDataSet* leaf : vtkShapeComposite::Of(data))
      {
        grids.push_back(ToGrid(leaf));
        // A ghost cell belongs to another process, which sends it.
        grids.back()->RemoveGhostCells();
        grids.back()->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
        grids.back()->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
        pieces.push_back(grids.back());
      }
      whole = grids.size() == 1 ? grids.front() : Merge(pieces);
    });
  if (IsParallel(controller))
  {
    std::vector<vtkSmartPointer<vtkDataObject>> received;
    controller->GetCommunicator()->Gather(whole.Get(), received, 0);
    RunOnAllOrFail(controller,
      [&]
      {
        std::vector<vtkDataSet*> pieces;
        for (vtkDataObject* piece : received)
        {
          pieces.push_back(vtkDataSet::SafeDownCast(piece));
        }
        whole = Merge(pieces); // empty except on the first process
      });
    controller->Broadcast(whole.Get(), 0);
  }
  return whole;
}

/// The failure of the lowest rank counts; its message is sent to the others.
void vtkShapeGather::AgreeOnFailure(
  vtkMultiProcessController* controller, bool& failed, std::string& message)
{
  if (!IsParallel(controller))
  {
    return;
  }
  const int processes = controller->GetNumberOfProcesses();
  int own = failed ? controller->GetLocalProcessId() : processes;
  int first = processes;
  controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  failed = first < processes;
  if (failed)
  {
    int length = static_cast<int>(message.size());
    controller->Broadcast(&length, 1, first);
    message.resize(length);
    controller->Broadcast(message.data(), length, first);
  }
}
