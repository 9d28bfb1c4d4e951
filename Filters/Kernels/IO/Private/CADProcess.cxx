#include "IO/Private/CADProcess.h"

#include "Base/ChildMessages.h"
#include "Base/Errors.h"
#include "IO/Private/CADFaces.h"

namespace shape
{
namespace
{

template <class Mover>
void MoveNames(const Mover& mover, std::vector<std::string>& names)
{
  std::vector<char> each(names.size());
  mover.Move(each);
  names.resize(each.size());
  for (std::string& name : names)
  {
    MoveText(mover, name);
  }
}

template <class Mover, class Matrix>
void MoveMatrix(const Mover& mover, Matrix& matrix, Eigen::Index columns)
{
  std::vector<typename Matrix::Scalar> values(matrix.data(), matrix.data() + matrix.size());
  mover.Move(values);
  matrix = Eigen::Map<const Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, Eigen::Dynamic>>(
    values.data(), static_cast<Eigen::Index>(values.size()) / columns, columns);
}

template <class Mover>
void MoveModel(const Mover& mover, CADModel& model)
{
  MoveMatrix(mover, model.Surface.Points, 3);
  MoveMatrix(mover, model.Surface.Triangles, 3);
  MoveMatrix(mover, model.Patches, 1);
  MoveMatrix(mover, model.Regions, 1);
  std::vector<int> numbers;
  for (const CADEdge& edge : model.Edges)
  {
    numbers.push_back(edge.Number);
  }
  mover.Move(numbers);
  model.Edges.resize(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    model.Edges[i].Number = numbers[i];
    mover.Move(model.Edges[i].Points);
  }
  MoveNames(mover, model.PatchNames);
  MoveNames(mover, model.RegionNames);
  MoveText(mover, model.Unit);
  std::vector<double> lengths{ model.Deflection, model.Distance };
  mover.Move(lengths);
  model.Deflection = lengths[0];
  model.Distance = lengths[1];
}

} // namespace

CADModel RunCADProcess(std::string_view content, CADFormat format, const CADReaderOptions& options,
  const Progress& progress)
{
  progress(0.0);
  const CascadeReader read = LoadOpenCascade(); // here: it stays loaded for the next file
  ChildTask<CADModel> task;
  task.Compute = [&] { return JoinFaces(read(content, format, options)); };
  // OpenCASCADE does not say how far it is.
  task.UsualSeconds = 0.5 + 1e-6 * static_cast<double>(content.size());
  task.Library = "OpenCASCADE";
  task.Work = "reads the file";
  task.MemoryRemedy = "use a larger Deflection";
  task.CrashRemedy = "export the file again, perhaps in another format";
  return ComputeInChild(
    task, [](const auto& mover, CADModel& model) { MoveModel(mover, model); }, progress);
}

} // namespace shape
