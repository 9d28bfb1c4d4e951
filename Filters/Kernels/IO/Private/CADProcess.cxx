#include "IO/Private/CADProcess.h"

#include "Base/ChildMessages.h"
#include "Base/Errors.h"
#include "IO/Private/CADFaces.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <new>

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

/// The first message of the child: whether there is a model, and else the error.
enum class Outcome : char
{
  Model,
  InvalidInput,
  SolveFailure
};

void RunInChild(CascadeReader read, std::string_view content, CADFormat format,
  const CADReaderOptions& options, int pipe)
{
  std::vector<Outcome> outcome{ Outcome::Model };
  std::string message;
  CADModel model;
  try
  {
    model = JoinFaces(read(content, format, options));
  }
  catch (const InvalidInput& error)
  {
    outcome = { Outcome::InvalidInput };
    message = error.what();
  }
  catch (const std::bad_alloc&)
  {
    outcome = { Outcome::SolveFailure };
    message = "out of memory; use a larger Deflection";
  }
  catch (const std::exception& error)
  {
    outcome = { Outcome::SolveFailure };
    message = error.what();
  }
  const ChildSender sender{ pipe };
  sender.Move(outcome);
  MoveText(sender, message);
  MoveModel(sender, model);
}

} // namespace

CADModel RunCADProcess(std::string_view content, CADFormat format, const CADReaderOptions& options,
  const Progress& progress)
{
  progress(0.0);
  const CascadeReader read = LoadOpenCascade(); // here: it stays loaded for the next file
  ChildProcess child([&](int pipe) { RunInChild(read, content, format, options, pipe); });
  // OpenCASCADE does not say how far it is: half of it is done after the time that is usual.
  const double usual = 0.5 + 1e-6 * static_cast<double>(content.size());
  const auto start = std::chrono::steady_clock::now();
  const std::function<void()> waiting = [&]
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    progress(seconds.count() / (seconds.count() + usual));
  };
  const auto fail = [](int signal)
  {
    throw SolveFailure(signal == SIGKILL
        ? std::string("the process that reads the file was killed, probably because memory ran "
                      "out; use a larger Deflection")
        : "OpenCASCADE crashed (" +
          (signal > 0 ? std::string(strsignal(signal)) : "it ended without a result") +
          "); export the file again, perhaps in another format");
  };
  const ChildReceiver receiver{ child, waiting, fail };
  std::vector<Outcome> outcome;
  std::string message;
  receiver.Move(outcome);
  MoveText(receiver, message);
  if (outcome.front() == Outcome::InvalidInput)
  {
    throw InvalidInput(message);
  }
  if (outcome.front() == Outcome::SolveFailure)
  {
    throw SolveFailure(message);
  }
  CADModel model;
  MoveModel(receiver, model);
  progress(1.0);
  return model;
}

} // namespace shape
